#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <string>

#include "commands.hpp"
#include "described.hpp"
#include "hwffd/version.h"
#include "program.hpp"

namespace hwffd::command {
namespace {

constexpr const char* kExamples = R"(Examples:
  hwffd manual | man -l -
make hwffd PREFIX=FOLDER and packages put it where man looks.)";

/// A text in the language of man: what begins its lines or follows a backslash has a meaning.
std::string troff(const std::string& text) {
  std::string result;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
    begins = c == '\n';
  }
  return result;
}

std::string option_text(const CLI::Option& option) {
  std::string names = "\\fB" + troff(fmt::format("{}", fmt::join(names_of(option), ", "))) + "\\fR";
  const std::string type = option.get_type_name();
  if (takes_value(option) && !type.empty()) names += fmt::format(" \\fI{}\\fR", troff(type));
  return fmt::format(".TP\n{}\n{}\n", names, troff(option.get_description()));
}

std::string command_text(const CLI::App& command) {
  std::string text = fmt::format(".SS hwffd {}\n{}\n", troff(command.get_name()),
                                 troff(command.get_description()));
  for (const CLI::Option* option : command.get_options(
           [](const CLI::Option* candidate) { return !candidate->nonpositional(); })) {
    text += fmt::format(".TP\n\\fI{}\\fR\n{}\n", troff(option->get_name(true)),
                        troff(option->get_description()));
  }
  for (const CLI::Option* option : options_of(command)) text += option_text(*option);
  return text + fmt::format(".PP\n.nf\n{}\n.fi\n", troff(command.get_footer()));
}

std::string manual(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH HWFFD 1 \"\" \"hwffd {}\" \"User Commands\"\n.SH NAME\nhwffd \\- free-form deformation "
      "of "
      "meshes, points and lattices\n.SH SYNOPSIS\n.B hwffd\n.I COMMAND\n[\\fIOPTION\\fR]...\n"
      ".SH DESCRIPTION\n{}\n{}\n.SH COMMANDS\n",
      HWFFD_VERSION, troff(app.get_description()), troff(app.get_footer()));
  for (const CLI::App* command : commands_of(app)) text += command_text(*command);
  return text +
         ".SH \"EXIT STATUS\"\n0 if all went well; 1 if something could not be done, which one "
         "line on "
         "standard error names; 2 for a command line that is wrong.\n";
}

}  // namespace

Action add_manual(CLI::App& app) {
  app.footer(kExamples);
  return [&app] {
    write_standard_output(manual(*app.get_parent()));
    return 0;
  };
}

}  // namespace hwffd::command
