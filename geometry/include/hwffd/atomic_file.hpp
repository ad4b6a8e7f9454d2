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
/// last. An older file of the same name stays whole until it is replaced, and leaves its owner, as
/// far as the system allows, and its mode to the new one. A link is followed. A device or pipe
/// (/dev/null) and what is open in this process (/dev/stdout, /dev/fd/3, be it a file) are not
/// replaced: they get their bytes, behind those that are there, before the files.
///
/// Signals that end a program wait, in this thread, while there are temporary files.
/// @throws Error as check_writable, or if a file cannot be created, written in full or renamed; no
///   temporary is left.
void write_files(const std::vector<FileContent>& files);

/// Whether write_files() could begin, for who wants to know before the work.
/// @throws Error for a folder, a file that is read-only (for root too), a folder that is not there
///   or takes no files, and a link that leads round in a circle
void check_writable(const std::filesystem::path& path);

}  // namespace hwffd
