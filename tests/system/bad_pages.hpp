#pragma once

#include <string>
#include <vector>

#include "bad_packets.hpp"
#include "page_stimulus.hpp"

namespace hwffd::test {

/// A bad packet, and its one event.
struct BadPage {
  std::string name;
  std::vector<Beat> packet;
  Code code;
  std::uint64_t count = 1;  ///< how often; three times: it has three blank results
};

/// Bad packets for a core that has that lattice of 5 x 4 x 6 points in page 1 only, without a
/// fourth component; those of vertices have the three given.
std::vector<BadPage> bad_pages(const WordCodec& codec, const LatticeWords& lattice,
                               const std::vector<VertexBeat>& vertices, const PageCore& core);

}  // namespace hwffd::test
