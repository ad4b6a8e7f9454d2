#pragma once

#include <cstdint>
#include <string>

namespace hwffd::cores {

/// A signal inside a Verilated core that its build has made visible (public_flat_rd and
/// public_flat_rw of a control file). A word of up to 64 bits, or as many words of 32.
struct Signal {
  std::string instance;  ///< hierarchical name, from the top module's on
  std::string name;
  int width = 1;
  int bytes = 1;         ///< of its storage
  void* data = nullptr;  ///< valid as long as the core

  /// One of its bits, from 0 on.
  bool bit(int place) const { return (byte(place) >> (place % 8) & 1) != 0; }
  /// Its value, of a wide one the lowest 64 bits.
  std::uint64_t value() const {
    std::uint64_t value = 0;
    const int count = bytes < 8 ? bytes : 8;
    for (int i = 0; i < count; ++i) {
      value |= std::uint64_t{static_cast<const std::uint8_t*>(data)[i]} << (8 * i);
    }
    return value;
  }
  /// Sets a bit of a signal that may be written.
  void set(int place) const {
    static_cast<std::uint8_t*>(data)[place / 8] |= static_cast<std::uint8_t>(1U << (place % 8));
  }

 private:
  std::uint8_t byte(int place) const { return static_cast<const std::uint8_t*>(data)[place / 8]; }
};

}  // namespace hwffd::cores
