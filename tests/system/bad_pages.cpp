#include "bad_pages.hpp"

#include "hwffd/model/stream_model.hpp"

namespace hwffd::test {
namespace {

/// A packet with other bits in a word of its header.
std::vector<Beat> header(std::vector<Beat> packet, int word, std::uint32_t bits,
                         std::uint32_t clear = 0) {
  packet[0].words[word] = (packet[0].words[word] & ~clear) | bits;
  return packet;
}

std::vector<Beat> alone(std::vector<Beat> packet) {
  packet.resize(1);
  packet.back().last = true;
  return packet;
}

/// Pages and points that are not there.
void add_places(std::vector<BadPage>& bad, const LatticeWords& lattice,
                const std::vector<VertexBeat>& vertices, const PageCore& core) {
  const auto of_page = [&](int page) { return page_vertices_packet(page, vertices); };
  const auto part = [&](int page, std::size_t first, std::size_t count) {
    return points_packet(page, lattice, first, count);
  };
  bad.push_back({"vertices of a page that is not loaded", of_page(0), kNoLattice, 3});
  bad.push_back({"vertices of a page beyond the last", of_page(core.pages), kNoLattice, 3});
  bad.push_back({"vertices of page 255", of_page(255), kNoLattice, 3});
  bad.push_back({"a page beyond the last", page_packet(core.pages, lattice), kNoLattice});
  bad.push_back({"points of a page beyond the last", part(core.pages, 0, 2), kNoLattice});
  bad.push_back({"points of a page that is not loaded", part(0, 0, 2), kPagePoints});
  bad.push_back({"a part beyond the end", header(part(1, 118, 2), 1, 3, 2), kPagePoints});
  bad.push_back({"a place beyond the end", header(part(1, 0, 1), 2, 120), kPagePoints});
  bad.push_back({"a count of 32 bits", header(part(1, 0, 2), 1, 0xFFFFFFFF), kPagePoints});
  bad.push_back({"a count of 20 bits", header(part(1, 1, 2), 1, 0x80000, 0xFF), kPagePoints});
  bad.push_back({"no points", alone(header(part(1, 0, 1), 1, 0, 0xFF)), kPacketShort});
  bad.push_back({"a header of points alone", alone(part(1, 0, 1)), kPacketShort});
  bad.push_back(
      {"a header of vertices alone", alone(header(of_page(1), 0, kEveryFlag)), kPacketShort});
}

/// Flags, and bits that mean nothing.
void add_strangers(std::vector<BadPage>& bad, const std::vector<Beat>& load,
                   const std::vector<Beat>& part, const std::vector<Beat>& of_page) {
  bad.push_back({"a flag of another opcode", header(load, 0, kEveryFlag), kUnknownOpcode});
  bad.push_back({"flag P", header(of_page, 0, 1U << 18), kUnknownOpcode});
  bad.push_back({"bit 31 of flags", header(part, 0, 1U << 31), kUnknownOpcode});
  bad.push_back({"L for points", header(part, 0, kLargeFlag), kUnknownOpcode});
  bad.push_back({"a bit of word 2", header(load, 2, 1U << 24), kUnknownOpcode});
  bad.push_back({"a bit of word 2 of points", header(part, 2, 1U << 18), kUnknownOpcode});
  bad.push_back({"a bit of word 2 of vertices", header(of_page, 2, 4), kUnknownOpcode});
  bad.push_back({"a bit of word 3", header(of_page, 3, 1U << 10), kUnknownOpcode});
  bad.push_back({"bit 31 of word 3", header(load, 3, 1U << 31), kUnknownOpcode});
}

}  // namespace

std::vector<BadPage> bad_pages(const WordCodec& codec, const LatticeWords& lattice,
                               const std::vector<VertexBeat>& vertices, const PageCore& core) {
  const std::vector<Beat> load = page_packet(1, lattice);
  const std::vector<Beat> part = points_packet(1, lattice, 0, 1);
  const std::vector<Beat> of_page = page_vertices_packet(1, vertices);
  std::vector<BadPage> bad;
  add_places(bad, lattice, vertices, core);
  add_strangers(bad, load, part, of_page);
  bad.push_back({"dimensions", header(load, 2, 0x030405, 0xFFFFFF), kLatticeSize});
  if (codec.is_block()) {
    bad.push_back({"another exponent", header(part, 3, 0x155, 0x3FF), kPagePoints});
  }
  for (const std::uint32_t flag : {kCountFlag, kInterruptFlag}) {
    bad.push_back({"R or I of a part", header(part, 0, flag), kUnknownOpcode});
    bad.push_back({"R or I of a page", header(load, 0, flag), kUnknownOpcode});
    if ((core.features & model::kMarksFeature) != 0) continue;
    bad.push_back({"R or I of vertices", header(of_page, 0, flag), kUnknownOpcode});
  }
  bad.push_back({"H of a part", header(part, 0, kHalfFlag), kUnknownOpcode});
  bad.push_back({"H of a page", header(load, 0, kHalfFlag), kUnknownOpcode});
  if ((core.features & model::kHalvesFeature) == 0) {
    bad.push_back({"H of vertices", header(of_page, 0, kHalfFlag), kUnknownOpcode});
  }
  const Code none = (core.features & model::kFourthFeature) != 0 ? kNoFourth : kUnknownOpcode;
  bad.push_back({"fourth component of points", header(part, 0, kFourthFlag), none});
  bad.push_back({"fourth component of vertices", header(of_page, 0, kFourthFlag), none});
  bad.push_back({"fourth component of no lattice",
                 header(page_vertices_packet(0, vertices), 0, kFourthFlag), none});
  if ((core.features & model::kLargeFeature) == 0) {
    bad.push_back({"flag L", header(load, 0, kLargeFlag), kUnknownOpcode});
  }
  return bad;
}

}  // namespace hwffd::test
