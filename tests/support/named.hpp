#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <type_traits>

#include "hwffd/model/configuration.hpp"

namespace hwffd {

/// How GoogleTest names a configuration in a failure.
inline void PrintTo(const Configuration& row, std::ostream* out) { *out << row.name; }

namespace test {

/// The rows of the table for which that holds.
template <class Predicate>
std::vector<Configuration> rows_where(Predicate holds) {
  std::vector<Configuration> rows;
  std::copy_if(configurations().begin(), configurations().end(), std::back_inserter(rows), holds);
  return rows;
}

/// A text as a test may be called: basic-fx18-paper -> basic_fx18_paper.
inline std::string test_name(std::string text) {
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

/// The same of anything with a name, a member or a function.
template <class T>
auto test_name(const T& named) -> decltype(test_name(std::string(named.name))) {
  return test_name(std::string(named.name));
}

template <class T>
auto test_name(const T& named) -> decltype(test_name(named.name())) {
  return test_name(named.name());
}

/// The same of a combination: names with underlines between.
template <class First, class... Rest>
std::string test_name(const std::tuple<First, Rest...>& all) {
  return std::apply(
      [](const First& first, const Rest&... rest) {
        return (test_name(first) + ... + ("_" + test_name(rest)));
      },
      all);
}

/// For INSTANTIATE_TEST_SUITE_P: parameters by their names.
inline constexpr auto by_name = [](const auto& info) { return test_name(info.param); };

}  // namespace test
}  // namespace hwffd
