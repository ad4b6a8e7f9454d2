#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "described.hpp"
#include "hwffd/device/device.hpp"
#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/shape.hpp"
#include "hwffd/model/configuration.hpp"
#include "program.hpp"

namespace hwffd::command {
namespace {

constexpr const char* kCompletionExamples = R"(Examples:
  hwffd completion bash > ~/.local/share/bash-completion/completions/hwffd
  hwffd completion zsh > ~/.zfunc/_hwffd      (a folder of $fpath)
  hwffd completion fish > ~/.config/fish/completions/hwffd.fish
make hwffd PREFIX=FOLDER and packages put these files where the shells look.)";

using Words = std::vector<std::string>;

/// Those of the table of configurations, in its order.
Words formats() {
  Words names;
  for (const Configuration& row : configurations()) {
    if (std::find(names.begin(), names.end(), row.format) == names.end()) {
      names.emplace_back(row.format);
    }
  }
  return names;
}

/// Words that an option takes, where they are known; a file may stand in place of a shape.
Words values_of(const std::string& option) {
  if (option == "--device") {
    Words words = device_kinds();
    for (const std::string& kind : board_kinds()) {
      words.push_back(kind.substr(0, kind.find(':') + 1));
    }
    return words;
  }
  if (option == "--family") return Family::names();
  if (option == "--format") return formats();
  if (option == "--outside") return {"keep", "clamp", "fade:"};
  if (option != "--lattice") return {};
  Words names;
  for (const Shape& shape : shapes()) names.emplace_back(shape.name);
  return names;
}

std::string bash(const CLI::App& app) {
  std::string commands;
  for (const CLI::App* command : commands_of(app)) {
    Words words;
    for (const CLI::Option* option : options_of(*command)) {
      for (const std::string& name : names_of(*option)) words.push_back(name);
    }
    commands +=
        fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), fmt::join(words, " "));
  }
  std::string values;
  for (const std::string& option : distinct_options(app)) {
    const Words words = values_of(option);
    if (words.empty()) continue;
    values += fmt::format("    {}) words=\"{}\" ;;\n", option, fmt::join(words, " "));
  }
  Words names;
  for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
  return fmt::format(R"(_hwffd() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} words=
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W "{0}" -- "$word"))
    return
  fi
  case $before in
{1}  esac
  if [[ -z $words && $word == -* ]]; then
    case ${{COMP_WORDS[1]}} in
{2}    esac
  fi
  [[ -n $words ]] && COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _hwffd hwffd
)",
                     fmt::join(names, " "), values, commands);
}

/// A text between single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return result + "'";
}

/// A text as zsh has it in a specification, where brackets and colons have meanings.
std::string of_zsh(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh(const CLI::App& app) {
  std::string names;
  std::string commands;
  for (const CLI::App* command : commands_of(app)) {
    names += fmt::format("    {}\n",
                         quoted(command->get_name() + ":" + of_zsh(command->get_description())));
    commands += fmt::format("    {}) _arguments", command->get_name());
    for (const CLI::Option* option : options_of(*command)) {
      const std::string name = names_of(*option).back();
      const Words words = values_of(name);
      const std::string what =
          words.empty() ? "_files" : fmt::format("({})", fmt::join(words, " "));
      commands += fmt::format(" \\\n        {}",
                              quoted(fmt::format("*{}[{}]{}", name, of_zsh(summary_of(*option)),
                                                 takes_value(*option) ? ":value:" + what : "")));
    }
    commands += " \\\n        '*:file:_files' ;;\n";
  }
  return fmt::format(R"(#compdef hwffd
_hwffd() {{
  local -a commands
  commands=(
{0}  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT--))
  case $command in
{1}    *) _files ;;
  esac
}}
_hwffd "$@"
)",
                     names, commands);
}

std::string fish(const CLI::App& app) {
  std::string text = "complete -c hwffd -n __fish_use_subcommand -f\n";
  for (const CLI::App* command : commands_of(app)) {
    const std::string name = command->get_name();
    text += fmt::format("complete -c hwffd -n __fish_use_subcommand -a {} -d {}\n", name,
                        quoted(command->get_description()));
    for (const CLI::Option* option : options_of(*command)) {
      text += fmt::format("complete -c hwffd -n '__fish_seen_subcommand_from {}'", name);
      for (const std::string& spelling : names_of(*option)) {
        const bool is_long = spelling[1] == '-';
        text += fmt::format(" {} {}", is_long ? "-l" : "-s", spelling.substr(is_long ? 2 : 1));
      }
      const Words words = values_of(names_of(*option).back());
      if (takes_value(*option)) text += " -r";
      if (!words.empty()) text += fmt::format(" -a '{}'", fmt::join(words, " "));
      text += fmt::format(" -d {}\n", quoted(summary_of(*option)));
    }
  }
  return text;
}

using Script = std::string (*)(const CLI::App& app);
const std::map<std::string, Script> kShells{{"bash", bash}, {"zsh", zsh}, {"fish", fish}};

}  // namespace

Action add_completion(CLI::App& app) {
  const auto shell = std::make_shared<std::string>();
  app.add_option("shell", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember(kShells));
  app.footer(kCompletionExamples);
  return [shell, &app] {
    write_standard_output(kShells.at(*shell)(*app.get_parent()));
    return 0;
  };
}

}  // namespace hwffd::command
