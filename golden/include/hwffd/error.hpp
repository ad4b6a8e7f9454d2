#pragma once

#include <stdexcept>
#include <string>

#include "hwffd/excerpt.hpp"

namespace hwffd {

/// A failure that the user can cure. what() is one line (one_line()) that names the thing and the
/// cure; a command prints it and ends with exit_status().
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& text) : std::runtime_error(one_line(text)) {}
  virtual int exit_status() const { return 1; }
};

/// The command line or an option was wrong.
class UsageError : public Error {
 public:
  using Error::Error;
  int exit_status() const override { return 2; }
};

}  // namespace hwffd
