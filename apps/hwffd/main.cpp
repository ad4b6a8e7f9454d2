// hwffd: free-form deformation of meshes and points, on the simulated hardware, its bit-true model
// or in double precision.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "hwffd/error.hpp"
#include "hwffd/version.h"
#include "program.hpp"

namespace {

using namespace hwffd;

constexpr std::size_t kLongestName = 30;

bool is_name(const std::string& word) {
  return !word.empty() && word.size() <= kLongestName && word.front() != '-' &&
         word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

/// Becomes the program hwffd-NAME for the command line `hwffd NAME WORD...`, as git does: the one
/// beside this program, else that on PATH. Returns if the first word is no name of such a program.
/// @throws UsageError if it is one, and the program is not there
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

int run(int argc, char** argv) {
  CLI::App app{"Free-form deformation of meshes, on hardware, its bit-true model or in double."};
  app.set_version_flag("--version", HWFFD_VERSION);
  app.require_subcommand(1);
  app.footer(
      "hwffd COMMAND --help shows the options of a command, with examples. hwffd core writes a "
      "core "
      "of one configuration, hwffd warp resamples a volume and hwffd register aligns two, where "
      "the "
      "Python package is installed; hwffd sim runs the simulated hardware, where "
      "make sim has built it; any other NAME runs the program hwffd-NAME.");
  std::vector<std::pair<CLI::App*, command::Action>> commands;
  const auto add = [&](const char* name, const char* help, command::Action (*options)(CLI::App&)) {
    CLI::App* command = app.add_subcommand(name, help);
    commands.emplace_back(command, options(*command));
  };
  add("deform", "move a mesh, or points, by deformed lattices", command::add_deform);
  add("view", "drag the points of a lattice in a window, the mesh follows", command::add_view);
  add("embed", "where vertices lie in a lattice, and how exactly", command::add_embed);
  add("fit", "find the lattice that takes vertices to given places", command::add_fit);
  add("lattice", "write a lattice file", command::add_lattice);
  add("check", "whether a lattice folds, and its volume", command::add_check);
  add("info", "what a file holds; without a file, what this build has", command::add_info);
  add("completion", "write what makes a shell complete the words of hwffd",
      command::add_completion);
  add("manual", "write the manual page", command::add_manual);
  const bool own =
      argc > 1 && std::any_of(commands.begin(), commands.end(),
                              [&](const auto& entry) { return entry.first->check_name(argv[1]); });
  if (!own) become_other_program(argv);
  parse_command_line(app, argc, argv);
  for (const auto& [command, action] : commands) {
    if (command->parsed()) return action();
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd", [&] { return run(argc, argv); });
}
