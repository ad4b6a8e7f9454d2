#pragma once

#include <functional>
#include <string>
#include <vector>

namespace hwffd {

/// A reader of text from outside.
struct Target {
  const char* name;
  std::vector<std::string> corpus;
  /// Reads the input. Returns if it is valid, after a check of what it means (expect()); throws
  /// hwffd::Error if not.
  std::function<void(const std::string& input)> read;
};

/// Every one that a program covers: targets.cpp under sanitizers, mesh_targets.cpp without. A new
/// one is a line there, in fuzz.py and in CMakeLists.txt.
std::vector<Target> targets();

/// Throws std::logic_error, which is no way to refuse an input, unless `holds`.
void expect(bool holds, const char* what);

}  // namespace hwffd
