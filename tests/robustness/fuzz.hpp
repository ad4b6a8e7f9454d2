#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace hwffd {

/// A reader of text from outside.
struct Target {
  const char* name;
  std::uint64_t inputs;  ///< how many it gets in a run; HWFFD_FUZZ_TIMES multiplies them
  std::vector<std::string> corpus;
  /// Reads the input. Returns if it is valid, after a check of what it means (expect()); throws
  /// hwffd::Error if not.
  std::function<void(const std::string& input)> read;
};

/// For the names of tests.
inline void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

/// Throws std::logic_error, which is no way to refuse an input, unless `holds`.
void expect(bool holds, const char* what);

/// What became of the inputs of a run.
struct Tally {
  std::uint64_t valid = 0;
  std::uint64_t refused = 0;
  std::vector<std::string> failures;  ///< each with what repeats it; a run ends after 20
};

/// Gives the target mutations of its corpus, `inputs` of them, each with a seed of its own. An
/// input fails that is neither valid nor refused with an Error of one printable line of at most 500
/// characters. A crash or an input that takes over 20 seconds ends the program; it then says which
/// input it was.
/// @param first number of the first input: any input can be repeated by itself
Tally fuzz(const Target& target, std::uint64_t seed, std::uint64_t first, std::uint64_t inputs);

}  // namespace hwffd
