#pragma once

#include <string>
#include <vector>

namespace hwffd::command {

/// A file that a command is to write, and the option that names it. "-" is standard output; empty,
/// it is not asked for.
struct Output {
  const char* option;
  std::string path;
};

/// @param inputs  files that the output must not be written over; what is no file may be among them
/// @throws UsageError for one that is an input
void check_not_read(const Output& output, const std::vector<std::string>& inputs);

/// Whether all can be written, each in a place of its own: asked before the work.
/// @throws UsageError for a place that is named twice and as check_not_read(), Error as
///   check_writable()
void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs = {});

/// Writes text to a file, whole or not at all, or to standard output.
/// @throws Error if it cannot be written
void write_output(const std::string& path, const std::string& text);

}  // namespace hwffd::command
