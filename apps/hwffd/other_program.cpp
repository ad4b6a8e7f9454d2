#include "other_program.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

#include "hwffd/error.hpp"

namespace hwffd::command {
namespace {

constexpr std::size_t kLongestName = 30;

bool is_name(const std::string& word) {
  return !word.empty() && word.size() <= kLongestName && word.front() != '-' &&
         word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

}  // namespace

void become_other_program(char** argv) {
  const std::string name = argv[1] == nullptr ? "" : argv[1];
  if (!is_name(name)) return;
  std::string program = "hwffd-" + name;
  char** words = argv + 1;
  words[0] = program.data();
  std::error_code unknown;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (!unknown) ::execv((self.parent_path() / program).c_str(), words);
  if (unknown || errno == ENOENT) ::execvp(program.c_str(), words);
  if (errno != ENOENT) {
    throw Error(fmt::format("{}: {} cannot be run: {}", name, program, std::strerror(errno)));
  }
  throw UsageError(fmt::format(
      "{}: no such command, and no program {} beside hwffd or on PATH; see --help", name, program));
}

}  // namespace hwffd::command
