#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace hwffd {

/// A report that a study writes.
struct StudyReport {
  std::string name;
  std::string json;
};

/// What a study ends with.
struct Findings {
  std::vector<StudyReport> reports;
  std::string faults;  ///< what does not hold, a line each; empty if all does
};

/// The program of a study, inside `run_study`: it measures and writes its reports to
/// <output>/reports/NAME.json, from which lab/figures prints tables and draws. It ends with 1
/// where something does not hold.
class StudyProgram {
 public:
  /// @param what  it does, for its help
  StudyProgram(const std::string& what, int argc, char** argv);
  ~StudyProgram();
  StudyProgram(const StudyProgram&) = delete;
  StudyProgram& operator=(const StudyProgram&) = delete;

  /// For options of other kinds than those below.
  CLI::App& app() { return *app_; }

  /// An option "--name" that takes a number between two others, given by its default.
  void number(const std::string& option, std::int64_t& value, const std::string& what,
              std::int64_t least, std::int64_t most);
  /// "--seed"
  void seed(std::uint64_t& value, const std::string& of_what);

  /// Reads the command line, measures and writes. The exit status.
  int run(const std::function<Findings()>& measure);

 private:
  int argc_;
  char** argv_;
  std::string output_ = "build";
  std::unique_ptr<CLI::App> app_;
};

/// What main() of a study returns.
/// @param name  of the program
/// @param what  it does, for its help
/// @param body  adds its options and ends with StudyProgram::run; whatever it throws becomes a line
///              and an exit status, as in run_program
int run_study(const std::string& name, const std::string& what, int argc, char** argv,
              const std::function<int(StudyProgram& program)>& body);

}  // namespace hwffd
