#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::test {

/// The kinds of vertices that the system tests send:
/// - corner: coordinates 0, 1 and one step inside, cells of all residues, ordinary points
/// - extreme: words from the ends of the format: huge, tiny, infinite, NaN
/// - random: coordinates and points uniform in the format's range
/// - mesh: consecutive vertices of a mesh in a twisted lattice of many cells
const std::vector<std::string>& stimulus_names();

/// `count` vertices of a kind; tags count from 0. In block floating point all have one exponent, a
/// random one.
std::vector<InterleavedVertex> make_stimulus(const std::string& name, const WordCodec& codec,
                                             std::size_t count, std::uint64_t seed);

/// A vertex with uniform coordinates and points in [-1, 1) times 2^exponent and a random cell.
InterleavedVertex random_vertex(const WordCodec& codec, tb::Random& random, int exponent = 0);

/// A lattice of 4 to `most` points an axis, uniform in [-1, 1) times 2^exponent, in block floating
/// point of a random exponent.
LatticeWords random_lattice(const WordCodec& codec, tb::Random& random, int most);
/// The same of so many points an axis.
LatticeWords random_lattice(const WordCodec& codec, tb::Random& random,
                            const std::array<int, 3>& dims);

/// Vertices of a lattice: coordinates uniform, now and then 0 or 1; with `stray`, now and then a
/// cell or a coordinate outside, or a coordinate that is no number.
std::vector<VertexBeat> random_vertices(const WordCodec& codec, tb::Random& random,
                                        const std::array<int, 3>& dims, std::size_t count,
                                        bool stray = false);

/// Packets of every kind in any order, some of them bad; lattices are small.
std::vector<Beat> random_packets(const WordCodec& codec, tb::Random& random, int packets);

/// A packet with something wrong: cut short, too long, of unknown opcode, or with a spoiled header.
std::vector<Beat> spoiled(std::vector<Beat> packet, tb::Random& random);

/// Coefficients of functions and derivatives, degrees and shifts at random: every bit of the
/// coefficient file is used.
std::array<AxisWords, 3> random_coefficients(const WordCodec& codec, tb::Random& random);

}  // namespace hwffd::test
