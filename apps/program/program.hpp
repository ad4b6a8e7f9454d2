#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace hwffd {

/// Reads the command line into the options of `app`. `--help` and `--version` print and
/// end the program with 0.
/// @throws UsageError for what CLI11 refuses
void parse_command_line(CLI::App& app, int argc, char** argv);

/// Writes text to standard output.
/// @throws Error if it cannot be written, whole
void write_standard_output(const std::string& text);

/// What main() returns: the body's exit status, or after an exception that of the Error, else 1,
/// with one line on standard error that begins with the program's name. Output that standard output
/// does not take is an Error too.
int run_program(const std::string& name, const std::function<int()>& body);

/// What a program that reports ends with: status 0 where nothing is wrong, else 1, and what is
/// wrong, a line each, on standard error.
int conclude(const std::string& faults);

/// "[done/all] rows" on one line of standard error, where that is a terminal; gone when all are
/// done.
void show_rows_done(std::size_t done, std::size_t all);

/// "name  42 %" on one line of standard error, where that is a terminal; gone when all is done.
void show_progress(const std::string& name, double done);

/// The same with how many things are done in a second: "name  42 %, 1.3 M vertices/s".
class RatedProgress {
 public:
  /// @param count  of things in all
  RatedProgress(std::string name, double count, std::string things);
  void operator()(double done) const;

 private:
  std::string name_;
  double count_;
  std::string things_;
  std::chrono::steady_clock::time_point begun_;
};

}  // namespace hwffd
