#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hwffd {

/// A file to be written: where, and all of its bytes.
struct FileContent {
  std::filesystem::path path;
  std::string bytes;
};

/// Writes all files or none. Each goes to a temporary file beside its target first; only when all
/// are complete are they renamed, in the order given, so put the file that refers to the others
/// last. An older file of the same name stays whole until it is replaced. A link is followed. A
/// device or pipe (/dev/stdout, /dev/null) is not replaced: it gets its bytes before the renaming.
/// @throws Error if a file cannot be created, written in full or renamed; no temporary is left.
void write_files(const std::vector<FileContent>& files);

}  // namespace hwffd
