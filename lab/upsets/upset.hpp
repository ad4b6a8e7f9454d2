#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/tb/random.hpp"

namespace hwffd::upsets {

/// One bit that is inverted: of a register at a rising edge, or of a word of a memory.
struct Upset {
  std::uint64_t clock = 0;  ///< of the traffic, from 0 on
  bool memory = false;
  std::size_t place = 0;  ///< bit of upset_register, or of upset_memory
  std::uint32_t word = 0;
  std::uint16_t bit = 0;
};

/// What netlist.py says of the bits of a core.
struct Design {
  struct Register {
    std::string name, module;
  };
  struct Memory {
    std::string name, module;
    std::uint32_t width, depth;
  };
  std::vector<Register> registers;  ///< a bit each
  std::vector<Memory> memories;

  std::uint64_t memory_bits() const;
  const std::string& name(const Upset& upset) const;
  const std::string& module(const Upset& upset) const;
  /// Each (bit, clock) as likely as any other; in the order of their clocks.
  std::vector<Upset> draw(bool memory, std::size_t count, std::uint64_t clocks,
                          std::uint64_t seed) const;
  /// NAME@CLOCK, or NAME:WORD:BIT@CLOCK of a memory. Throws Error where there is no such bit.
  Upset parse(const std::string& text) const;
};

/// Throws Error.
Design read_design(const std::string& path);

/// What became of it.
enum class Outcome : std::uint8_t {
  kNoEffect,
  kFlagged,        ///< an event, a status or an error response tells of it
  kSilent,         ///< results differ, and nothing tells
  kHangCleared,    ///< it does not come to rest; the reset of the core ends that
  kHangStuck,      ///< it does not, or nothing is right after it
  kOutsideWindow,  ///< an address of a write outside the window went out
  kOther           ///< results are right, a rule of a bus was broken
};
const char* outcome_name(Outcome outcome);

struct Verdict {
  Outcome outcome = Outcome::kNoEffect;
  bool recovered = true;      ///< after the reset of the core results are right again
  bool restarted = true;      ///< after aresetn they are
  bool outside_read = false;  ///< an address of a read outside the window went out
};

/// Asked before each rising edge of the core.
class Trigger {
 public:
  virtual ~Trigger() = default;
  /// The bit to be inverted at this edge; null: none.
  virtual const Upset* due() = 0;
  /// Clocks in between are those of the traffic.
  virtual void open() = 0;
  virtual void close() = 0;
};

/// Inverts nothing, and counts the clocks.
class Counter final : public Trigger {
 public:
  const Upset* due() override {
    if (open_) ++clocks;
    return nullptr;
  }
  void open() override { open_ = true; }
  void close() override { open_ = false; }
  std::uint64_t clocks = 0;

 private:
  bool open_ = false;
};

}  // namespace hwffd::upsets
