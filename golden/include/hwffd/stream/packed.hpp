#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {

/// 1.0 as a packed coordinate, and the most that one can be, which is outside.
constexpr std::uint32_t kPackedOne = 0x10000;
constexpr std::uint32_t kPackedMost = 0x1FFFF;

/// A vertex in 64 bits, of any format. docs/interface.md section 2.
struct PackedVertex {
  std::array<std::uint32_t, 3> local{};  ///< s, t, u, times 2^16, up to `kPackedMost`
  std::array<int, 3> cell{};             ///< i, j, k, 0 to 15 each
};

/// The packed vertex nearest to one in the words of a format: coordinates in [0, 1], rounded to
/// 16 bits. Its tag is not kept.
/// @throws std::invalid_argument for a cell beyond 15
PackedVertex packed(const VertexBeat& vertex, const WordCodec& codec);

/// The vertex that the core makes of number `n` of a packet: its tag is that number.
VertexBeat unpacked(const PackedVertex& vertex, std::size_t n, const WordCodec& codec);

/// As 64 bits, and back; bit 63 is for the caller.
std::uint64_t packed_bits(const PackedVertex& vertex);
PackedVertex vertex_of_bits(std::uint64_t bits);

/// What stands in the second half of a packet's last beat where there is no vertex.
constexpr std::uint64_t kNoPackedVertex = ~std::uint64_t{0};

/// Of a core with packed vertices: their packet of the resident lattice, two a beat.
std::vector<Beat> packed_packet(const std::vector<PackedVertex>& vertices,
                                OutsideMode mode = OutsideMode::kClamp,
                                Results results = Results::kPosition);

/// The same of a page, in a core with pages, too.
/// @throws std::invalid_argument with `how.large`, or unless the page is 0 to 255
std::vector<Beat> page_packed_packet(int page, const std::vector<PackedVertex>& vertices,
                                     const PageVertices& how = {});

}  // namespace hwffd
