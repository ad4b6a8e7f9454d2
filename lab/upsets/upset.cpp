#include "upset.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hwffd/error.hpp"

namespace hwffd::upsets {
namespace {

Upset in_memory(const std::vector<Design::Memory>& memories, std::uint64_t bit) {
  Upset upset;
  upset.memory = true;
  for (const Design::Memory& memory : memories) {
    const std::uint64_t own = std::uint64_t{memory.width} * memory.depth;
    if (bit < own) {
      upset.word = static_cast<std::uint32_t>(bit / memory.width);
      upset.bit = static_cast<std::uint16_t>(bit % memory.width);
      return upset;
    }
    bit -= own;
    ++upset.place;
  }
  throw Error("a bit beyond the memories");
}

}  // namespace

std::uint64_t Design::memory_bits() const {
  std::uint64_t bits = 0;
  for (const Memory& memory : memories) bits += std::uint64_t{memory.width} * memory.depth;
  return bits;
}

const std::string& Design::name(const Upset& upset) const {
  return upset.memory ? memories[upset.place].name : registers[upset.place].name;
}

const std::string& Design::module(const Upset& upset) const {
  return upset.memory ? memories[upset.place].module : registers[upset.place].module;
}

std::vector<Upset> Design::draw(bool memory, std::size_t count, std::uint64_t clocks,
                                std::uint64_t seed) const {
  tb::Random random(tb::derive_seed(seed, memory ? 1 : 0));
  const std::uint64_t bits = memory ? memory_bits() : registers.size();
  if (bits == 0 || clocks == 0) throw Error("there is no bit, or no clock, to choose from");
  std::vector<Upset> upsets(count);
  for (Upset& upset : upsets) {
    const std::uint64_t bit = random.below(bits);
    if (memory) {
      upset = in_memory(memories, bit);
    } else {
      upset.place = static_cast<std::size_t>(bit);
    }
    upset.clock = random.below(clocks);
  }
  std::stable_sort(upsets.begin(), upsets.end(),
                   [](const Upset& a, const Upset& b) { return a.clock < b.clock; });
  return upsets;
}

Upset Design::parse(const std::string& text) const {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos) throw Error(text + ": expected NAME@CLOCK");
  std::string own = text.substr(0, at);
  Upset upset;
  upset.clock = std::stoull(text.substr(at + 1));
  const std::size_t word = own.find(':');
  if (word != std::string::npos) {
    const std::size_t bit = own.rfind(':');
    upset.memory = true;
    upset.word = static_cast<std::uint32_t>(std::stoul(own.substr(word + 1)));
    upset.bit = static_cast<std::uint16_t>(std::stoul(own.substr(bit + 1)));
    own.resize(word);
  }
  const std::size_t places = upset.memory ? memories.size() : registers.size();
  for (; upset.place < places; ++upset.place) {
    if (name(upset) == own) return upset;
  }
  throw Error(text + ": there is no such bit");
}

Design read_design(const std::string& path) {
  std::ifstream file(path);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (json.is_discarded()) throw Error(path + ": cannot be read");
  Design design;
  for (const auto& bit : json.at("registers")) design.registers.push_back({bit[0], bit[1]});
  for (const auto& memory : json.at("memories")) {
    design.memories.push_back(
        {memory.at("name"), memory.at("module"), memory.at("width"), memory.at("depth")});
  }
  return design;
}

const char* outcome_name(Outcome outcome) {
  constexpr const char* kNames[] = {"no_effect",  "flagged",        "silent", "hang_cleared",
                                    "hang_stuck", "outside_window", "other"};
  return kNames[static_cast<std::size_t>(outcome)];
}

}  // namespace hwffd::upsets
