#include "stimulus.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/mesh/mesh.hpp"

namespace hwffd::test {
namespace {

std::uint32_t corner_coordinate(const WordCodec& codec, tb::Random& random) {
  if (!codec.is_float()) {
    return random.pick({0x00000000U, 0x00000001U, 0x00002000U, 0x40000000U, 0x7FFFE000U,
                        0x7FFFFFFFU, 0x80000000U, 0x80000001U, 0xBFFFFFFFU, 0xC0000000U,
                        0xFFFFFFFFU});
  }
  return random.pick({0x00000000U, 0x00000001U, 0x007FFFFFU, 0x00800000U, 0x33800000U, 0x3F000000U,
                      0x3F7FFFFFU, 0x3F800000U, 0x3F800001U, 0x80000000U, 0xBF800000U});
}

/// Uniform in [-2^exponent, 2^exponent).
std::uint32_t random_point(const WordCodec& codec, tb::Random& random, int exponent) {
  return codec.point(std::ldexp(2 * random.unit() - 1, exponent));
}

std::uint32_t extreme_word(const WordCodec& codec, tb::Random& random) {
  if (!codec.is_float()) {
    return random.pick({0x80000000U, 0x80000001U, 0x7FFFFFFFU, 0x7FFFE000U, 0x00000001U,
                        0xFFFFFFFFU, 0x00000000U, 0x00001FFFU});
  }
  return random.pick({0x7F7FFFFFU, 0xFF7FFFFFU, 0x7F800000U, 0xFF800000U, 0x7FC00000U, 0xFF800001U,
                      0x00000001U, 0x80000001U, 0x007FFFFFU, 0x80000000U, 0x7E800000U,
                      0xFE800000U});
}

/// Where points share an exponent, one of some: middling, with subnormal points, with the largest.
int random_exponent(const WordCodec& codec, tb::Random& random) {
  return codec.is_block() ? random.pick({0, 3, -20, -130, 128}) : 0;
}

InterleavedVertex extreme_vertex(const WordCodec& codec, tb::Random& random, int exponent) {
  InterleavedVertex vertex = random_vertex(codec, random, exponent);
  const double share = random.pick({0.01, 0.1, 1.0});
  for (std::uint32_t& word : vertex.points) {
    if (random.chance(share)) word = extreme_word(codec, random);
  }
  for (std::uint32_t& word : vertex.local) {
    if (random.chance(0.2)) word = extreme_word(codec, random);
  }
  return vertex;
}

InterleavedVertex corner_vertex(const WordCodec& codec, tb::Random& random, int exponent) {
  InterleavedVertex vertex = random_vertex(codec, random, exponent);
  for (std::uint32_t& word : vertex.local) word = corner_coordinate(codec, random);
  return vertex;
}

std::vector<InterleavedVertex> mesh_vertices(const WordCodec& codec, std::size_t count,
                                             std::uint64_t seed) {
  const Index3 dims{5, 7, 6};
  static const Mesh mesh = Mesh::procedural();
  const Box box = Box::around(mesh.positions());
  const Lattice twisted = Deformation::parse("twist:90").apply(box.lattice(dims));
  const auto rows = static_cast<Eigen::Index>(count);
  const auto first = static_cast<Eigen::Index>(seed * 97) % (mesh.positions().rows() - rows);
  const Points part = mesh.positions().middleRows(first, rows);
  return interleave(twisted, box.embed(dims, part), codec, Normalization::of(twisted, codec));
}

}  // namespace

const std::vector<std::string>& stimulus_names() {
  static const std::vector<std::string> names{"corner", "extreme", "random", "mesh"};
  return names;
}

InterleavedVertex random_vertex(const WordCodec& codec, tb::Random& random, int exponent) {
  InterleavedVertex vertex;
  vertex.exponent = exponent;
  for (std::uint32_t& word : vertex.local) word = codec.coordinate(random.unit());
  for (int& cell : vertex.cell) cell = static_cast<int>(random.below(16));
  for (std::uint32_t& word : vertex.points) word = random_point(codec, random, exponent);
  return vertex;
}

std::vector<InterleavedVertex> make_stimulus(const std::string& name, const WordCodec& codec,
                                             std::size_t count, std::uint64_t seed) {
  if (name == "mesh") return mesh_vertices(codec, count, seed);
  tb::Random random(seed);
  const int exponent = random_exponent(codec, random);
  std::vector<InterleavedVertex> vertices;
  for (std::size_t v = 0; v < count; ++v) {
    if (name == "corner") {
      vertices.push_back(corner_vertex(codec, random, exponent));
    } else if (name == "extreme") {
      vertices.push_back(extreme_vertex(codec, random, exponent));
    } else if (name == "random") {
      vertices.push_back(random_vertex(codec, random, exponent));
    } else {
      throw std::invalid_argument("no stimulus named " + name);
    }
    vertices.back().tag = static_cast<std::uint16_t>(v);
  }
  return vertices;
}

LatticeWords random_lattice(const WordCodec& codec, tb::Random& random, int most) {
  std::array<int, 3> dims;
  for (int& points : dims) points = static_cast<int>(random.between(4, most));
  return random_lattice(codec, random, dims);
}

LatticeWords random_lattice(const WordCodec& codec, tb::Random& random,
                            const std::array<int, 3>& dims) {
  LatticeWords lattice;
  lattice.dims = dims;
  lattice.exponent = random_exponent(codec, random);
  lattice.points.resize(lattice.dims[0] * lattice.dims[1] * lattice.dims[2]);
  for (auto& point : lattice.points) {
    for (std::uint32_t& word : point) word = random_point(codec, random, lattice.exponent);
  }
  return lattice;
}

std::vector<VertexBeat> random_vertices(const WordCodec& codec, tb::Random& random,
                                        const std::array<int, 3>& dims, std::size_t count,
                                        bool stray) {
  std::vector<VertexBeat> vertices(count);
  for (VertexBeat& vertex : vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      vertex.cell[axis] = static_cast<int>(random.below(dims[axis] - 3));
      vertex.local[axis] =
          codec.coordinate(random.chance(0.1) ? random.pick({0.0, 1.0}) : random.unit());
      if (!stray) continue;
      if (random.chance(0.1)) vertex.cell[axis] = static_cast<int>(random.below(16));
      if (random.chance(0.1)) vertex.local[axis] = corner_coordinate(codec, random);
      if (random.chance(0.05)) vertex.local[axis] = extreme_word(codec, random);
    }
    vertex.tag = static_cast<std::uint16_t>(random.word());
  }
  return vertices;
}

std::vector<Beat> spoiled(std::vector<Beat> packet, tb::Random& random) {
  switch (random.below(5)) {
    case 0:
      packet.resize(1 + random.below(packet.size()));
      break;
    case 1:
      packet.back().last = false;
      for (std::uint64_t extra = 1 + random.below(60); extra > 0; --extra) {
        packet.push_back({{random.word(), random.word(), random.word(), random.word()}, false});
      }
      break;
    case 2:
      packet[0].words[0] =
          (packet[0].words[0] & ~0xFFU) | static_cast<std::uint8_t>(random.below(256));
      break;
    case 3:
      packet[0].words[2] = random.word() & 0x9F1F1F1F;
      packet[0].words[3] = random.word();
      break;
    default:
      packet[0].words[1] = static_cast<std::uint32_t>(random.below(3));
  }
  packet.back().last = true;
  return packet;
}

std::vector<Beat> random_packets(const WordCodec& codec, tb::Random& random, int packets) {
  std::vector<Beat> beats;
  std::array<int, 3> dims = {4, 4, 4};
  for (int p = 0; p < packets; ++p) {
    std::vector<Beat> packet;
    const auto mode = static_cast<OutsideMode>(random.below(4));
    const auto results = static_cast<Results>(random.below(3));
    switch (random.below(4)) {
      case 0:
        packet = coefficients_packet(
            random_coefficients(codec, random),
            random.chance(0.8) ? Functions::kDerivativesToo : Functions::kBlending);
        break;
      case 1: {
        const LatticeWords lattice = random_lattice(codec, random, 6);
        dims = lattice.dims;
        packet = lattice_packet(lattice);
        break;
      }
      case 2:
        packet = vertices_packet(random_vertices(codec, random, dims, random.between(1, 9), true),
                                 mode, results);
        break;
      default: {
        const int exponent = random_exponent(codec, random);
        packet = interleaved_packet(
            {extreme_vertex(codec, random, exponent), corner_vertex(codec, random, exponent)}, mode,
            results);
      }
    }
    if (random.chance(0.25)) packet = spoiled(std::move(packet), random);
    beats.insert(beats.end(), packet.begin(), packet.end());
  }
  return beats;
}

std::array<AxisWords, 3> random_coefficients(const WordCodec& codec, tb::Random& random) {
  std::array<AxisWords, 3> axes;
  for (AxisWords& axis : axes) {
    axis.degree = static_cast<int>(random.below(4));
    axis.shift = static_cast<int>(random.below(4));
    axis.derivative.shift = static_cast<int>(random.below(4));
    for (auto* words : {&axis.word, &axis.derivative.word}) {
      for (auto& function : *words) {
        for (std::uint32_t& word : function) word = codec.coefficient(2 * random.unit() - 1, 0);
      }
    }
  }
  return axes;
}

}  // namespace hwffd::test
