// Made from the forms of organizations.py by tools/tables/generated_files.py; changes are lost.
#pragma once

namespace hwffd {

// clang-format off
/// How an organization computes eq. (1), which decides what it rounds.
enum class Form {
  kProduct,   ///< the sum of ((B_l B_m) B_n) P
  kFactored,  ///< one axis after the other
  kAffine,    ///< the same, of functions that sum to one, by differences of points
};

/// Whether it takes one axis after the other.
constexpr bool contracts(Form form) {
  return form == Form::kFactored || form == Form::kAffine;
}

/// Whether it takes for granted that the functions of an axis sum to one.
constexpr bool completes(Form form) {
  return form == Form::kAffine;
}
// clang-format on

}  // namespace hwffd
