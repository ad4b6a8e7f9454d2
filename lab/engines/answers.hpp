#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "hwffd/stream/beat.hpp"
#include "hwffd/stream/events.hpp"

namespace hwffd::engines {

/// What an engine, or the model, makes of a stream of commands.
struct Answers {
  std::vector<Beat> results;
  std::array<std::uint64_t, kStreamEvents> events{};
};

/// Files in a folder, which is made: results.txt, as recordings are, and events.txt, a count each.
void write_answers(const std::filesystem::path& folder, const Answers& answers);

}  // namespace hwffd::engines
