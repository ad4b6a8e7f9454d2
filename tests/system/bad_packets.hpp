#pragma once

#include <string>
#include <vector>

#include "hwffd/stream/events.hpp"
#include "stimulus.hpp"

namespace hwffd::test {

using namespace event;  // NOLINT: codes of errors are words of these tests

/// A packet with one thing wrong, and what is said of it.
struct BadPacket {
  std::string name;
  std::vector<Beat> packet;
  Code code;
  std::uint32_t beat;        ///< of the packet, that of the error
  std::uint32_t status = 0;  ///< of its second result, where it has one with a status
};

/// Bad packets of every kind but one, a cell outside, for a core that has coefficients and that
/// lattice.
std::vector<BadPacket> bad_packets(const WordCodec& codec, tb::Random& random,
                                   const LatticeWords& lattice);

}  // namespace hwffd::test
