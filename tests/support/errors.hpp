#pragma once

#include <gtest/gtest.h>

#include <string>
#include <typeinfo>

#include "hwffd/error.hpp"

namespace hwffd {

/// The message of the exception of type E that f throws; fails the test if there is none, if it is
/// of another type, or if it has more than one line.
template <typename E, typename F>
std::string message_of(F f) {
  try {
    f();
  } catch (const E& error) {
    std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_EQ(typeid(error), typeid(E)) << text;
    return text;
  }
  ADD_FAILURE() << "no exception";
  return "";
}

/// Checks that text contains part.
inline void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in '" << text << "'";
}

/// What a statement that must be refused says, or a part of it.
#define EXPECT_ERROR(statement, text) EXPECT_EQ(message_of<Error>([&] { statement; }), text)
#define EXPECT_ERROR_PART(statement, part) expect_part(message_of<Error>([&] { statement; }), part)
#define EXPECT_USAGE_ERROR(statement, text) \
  EXPECT_EQ(message_of<UsageError>([&] { statement; }), text)
#define EXPECT_USAGE_ERROR_PART(statement, part) \
  expect_part(message_of<UsageError>([&] { statement; }), part)

}  // namespace hwffd
