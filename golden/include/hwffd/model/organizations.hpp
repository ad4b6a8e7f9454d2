#pragma once

#include <vector>

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/form.hpp"

namespace hwffd {

/// What the formulas of rtl/organizations.csv name, in clocks but for `n`.
struct ClockTerms {
  double n;      ///< control points a step
  double poly;   ///< of a polynomial in the paper's unit times: 6, with fused units 3
  double add;    ///< of an addition behind a multiplication in these: 1, with fused units 0
  double start;  ///< between polynomials of one evaluator when steps overlap: 1, iterative 3
};

/// One row of rtl/organizations.csv. A formula may be missing: a null pointer.
struct Organization {
  using Clocks = double (*)(const ClockTerms&);

  const char* name;
  int number;          ///< in the register CONFIG
  const char* module;  ///< RTL, with the parameters that make it this organization
  int n;               ///< the one N that it has; 0: the rows choose
  Form form;
  int fold;           ///< how often its units are used for one vertex
  int lanes;          ///< vertices that are evaluated side by side
  bool jacobian;      ///< whether a pass gives the position and its three derivatives
  bool walks;         ///< whether vertices of a row along s share what comes before s
  bool pairs;         ///< whether two of them that are neighbours in a cell are taken at once
  Clocks paper;       ///< of a vertex at the paper's schedule
  Clocks last;        ///< of the last accumulation, which that formula does not count
  Clocks overlapped;  ///< between vertices when steps overlap
  const char* overlapped_text;  ///< that formula as the table has it
};

/// Every row of the table, in its order.
const std::vector<Organization>& organization_table();

/// That of a row. Throws std::invalid_argument where there is none of its name.
const Organization& organization_of(const Configuration& row);

}  // namespace hwffd
