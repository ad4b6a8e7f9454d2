#include "scatter_stimulus.hpp"

#include <algorithm>

#include "hwffd/stream/blending.hpp"
#include "stimulus.hpp"

namespace hwffd::test {
namespace {

constexpr std::array<int, 3> kNoDims{};

constexpr auto word_of(Opcode opcode) { return static_cast<std::uint32_t>(opcode); }

std::vector<Beat> with_bits(std::vector<Beat> packet, int word, std::uint32_t bits) {
  packet[0].words[word] ^= bits;
  return packet;
}

}  // namespace

std::array<std::uint32_t, 3> random_gradient(tb::Random& random) {
  std::array<std::uint32_t, 3> gradient;
  const std::uint64_t size = random.below(20);
  for (std::uint32_t& word : gradient) {
    word = static_cast<std::uint32_t>(static_cast<std::int32_t>(random.word()) >> size);
    if (random.chance(0.01)) word = random.pick({0x80000000U, 0x7FFFFFFFU});
  }
  return gradient;
}

std::vector<GradientBeats> random_gradients(const WordCodec& codec, tb::Random& random,
                                            const std::array<int, 3>& dims, std::size_t count,
                                            bool stray) {
  std::vector<GradientBeats> vertices;
  for (const VertexBeat& vertex : random_vertices(codec, random, dims, count, stray)) {
    vertices.push_back({vertex, random_gradient(random)});
  }
  return vertices;
}

Gradients gradients_to(const std::array<int, 3>& dims, bool begin) {
  Gradients how;
  how.dims = dims;
  how.begin = begin;
  return how;
}

std::vector<Beat> random_grid_packet(tb::Random& random, int page, const Grid& grid,
                                     const Gradients& how) {
  std::vector<std::array<std::uint32_t, 3>> gradients(vertex_count(grid));
  for (auto& gradient : gradients) gradient = random_gradient(random);
  return gradients_packet(page, grid, gradients, how);
}

Grid small_grid(tb::Random& random, const std::array<int, 3>& dims) {
  std::array<double, 3> first, last;
  std::array<int, 3> count;
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = dims[axis] - 3;
    first[axis] = random.chance(0.2) ? 0 : random.unit() * cells;
    last[axis] = random.chance(0.2) ? cells : random.unit() * cells;
    count[axis] = static_cast<int>(random.between(1, 3));
  }
  return grid_between(first, last, count, 0);
}

Grid long_rows(tb::Random& random, const std::array<int, 3>& dims, int most) {
  const double cells = dims[0] - 3;
  const double first = random.chance(0.2) ? 0 : random.unit() * cells;
  const double last = random.chance(0.2)   ? cells
                      : random.chance(0.1) ? first
                                           : random.unit() * cells;
  Grid grid = small_grid(random, dims);
  const auto count = static_cast<int>(random.between(1, static_cast<std::uint64_t>(most)));
  const Grid along = grid_between({first, 0, 0}, {last, 0, 0}, {count, 1, 1});
  grid.start[0] = along.start[0];
  grid.step[0] = along.step[0];
  grid.count[0] = along.count[0];
  return grid;
}

std::vector<Grid> rows_of(const Grid& grid) {
  std::vector<Grid> rows;
  for (int c = 0; c < grid.count[2]; ++c) {
    for (int b = 0; b < grid.count[1]; ++b) {
      Grid row = grid;
      row.start[1] += static_cast<std::uint64_t>(b * grid.step[1]);
      row.start[2] += static_cast<std::uint64_t>(c * grid.step[2]);
      row.count[1] = row.count[2] = 1;
      rows.push_back(row);
    }
  }
  return rows;
}

Opcode opcode_of(const std::vector<Beat>& packet) {
  return static_cast<Opcode>(packet[0].words[0] & 0xFF);
}

bool is_of_scatter(const std::vector<Beat>& packet) {
  const Opcode opcode = opcode_of(packet);
  return opcode == Opcode::kGradients || opcode == Opcode::kCollect;
}

std::vector<Beat> sized(std::vector<Beat> packet, std::size_t beats) {
  packet.back().last = false;
  packet.resize(beats);
  packet.back().last = true;
  return packet;
}

std::vector<Beat> ScatterPackets::any(int packets) {
  std::vector<Beat> beats;
  for (int p = 0; p < packets; ++p) {
    append(beats, random_.chance(0.05)   ? random_packets(codec_, random_, 1)
                  : random_.chance(0.15) ? spoil(any_packet())
                                         : any_packet());
  }
  return beats;
}

std::vector<Beat> ScatterPackets::any_packet() {
  // Now and then a page beyond the last.
  const int page = static_cast<int>(
      random_.below(static_cast<std::uint64_t>(pages_) + (random_.chance(0.05) ? 3 : 0)));
  switch (random_.below(10)) {
    case 0:
      return functions();
    case 1:
    case 2:
      return collect(page);
    case 3:
    case 4:
    case 5:
      return grid(page);
    default:
      return vertices(page);
  }
}

std::vector<Beat> ScatterPackets::functions() {
  const Functions which = random_.chance(0.8) ? Functions::kDerivativesToo : Functions::kBlending;
  if (random_.chance(0.3)) {
    return coefficients_packet(random_coefficients(codec_, random_), which);
  }
  const auto name = random_.pick({"bspline", "bernstein", "catmull-rom", "linear"});
  return coefficients_packet(family(name, codec_), codec_, which);
}

Gradients ScatterPackets::how(int page) {
  Gradients how;
  const bool known = page < pages_ && dims_[static_cast<std::size_t>(page)] != kNoDims;
  how.begin = random_.chance(0.15);
  if (known && !random_.chance(how.begin ? 0.5 : 0.05)) {
    how.dims = dims_[static_cast<std::size_t>(page)];
  } else {
    for (int& points : how.dims) points = static_cast<int>(random_.between(4, 7));
    // One axis as long as the core takes it, or all.
    if (random_.chance(0.2))
      how.dims[random_.below(3)] = axis_ - static_cast<int>(random_.below(3));
    if (random_.chance(0.03)) how.dims = {axis_, axis_, axis_};
    if (random_.chance(0.1)) how.dims[random_.below(3)] = random_.pick({0, 3, axis_ + 1, 255});
  }
  if (page < pages_ && near_lattice(how.dims) == how.dims) {
    dims_[static_cast<std::size_t>(page)] = how.dims;
  }
  how.along = static_cast<int>(random_.below(4));
  how.mode = random_.chance(0.7) ? OutsideMode::kClamp : OutsideMode::kBlank;
  return how;
}

/// Points an axis of some lattice, where these are of none.
std::array<int, 3> ScatterPackets::near_lattice(std::array<int, 3> dims) const {
  for (int& points : dims) points = std::clamp(points, 4, axis_);
  return dims;
}

std::vector<Beat> ScatterPackets::vertices(int page) {
  const Gradients gradients = how(page);
  auto some =
      random_gradients(codec_, random_, near_lattice(gradients.dims), random_.between(1, 12), true);
  for (GradientBeats& vertex : some) {
    if (random_.chance(0.05)) vertex.cell[random_.below(3)] = static_cast<int>(random_.below(32));
  }
  return gradients_packet(page, some, gradients);
}

std::vector<Beat> ScatterPackets::grid(int page) {
  const Gradients gradients = how(page);
  const std::array<int, 3> dims = near_lattice(gradients.dims);
  Grid grid = random_.chance(0.3) ? long_rows(random_, dims, 40) : small_grid(random_, dims);
  if (random_.chance(0.03)) grid.count[random_.below(3)] = 0;
  if (random_.chance(0.05)) grid.start[random_.below(3)] = random_.bits() >> random_.below(24);
  if (random_.chance(0.05)) {
    grid.step[random_.below(3)] = static_cast<std::int64_t>(random_.bits()) >> random_.below(24);
  }
  return random_grid_packet(random_, page, grid, gradients);
}

std::vector<Beat> ScatterPackets::collect(int page) {
  Collect how;
  how.shift = static_cast<int>(random_.below(4));
  how.tag = static_cast<std::uint16_t>(random_.word());
  how.count = random_.chance(0.3);
  how.interrupt = random_.chance(0.3);
  if (page < pages_) dims_[static_cast<std::size_t>(page)] = kNoDims;
  return collect_packet(page, how);
}

std::vector<Beat> ScatterPackets::spoil(std::vector<Beat> packet) {
  if (random_.chance(0.6)) return spoiled(std::move(packet), random_);
  return with_bits(std::move(packet), static_cast<int>(random_.below(4)), 1U << random_.below(32));
}

Beat ScatterPackets::garbage_header() {
  Beat header = {{random_.word(), random_.word(), random_.word(), random_.word()}, false};
  if (random_.chance(0.1)) return header;
  constexpr std::uint32_t kGradients = word_of(Opcode::kGradients);
  constexpr std::uint32_t kCollect = word_of(Opcode::kCollect);
  header.words[0] = random_.pick({word_of(Opcode::kCoefficients), kGradients, kGradients,
                                  kGradients, kCollect, kCollect}) |
                    static_cast<std::uint32_t>(random_.below(3)) << 8;
  if (random_.chance(0.4)) header.words[0] |= kGridGradientsFlag;
  if (random_.chance(0.3)) header.words[0] |= kBeginFlag;
  header.words[1] = static_cast<std::uint32_t>(random_.below(4)) |
                    static_cast<std::uint32_t>(random_.below(3)) << 16;
  if (random_.chance(0.7)) header.words[1] &= 0xFFFF;
  header.words[2] = random_.pick({0x040404U, 0x040405U, 0x2040404U}) |
                    static_cast<std::uint32_t>(random_.below(4)) << 26;
  header.words[3] = static_cast<std::uint32_t>(random_.below(3));
  if (random_.chance(0.4)) header.words[3] = 0;
  if ((header.words[0] & 0xFF) == kCollect) {
    header.words[0] &= 0x3FF;
    header.words[1] = 0;
    header.words[2] &= 3;
  }
  if (random_.chance(0.15)) header.words[random_.below(4)] ^= 1U << random_.below(32);
  return header;
}

std::vector<Beat> ScatterPackets::garbage(int packets) {
  std::vector<Beat> beats;
  for (int p = 0; p < packets; ++p) {
    beats.push_back(garbage_header());
    for (std::uint64_t more = random_.below(random_.chance(0.1) ? 30 : 9); more > 0; --more) {
      beats.push_back({{random_.word(), random_.word(), random_.word(), random_.word()}, false});
      // Now and then a place that may be in a cell or a grid.
      if (random_.chance(0.4)) beats.back().words = {random_.word() >> 1, 0, 0, 0};
    }
    beats.back().last = true;
  }
  return beats;
}

std::vector<BadGradients> bad_gradients(const WordCodec& codec, tb::Random& random,
                                        const std::array<int, 3>& dims, int axis, int pages) {
  constexpr unsigned kRefusedGrid = stream_event(event::kGridCount);
  constexpr unsigned kOtherPoints = stream_event(event::kPagePoints);
  const auto count_of = [](std::size_t number) { return static_cast<std::uint32_t>(number); };
  const auto vertices = random_gradients(codec, random, dims, 4);
  const std::vector<Beat> some = gradients_packet(0, vertices, gradients_to(dims));
  const Grid grid = small_grid(random, dims);
  const std::vector<Beat> of_grid = random_grid_packet(random, 0, grid, gradients_to(dims));
  std::vector<BadGradients> bad;

  const auto refused = [&](const std::string& name, const std::vector<Beat>& packet,
                           unsigned code) {
    bad.push_back({name, packet, {{code, 0}}});
    bad.push_back({name + ", longer", sized(packet, packet.size() + 3), {{code, 0}}});
    bad.push_back({name + ", a header", sized(packet, 1), {{code, 0}}});
  };
  // Every opcode that is none of the three, and some beyond the last.
  for (std::uint32_t opcode : {0U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, kOpcodes + 1, 26U, 255U}) {
    refused("opcode " + std::to_string(opcode),
            with_bits(some, 0, word_of(Opcode::kGradients) ^ opcode), event::kUnknownOpcode);
  }
  for (int bit = 16; bit < 32; ++bit) {
    const std::uint32_t flag = 1U << bit;
    if ((flag & (kGridGradientsFlag | kBeginFlag)) == 0) {
      refused("flag", with_bits(some, 0, flag), event::kUnknownOpcode);
    }
    if ((flag & (kCountFlag | kInterruptFlag)) == 0) {
      refused("flag of a collect", with_bits(collect_packet(0), 0, flag), event::kUnknownOpcode);
    }
    refused("word 3 of a grid", with_bits(of_grid, 3, flag), event::kUnknownOpcode);
    refused("word 3 of a collect", with_bits(collect_packet(0), 3, flag), event::kUnknownOpcode);
  }
  for (int bit = 0; bit < 32; ++bit) {
    const std::uint32_t flag = 1U << bit;
    refused("word 3", with_bits(some, 3, flag), event::kUnknownOpcode);
    refused("word 1 of a collect", with_bits(collect_packet(0), 1, flag), event::kUnknownOpcode);
    if (bit == 24 || bit >= 28) {
      refused("word 2", with_bits(some, 2, flag), event::kUnknownOpcode);
    }
    if (bit > 1) {
      refused("word 2 of a collect", with_bits(collect_packet(0), 2, flag), event::kUnknownOpcode);
    }
  }
  refused("mode 3", with_bits(some, 2, 3U << 24), event::kUnknownOpcode);

  for (const int page : {pages, 255}) {
    refused("page", gradients_packet(page, vertices, gradients_to(dims)), event::kNoLattice);
    refused("page", random_grid_packet(random, page, grid, gradients_to(dims)), event::kNoLattice);
    refused("page", collect_packet(page), event::kNoLattice);
  }
  refused("nothing to collect", collect_packet(pages - 1), event::kNoLattice);
  for (int a = 0; a < 3; ++a) {
    for (const int points : {0, 3, axis + 1, 255}) {
      std::array<int, 3> wrong = dims;
      wrong[a] = points;
      refused("points", gradients_packet(0, vertices, gradients_to(wrong)), event::kLatticeSize);
      refused("points", gradients_packet(0, vertices, gradients_to(wrong, true)),
              event::kLatticeSize);
    }
    std::array<int, 3> other = dims;
    other[a] += 1;
    refused("others", gradients_packet(0, vertices, gradients_to(other)), kOtherPoints);
    refused("others", random_grid_packet(random, 0, grid, gradients_to(other)), kOtherPoints);
  }

  for (const auto& whole : {some, of_grid}) {
    for (std::size_t beats = 1; beats < whole.size(); ++beats) {
      bad.push_back({"short", sized(whole, beats), {{event::kPacketShort, count_of(beats - 1)}}});
    }
    for (const std::size_t more : {1, 4}) {
      bad.push_back({"long",
                     sized(whole, whole.size() + more),
                     {{event::kPacketLong, count_of(whole.size())}}});
    }
  }
  for (const std::size_t beats : {1, 2, 7}) {
    std::vector<Beat> none = sized(some, beats);
    none[0].words[1] = 0;
    bad.push_back({"no vertices", none, {{event::kPacketShort, 0}}});
  }
  for (int a = 0; a < 3; ++a) {
    for (const bool empty : {false, true}) {
      Grid wrong = grid;
      if (empty) {
        wrong.count[a] = 0;
      } else {
        wrong.start[a] = (static_cast<std::uint64_t>(dims[a] - 3) << kGridFraction) + (1U << 16);
      }
      const auto packet = random_grid_packet(random, 0, wrong, gradients_to(dims));
      for (const std::size_t beats : {4U, 5U, 11U}) {
        bad.push_back({"grid", sized(packet, beats), {{kRefusedGrid, 3}}});
      }
      for (const std::size_t beats : {1U, 2U, 3U}) {
        bad.push_back(
            {"grid, short", sized(packet, beats), {{event::kPacketShort, count_of(beats - 1)}}});
      }
    }
  }
  for (const OutsideMode mode : {OutsideMode::kClamp, OutsideMode::kBlank}) {
    Gradients how = gradients_to(dims);
    how.mode = mode;
    for (int a = 0; a < 3; ++a) {
      for (const std::uint32_t word : {0x80000001U, 0xBFFFFFFFU, 0xC0000000U, 0xFFFFFFFFU}) {
        auto stray = vertices;
        stray[1].local[a] = word;
        bad.push_back(
            {"coordinate", gradients_packet(0, stray, how), {{event::kCoordinateOutside, 4}}});
        stray[2].cell[a] = dims[a] - 3;
        bad.push_back({"cell and coordinate",
                       gradients_packet(0, stray, how),
                       {{event::kCoordinateOutside, 4}, {event::kCellOutside, 6}}});
      }
      auto stray = vertices;
      stray[3].cell[a] = 15;
      bad.push_back({"cell", gradients_packet(0, stray, how), {{event::kCellOutside, 8}}});
      bad.push_back({"cut", sized(gradients_packet(0, stray, how), 8), {{event::kPacketShort, 7}}});
    }
  }
  return bad;
}

}  // namespace hwffd::test
