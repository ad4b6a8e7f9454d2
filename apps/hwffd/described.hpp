#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hwffd::command {

/// What a program says of itself, for shells that complete its words and for its manual.
std::vector<const CLI::App*> commands_of(const CLI::App& app);
/// Of a command, those that have a name with dashes.
std::vector<const CLI::Option*> options_of(const CLI::App& command);
/// "-o" and "--output": short ones first.
std::vector<std::string> names_of(const CLI::Option& option);
/// Long names of the options of all commands, each once.
std::vector<std::string> distinct_options(const CLI::App& app);
bool takes_value(const CLI::Option& option);
/// The beginning of its description, up to the first bracket, colon, comma or semicolon.
std::string summary_of(const CLI::Option& option);

}  // namespace hwffd::command
