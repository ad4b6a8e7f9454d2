#include "study_program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "hwffd/atomic_file.hpp"
#include "program.hpp"

namespace hwffd {
namespace {

int conclude_study(const Findings& findings, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::vector<FileContent> files;
  for (const StudyReport& report : findings.reports) {
    files.push_back({folder / (report.name + ".json"), report.json});
  }
  write_files(files);
  for (const FileContent& file : files) fmt::print("wrote {}\n", file.path.string());
  return conclude(findings.faults);
}

}  // namespace

StudyProgram::StudyProgram(const std::string& what, int argc, char** argv)
    : argc_(argc), argv_(argv), app_(std::make_unique<CLI::App>(what)) {
  app_->add_option("--output", output_, "folder for reports")->capture_default_str();
}

StudyProgram::~StudyProgram() = default;

void StudyProgram::number(const std::string& option, std::int64_t& value, const std::string& what,
                          std::int64_t least, std::int64_t most) {
  app_->add_option(option, value, what)->check(CLI::Range(least, most))->capture_default_str();
}

void StudyProgram::seed(std::uint64_t& value, const std::string& of_what) {
  app_->add_option("--seed", value, "seed of " + of_what)->capture_default_str();
}

int StudyProgram::run(const std::function<Findings()>& measure) {
  parse_command_line(*app_, argc_, argv_);
  return conclude_study(measure(), std::filesystem::path(output_) / "reports");
}

int run_study(const std::string& name, const std::string& what, int argc, char** argv,
              const std::function<int(StudyProgram& program)>& body) {
  return run_program(name, [&] {
    StudyProgram program(what, argc, argv);
    return body(program);
  });
}

}  // namespace hwffd
