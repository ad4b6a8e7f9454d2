#include "bad_packets.hpp"

#include <fmt/format.h>

#include "hwffd/stream/blending.hpp"

namespace hwffd::test {

std::vector<BadPacket> bad_packets(const WordCodec& codec, tb::Random& random,
                                   const LatticeWords& lattice) {
  const auto vertices = [&](std::size_t count) {
    return random_vertices(codec, random, lattice.dims, count);
  };
  const std::vector<Beat> loads = lattice_packet(lattice), some = vertices_packet(vertices(5));
  std::vector<BadPacket> bad;
  const auto header = [&](std::vector<Beat> packet, int word, std::uint32_t value, Code code) {
    packet[0].words[word] = value;
    bad.push_back({fmt::format("word {} is {:x}", word, value), packet, code, 0});
  };
  header(some, 0, 0x77, kUnknownOpcode);
  header(vertices_packet(vertices(1)), 1, 0, kPacketShort);
  for (const std::uint32_t dimensions : {0x040403U, 0x040304U, 0x110404U, 0xFF0404U, 0U}) {
    header(loads, 2, dimensions, kLatticeSize);
  }
  const auto sized = [&](std::vector<Beat> packet, std::size_t beats, Code code, std::size_t beat) {
    packet.back().last = false;
    packet.resize(beats);
    packet.back().last = true;
    bad.push_back({fmt::format("{} beats", beats), packet, code, static_cast<std::uint32_t>(beat)});
  };
  for (const auto& whole : {loads, some, coefficients_packet(watertight_bspline(codec), codec)}) {
    for (const std::size_t beats : {std::size_t{1}, std::size_t{2}, whole.size() - 1}) {
      sized(whole, beats, kPacketShort, beats - 1);
    }
  }
  for (const auto& whole : {loads, some}) sized(whole, whole.size() + 3, kPacketLong, whole.size());
  // Of the second of three vertices.
  const auto coordinate = [&](int axis, std::uint32_t word, OutsideMode mode, Code code,
                              std::uint32_t status) {
    std::vector<VertexBeat> stray = vertices(3);
    stray[1].local[axis] = word;
    bad.push_back({fmt::format("coordinate {:x}, mode {}", word, static_cast<int>(mode)),
                   vertices_packet(stray, mode), code, 2, status});
  };
  if (codec.is_float()) {
    for (const std::uint32_t word : {0x7FC00000U, 0xFF800001U, 0x7F800000U, 0xFF800000U}) {
      coordinate(0, word, OutsideMode::kClamp, kCoordinateNan, kStatusNan);
    }
  }
  using Words = std::vector<std::uint32_t>;
  for (const std::uint32_t word : codec.is_float() ? Words{0x3F800001U, 0xBF800000U, 0x80000001U}
                                                   : Words{0x80000001U, 0xFFFFFFFFU}) {
    for (const OutsideMode mode : {OutsideMode::kClamp, OutsideMode::kBlank}) {
      const std::uint32_t clamped = mode == OutsideMode::kClamp ? kStatusClamped : 0U;
      coordinate(2, word, mode, kCoordinateOutside, kStatusOutside | clamped);
    }
  }
  return bad;
}

}  // namespace hwffd::test
