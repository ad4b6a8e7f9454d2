// hwffd: free-form deformation of meshes and points, on the simulated hardware, its bit-true model
// or in double precision.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "hwffd/version.h"
#include "other_program.hpp"
#include "program.hpp"

namespace {

using namespace hwffd;

int run(int argc, char** argv) {
  CLI::App app{"Free-form deformation of meshes, on hardware, its bit-true model or in double."};
  app.set_version_flag("--version", HWFFD_VERSION);
  app.require_subcommand(1);
  app.footer(
      "hwffd COMMAND --help shows the options of a command, with examples. hwffd warp resamples a "
      "volume, where the Python package is installed; hwffd sim runs the simulated hardware, where "
      "make sim has built it; any other NAME runs the program hwffd-NAME.");
  std::vector<std::pair<CLI::App*, command::Action>> commands;
  const auto add = [&](const char* name, const char* help, command::Action (*options)(CLI::App&)) {
    CLI::App* command = app.add_subcommand(name, help);
    commands.emplace_back(command, options(*command));
  };
  add("deform", "move a mesh, or points, by deformed lattices", command::add_deform);
  add("view", "drag the points of a lattice in a window, the mesh follows", command::add_view);
  add("embed", "where vertices lie in a lattice, and how exactly", command::add_embed);
  add("lattice", "write a lattice file", command::add_lattice);
  add("check", "whether a lattice folds, and its volume", command::add_check);
  add("info", "what a file holds; without a file, what this build has", command::add_info);
  add("completion", "write what makes a shell complete the words of hwffd",
      command::add_completion);
  add("manual", "write the manual page", command::add_manual);
  const bool own =
      argc > 1 && std::any_of(commands.begin(), commands.end(),
                              [&](const auto& entry) { return entry.first->check_name(argv[1]); });
  if (!own) command::become_other_program(argv);
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
