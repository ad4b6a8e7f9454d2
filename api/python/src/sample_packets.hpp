#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd::python {

/// What a core takes.
struct SampledCore {
  std::string format;
  std::uint32_t features = 0;  ///< bits of `Feature`
  int axis = kAxisPoints;
  int pages = kPages;
  int spans = 1;
};

/// Good packets of every kind that a core takes, with so many vertices in all, some of them outside
/// their lattice. The same for the same seed on every machine.
class SamplePackets {
 public:
  SamplePackets(const SampledCore& core, std::uint64_t seed);

  /// The first vertex is in a packet by itself.
  std::vector<Beat> packets(std::size_t vertices);
  /// Beats up to the end of that packet.
  std::size_t beats_of_first() const { return beats_of_first_; }

 private:
  using Dims = std::array<int, 3>;

  bool has(std::uint32_t feature) const { return (core_.features & feature) != 0; }
  double uniform(double low, double high);
  int below(int end);
  std::vector<Beat> functions();
  LatticeWords lattice(bool fourth);
  std::array<std::uint32_t, 3> point();
  std::vector<VertexBeat> vertices(std::size_t count, const Dims& dims);
  Results results(bool with_determinant);
  PageVertices how(bool fourth);

  std::vector<Beat> first();
  /// Packets of a kind with at most so many vertices; takes from `left` what they have.
  std::vector<Beat> resident(std::size_t& left);
  std::vector<Beat> page(std::size_t& left);
  std::vector<Beat> grid(std::size_t& left);
  std::vector<Beat> packed_vertices(std::size_t& left);
  std::vector<Beat> interleaved(std::size_t& left);

  SampledCore core_;
  WordCodec codec_;
  std::mt19937_64 random_;
  std::uint16_t tag_ = 0;
  int kind_of_results_ = 0;
  std::size_t beats_of_first_ = 0;
};

}  // namespace hwffd::python
