#include "samples.hpp"

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd::words {
namespace {

/// Uniform in [0, 1), 53 bits.
double unit(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

Support random_support(std::mt19937_64& engine) {
  Support support;
  for (Eigen::Index i = 0; i < support.size(); ++i) support.data()[i] = 2 * unit(engine) - 1;
  return support;
}

void add_cells(std::vector<Support>& supports, const Lattice& lattice) {
  const Normalization normalization = Normalization::of(lattice, WordCodec("fx32"));
  const Index3 cells = lattice.cells();
  for (int i = 0; i < cells[0]; ++i) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int k = 0; k < cells[2]; ++k) {
        Support support = lattice.support({i, j, k});
        for (int p = 0; p < 64; ++p) support.row(p) = normalization.to_stream(support.row(p));
        supports.push_back(support);
      }
    }
  }
}

}  // namespace

Samples::Samples() {
  const Box box({0, 0, 0}, Eigen::Vector3d(1.0, 1.6, 0.7).asDiagonal());
  for (const int n : {4, 7, 10}) {
    for (const char* text : {"twist:90", "twist:-140", "bend:90", "bend:35", "shear:0.5"}) {
      add_cells(smooth_, Deformation::parse(text).apply(box.lattice({n, n, n})));
    }
  }
}

Sample Samples::draw_one(std::mt19937_64& engine, bool smooth) const {
  static const WordCodec kFixed("fx32");
  static const WordCodec kBinary("fp32");
  static const Oracle kOracle;
  Sample sample;
  Point local;
  for (int axis = 0; axis < 3; ++axis) {
    local[axis] = unit(engine);
    sample.fixed.local[axis] = kFixed.coordinate(local[axis]);
    sample.binary.local[axis] = kBinary.coordinate(local[axis]);
    sample.fixed.cell[axis] = sample.binary.cell[axis] = static_cast<int>(engine() & 15);
  }
  const Support support = smooth ? smooth_[engine() % smooth_.size()] : random_support(engine);
  for (int i = 0; i < 192; ++i) {
    sample.fixed.points[i] = kFixed.point(support.data()[i]);
    sample.binary.points[i] = kBinary.point(support.data()[i]);
  }
  sample.exact = kOracle.evaluate(support, local[0], local[1], local[2]);
  return sample;
}

std::vector<Sample> Samples::draw(std::uint64_t seed, int count) const {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
  std::mt19937_64 engine(sequence);
  std::vector<Sample> samples;
  samples.reserve(count);
  for (int i = 0; i < count; ++i) samples.push_back(draw_one(engine, i % 2 == 1));
  return samples;
}

}  // namespace hwffd::words
