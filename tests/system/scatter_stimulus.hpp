#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hwffd/stream/events.hpp"
#include "hwffd/stream/gradients.hpp"
#include "hwffd/stream/opcodes.hpp"
#include "hwffd/stream/word_codec.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::test {

/// A gradient of any size, now and then the largest, which saturates.
std::array<std::uint32_t, 3> random_gradient(tb::Random& random);

/// Vertices of a lattice with gradients; `stray` as of random_vertices in stimulus.hpp.
std::vector<GradientBeats> random_gradients(const WordCodec& codec, tb::Random& random,
                                            const std::array<int, 3>& dims, std::size_t count,
                                            bool stray = false);

/// How gradients go to a lattice of so many points an axis.
Gradients gradients_to(const std::array<int, 3>& dims, bool begin = false);

/// Gradients of all vertices of a grid.
std::vector<Beat> random_grid_packet(tb::Random& random, int page, const Grid& grid,
                                     const Gradients& how);

/// A grid of a few vertices of a lattice.
Grid small_grid(tb::Random& random, const std::array<int, 3>& dims);

/// One with rows of up to so many vertices, of either direction, which stand still or leap over
/// cells now and then.
Grid long_rows(tb::Random& random, const std::array<int, 3>& dims, int most);

/// The rows of a grid in its order, each as a grid by itself.
std::vector<Grid> rows_of(const Grid& grid);

/// Of the header of a packet.
Opcode opcode_of(const std::vector<Beat>& packet);

/// Whether it is of gradients or a collect: no evaluator knows it.
bool is_of_scatter(const std::vector<Beat>& packet);

/// A packet of so many beats: cut, or with beats that belong to nothing behind it.
std::vector<Beat> sized(std::vector<Beat> packet, std::size_t beats);

/// Packets of opcodes 1, 10 and 11 in any order, now and then others, some of them bad.
class ScatterPackets {
 public:
  ScatterPackets(const WordCodec& codec, tb::Random& random, int axis, int pages)
      : codec_(codec),
        random_(random),
        axis_(axis),
        pages_(pages),
        dims_(static_cast<std::size_t>(pages)) {}

  std::vector<Beat> any(int packets);
  /// Beats at random: headers that are nearly right, and tlast anywhere.
  std::vector<Beat> garbage(int packets);
  std::vector<Beat> functions();

 private:
  std::vector<Beat> any_packet();
  std::vector<Beat> vertices(int page);
  std::vector<Beat> grid(int page);
  std::vector<Beat> collect(int page);
  std::vector<Beat> spoil(std::vector<Beat> packet);
  Gradients how(int page);
  std::array<int, 3> near_lattice(std::array<int, 3> dims) const;
  Beat garbage_header();

  const WordCodec& codec_;
  tb::Random& random_;
  int axis_;
  int pages_;
  std::vector<std::array<int, 3>> dims_;  // of what was sent last to each page
};

/// A packet with something wrong, and what is told of it: events and beats.
struct BadGradients {
  std::string name;
  std::vector<Beat> packet;
  std::vector<std::pair<unsigned, std::uint32_t>> events;
};

/// One of every row of the table of events that tells of a packet, for a core whose page 0 has
/// gradients of such a lattice and whose last page has none.
std::vector<BadGradients> bad_gradients(const WordCodec& codec, tb::Random& random,
                                        const std::array<int, 3>& dims, int axis, int pages);

}  // namespace hwffd::test
