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

/// Whether all can be written, each in a place of its own: asked before the work.
/// @param inputs  files that must not be written over
/// @throws UsageError for a place that is named twice or is an input, Error as check_writable()
void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs = {});

/// Writes text to a file, whole or not at all, or to standard output.
/// @throws Error if it cannot be written
void write_output(const std::string& path, const std::string& text);

}  // namespace hwffd::command
