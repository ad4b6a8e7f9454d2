#pragma once

#include <vector>

#include "hwffd/stream/beat.hpp"
#include "hwffd/stream/opcodes.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd {

constexpr std::size_t kBeatBytes = 16;  // on a line, and in memory

/// A packet among others in a row of beats, which it does not own.
struct Packet {
  const Beat* beats;    ///< its header, and what follows
  std::size_t count;    ///< of these beats
  std::size_t results;  ///< beats that come back
};

/// What one vertex of a packet is: beats of it, and of its results; 0 in a packet without vertices.
struct VertexShare {
  std::size_t beats = 0;
  std::size_t results = 0;
};

/// Of packets that StreamDevice sends: without flags.
inline VertexShare vertex_share(const Beat& header) {
  const auto results =
      static_cast<std::size_t>(results_of(static_cast<Results>(header.words[2] >> 8 & 3)));
  switch (static_cast<Opcode>(header.words[0] & 0xFF)) {
    case Opcode::kVertices:
    case Opcode::kPageVertices:
      return {1, results};
    case Opcode::kInterleaved:
      return {kVertexBeats, results};
    default:
      return {};
  }
}

inline std::vector<Packet> packets_of(const std::vector<Beat>& commands) {
  std::vector<Packet> packets;
  for (std::size_t first = 0; first < commands.size();) {
    std::size_t end = first;
    while (!commands[end++].last) continue;
    const VertexShare share = vertex_share(commands[first]);
    const std::size_t count = end - first;
    packets.push_back({&commands[first], count,
                       share.beats == 0 ? 0 : (count - 1) / share.beats * share.results});
    first = end;
  }
  return packets;
}

}  // namespace hwffd
