#pragma once

#include <string>
#include <vector>

#include "climb.hpp"

namespace hwffd::certified {

/// What was found of the weights of an axis in a format.
struct WeightsFact {
  std::string weights;  ///< a family by Horner's rule, "powers", "affine"
  std::string format;
  double weight = 0;       ///< the largest |w_l - B_l| found
  std::uint32_t word = 0;  ///< at this coordinate
  double error = 0;        ///< the largest sum_l |w_l - B_l| found
  double distance = 0;     ///< no sum over three axes is larger; 0: not looked for
  double reached = 0;      ///< some such sum has this
  double pair = 0;         ///< no sum |round(w_l w_m) - B_l B_m| over two axes is larger; or 0
  double bend = 0;         ///< what lies between the coordinates looked at: to be added to `error`
  std::int64_t coordinates = 0;
  bool all = false;  ///< every coordinate was looked at
};

/// What was found of a form: a vertex.
struct FormFact {
  std::string form;
  std::string format;
  Witness witness;
};

struct Facts {
  std::vector<WeightsFact> weights;
  std::vector<FormFact> forms;
};

/// What to look for, and how long.
struct Effort {
  std::string form;    ///< or all, where empty
  std::string format;  ///< the same
  std::int64_t starts = 0;
  std::int64_t steps = 0;
  bool all = true;  ///< every coordinate of wide formats, and all triples
};

Facts find_facts(const Effort& effort);

std::string json_facts(const Facts& facts);

}  // namespace hwffd::certified
