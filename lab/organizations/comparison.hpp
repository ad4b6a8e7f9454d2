#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "measure.hpp"
#include "operators.hpp"

namespace hwffd::organizations {

/// One row of the table of configurations, measured.
struct Row {
  const Configuration* configuration;
  Measurement measured;
  OperatorCount count;
  double vertices_per_s = 0;  ///< simulated, timed alone
};

/// The rows of this build, measured, and which of them are one organization at two schedules.
class Comparison {
 public:
  /// @param reference_vertices_per_s  of eq. (1) in software, in the same run
  Comparison(std::vector<Row> rows, double reference_vertices_per_s);

  const std::vector<Row>& rows() const { return rows_; }
  double reference_vertices_per_s() const { return reference_vertices_per_s_; }
  /// The row of the same organization, N, format and fusing at a schedule; the first, if there are
  /// several; null if there is none.
  const Row* partner(const Row& row, const std::string& schedule) const;

  /// The formula's clocks at the paper's schedule; nothing if the paper lacks the organization.
  std::optional<double> formula(const Row& row) const;
  /// Those counted, of the partner at the paper's schedule; nothing if there is none.
  std::optional<VertexClocks> paper_clocks(const Row& row) const;
  /// Whether both are equal, and vertices follow each other at that distance.
  std::optional<bool> equal(const Row& row) const;
  /// Clocks between vertices: of an overlapped row its own, else its partner's.
  std::optional<double> overlapped_interval(const Row& row) const;
  /// Those of the formula.
  std::optional<double> overlapped_formula(const Row& row) const;
  /// Whether both are equal.
  std::optional<bool> overlapped_equal(const Row& row) const;

 private:
  const Row* overlapped(const Row& row) const;

  std::vector<Row> rows_;
  double reference_vertices_per_s_;
};

using Progress = std::function<void(std::size_t done, std::size_t all)>;

/// Measures rows, several at a time, those with most units first; then times the reference and each
/// row, one after the other on one thread.
Comparison compare(const std::vector<const Configuration*>& rows,
                   const std::map<std::string, OperatorCount>& operators, const Effort& effort,
                   const Progress& progress);

}  // namespace hwffd::organizations
