#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace hwffd::bfp {
namespace {

double largest_error(const std::vector<Result>& results) {
  double largest = 0;
  for (const Result& r : results) largest = std::max(largest, r.of_lattice);
  return largest;
}

/// Whether every row gave the model's bits, and those of the other rows of its form.
bool identical(const Agreement& a) {
  return a.vertices > 0 && a.mismatches == 0 && a.disagreements == 0;
}

bool identical(const std::vector<Agreement>& agreements) {
  return !agreements.empty() && std::all_of(agreements.begin(), agreements.end(),
                                            [](const Agreement& a) { return identical(a); });
}

std::string text_of(const Agreement& a) {
  return fmt::format(
      "{} rows in the {} form, {} vertices each: {} results differ from the model's, {} from "
      "those of {}",
      a.rows.size(), a.form, a.vertices, a.mismatches, a.disagreements, a.rows.front());
}

}  // namespace

std::string json_report(const std::vector<Result>& results,
                        const std::vector<Agreement>& agreements) {
  nlohmann::ordered_json errors = nlohmann::ordered_json::array();
  for (const Result& r : results) {
    errors.push_back({{"points", r.points},
                      {"form", r.form},
                      {"max_error_ulp", r.of_lattice},
                      {"max_error_ulp_of_support", r.of_support},
                      {"bound_ulp", r.bound},
                      {"vertices", r.vertices}});
  }
  nlohmann::ordered_json forms = nlohmann::ordered_json::array();
  for (const Agreement& a : agreements) {
    forms.push_back({{"form", a.form},
                     {"rows", a.rows},
                     {"vertices", a.vertices},
                     {"mismatches", a.mismatches},
                     {"disagreements", a.disagreements}});
  }
  return nlohmann::ordered_json{{"max_error_ulp", largest_error(results)},
                                {"vertices", results.empty() ? 0 : results.front().vertices},
                                {"organizations_identical", identical(agreements)},
                                {"errors", std::move(errors)},
                                {"organizations", std::move(forms)}}
             .dump(2) +
         "\n";
}

std::string faults(const std::vector<Result>& results, const std::vector<Agreement>& agreements) {
  std::string text;
  for (const Result& r : results) {
    if (r.vertices > 0 && r.of_lattice <= r.bound) continue;
    text += fmt::format("{}, {}: error {} ulp over {} vertices, {} is proved\n", r.points, r.form,
                        r.of_lattice, r.vertices, r.bound);
  }
  if (agreements.empty()) text += "no rows compared\n";
  for (const Agreement& a : agreements) {
    if (!identical(a)) text += text_of(a) + "\n";
  }
  return text;
}

}  // namespace hwffd::bfp
