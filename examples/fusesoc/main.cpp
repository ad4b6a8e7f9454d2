// hwffd_stream as FuseSoC verilates it: Bezier functions, one resident lattice, 27 vertices whose
// exact results have few bits, compared bit for bit. Exit status 1 if one differs.

#include <verilated.h>

#include <cstdio>
#include <memory>
#include <random>
#include <vector>

#include "Vhwffd_stream.h"
#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace {

using hwffd::Beat;

constexpr int kPatience = 100000;  // clocks without a beat

class Core {
 public:
  Core() : dut_(std::make_unique<Vhwffd_stream>(&context_)) {
    for (dut_->aresetn = 0; clocks_ < 2;) clock();
    dut_->aresetn = 1;
    dut_->m_axis_tready = 1;
  }
  ~Core() { dut_->final(); }
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  /// Sends all of it and keeps what comes out meanwhile.
  void send(const std::vector<Beat>& beats) {
    for (const Beat& beat : beats) {
      dut_->s_axis_tvalid = 1;
      dut_->s_axis_tlast = beat.last;
      for (int word = 0; word < 4; ++word) dut_->s_axis_tdata[word] = beat.words[word];
      for (int waited = 0; !clock() && waited < kPatience;) ++waited;
    }
    dut_->s_axis_tvalid = 0;
  }

  /// The first `count` results since the last call, or those that came before patience ended.
  std::vector<Beat> receive(std::size_t count) {
    for (int waited = 0; results_.size() < count && waited < kPatience; ++waited) clock();
    return std::move(results_);
  }

  long clocks() const { return clocks_; }

 private:
  /// One clock; whether the beat that is offered was taken at its edge.
  bool clock() {
    dut_->aclk = 0;
    dut_->eval();
    const bool taken = dut_->s_axis_tvalid != 0 && dut_->s_axis_tready != 0;
    if (dut_->m_axis_tvalid != 0 && dut_->m_axis_tready != 0) {
      Beat beat;
      for (int word = 0; word < 4; ++word) beat.words[word] = dut_->m_axis_tdata[word];
      beat.last = dut_->m_axis_tlast != 0;
      results_.push_back(beat);
    }
    dut_->aclk = 1;
    dut_->eval();
    ++clocks_;
    return taken;
  }

  VerilatedContext context_;
  std::unique_ptr<Vhwffd_stream> dut_;
  std::vector<Beat> results_;
  long clocks_ = 0;
};

/// Whether words are binary32: a vertex before any coefficients comes back blank, and the blank
/// word tells.
bool has_float_words(Core& core) {
  core.send(hwffd::vertices_packet({hwffd::VertexBeat{}}));
  const std::vector<Beat> blank = core.receive(1);
  return blank.size() == 1 && blank[0].words[0] != 0;
}

/// Weights of the Bezier functions at 0, 1/2 and 1, in eighths.
constexpr int kWeights[3][4] = {{8, 0, 0, 0}, {1, 3, 3, 1}, {0, 0, 0, 8}};

hwffd::AxisWords bezier(const hwffd::WordCodec& codec) {
  constexpr double kCoefficients[4][4] = {
      {1, -3, 3, -1}, {0, 3, -6, 3}, {0, 0, 3, -3}, {0, 0, 0, 1}};
  hwffd::AxisWords axis;
  axis.shift = 2;  // 6 does not fit into [-2, 2)
  for (int function = 0; function < 4; ++function) {
    for (int power = 0; power < 4; ++power) {
      axis.word[function][power] = codec.coefficient(kCoefficients[function][power], axis.shift);
    }
  }
  return axis;
}

struct Lattice {
  double point[4][4][4][3];
};

/// Points that are multiples of 1/16 in [-1/2, 1/2].
Lattice random_lattice() {
  std::mt19937_64 random(1);
  Lattice lattice;
  for (auto& plane : lattice.point) {
    for (auto& row : plane) {
      for (auto& point : row) {
        for (double& component : point) component = static_cast<int>(random() % 17) / 16.0 - 0.5;
      }
    }
  }
  return lattice;
}

hwffd::LatticeWords words_of(const Lattice& lattice, const hwffd::WordCodec& codec) {
  hwffd::LatticeWords words;
  words.dims = {4, 4, 4};
  for (const auto& plane : lattice.point) {
    for (const auto& row : plane) {
      for (const auto& p : row) {
        words.points.push_back({codec.point(p[0]), codec.point(p[1]), codec.point(p[2])});
      }
    }
  }
  return words;
}

/// Component c of vertex (s, t, u), in halves: exact in double.
double expected(const Lattice& lattice, int s, int t, int u, int c) {
  double sum = 0;
  for (int l = 0; l < 4; ++l) {
    for (int m = 0; m < 4; ++m) {
      for (int n = 0; n < 4; ++n) {
        sum += kWeights[s][l] * kWeights[t][m] * kWeights[u][n] / 512.0 * lattice.point[l][m][n][c];
      }
    }
  }
  return sum;
}

std::vector<hwffd::VertexBeat> vertices(const hwffd::WordCodec& codec) {
  std::vector<hwffd::VertexBeat> result;
  for (std::uint16_t tag = 0; tag < 27; ++tag) {
    hwffd::VertexBeat vertex;
    const int halves[3] = {tag / 9, tag / 3 % 3, tag % 3};
    for (int axis = 0; axis < 3; ++axis) vertex.local[axis] = codec.coordinate(halves[axis] / 2.0);
    vertex.tag = tag;
    result.push_back(vertex);
  }
  return result;
}

/// Results that are not bit for bit what was computed; each is printed.
int differences(const std::vector<Beat>& results, const Lattice& lattice,
                const hwffd::WordCodec& codec) {
  int different = 0;
  for (std::uint32_t tag = 0; tag < results.size(); ++tag) {
    const auto& words = results[tag].words;
    bool equal = words[3] == tag && results[tag].last == (tag == 26);
    for (int c = 0; c < 3; ++c) {
      const int s = static_cast<int>(tag) / 9;
      const int t = static_cast<int>(tag) / 3 % 3;
      const int u = static_cast<int>(tag) % 3;
      equal = equal && words[c] == codec.point(expected(lattice, s, t, u, c));
    }
    if (!equal) {
      std::printf("vertex %u: %08x %08x %08x, word 3 %08x\n", tag, words[0], words[1], words[2],
                  words[3]);
      ++different;
    }
  }
  return different;
}

}  // namespace

int main() {
  Core core;
  const hwffd::WordCodec codec(has_float_words(core) ? "fp32" : "fx32");
  const hwffd::AxisWords axis = bezier(codec);
  const Lattice lattice = random_lattice();
  core.send(hwffd::coefficients_packet({axis, axis, axis}));
  core.send(hwffd::lattice_packet(words_of(lattice, codec)));
  core.send(hwffd::vertices_packet(vertices(codec)));
  const std::vector<Beat> results = core.receive(27);
  const int different = differences(results, lattice, codec);
  std::printf("hwffd_stream, %s words: %zu of 27 results, %d differ, %ld clocks\n",
              codec.is_float() ? "binary32" : "fixed-point", results.size(), different,
              core.clocks());
  return results.size() == 27 && different == 0 ? 0 : 1;
}
