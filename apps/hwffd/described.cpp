#include "described.hpp"

#include <CLI/CLI.hpp>
#include <set>

namespace hwffd::command {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->nonpositional(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> distinct_options(const CLI::App& app) {
  std::set<std::string> names;
  for (const CLI::App* command : commands_of(app)) {
    for (const CLI::Option* option : options_of(*command)) names.insert(names_of(*option).back());
  }
  return {names.begin(), names.end()};
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::string summary_of(const CLI::Option& option) {
  const std::string& text = option.get_description();
  const std::string first = text.substr(0, text.find_first_of("(:;,"));
  return first.substr(0, first.find_last_not_of(' ') + 1);
}

}  // namespace hwffd::command
