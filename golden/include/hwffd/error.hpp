#pragma once

#include <stdexcept>

namespace hwffd {

/// A failure that the user can cure. what() is one line that names the thing and the cure; a
/// command prints it and ends with exit_status().
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  virtual int exit_status() const { return 1; }
};

/// The command line or an option was wrong.
class UsageError : public Error {
 public:
  using Error::Error;
  int exit_status() const override { return 2; }
};

}  // namespace hwffd
