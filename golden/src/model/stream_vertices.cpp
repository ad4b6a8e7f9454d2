// How a stream model reads vertices: one from a beat, two of a beat, a grid of them.
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packed.hpp"

namespace hwffd::model {

/// Two packed vertices; the second half of the last beat may be empty, and behind the last vertex
/// it is not read.
void StreamModel::pair(const Beat& beat) {
  const std::uint64_t low = beat.words[0] | std::uint64_t{beat.words[1]} << 32;
  const std::uint64_t high = beat.words[2] | std::uint64_t{beat.words[3]} << 32;
  const bool alone = beat.last && high == kNoPackedVertex;
  packed_vertex(low, alone);
  if (!alone && state_ != State::kDone) packed_vertex(high, beat.last);
}

void StreamModel::packed_vertex(std::uint64_t bits, bool last) {
  refused_ = bits >> 63 != 0;
  if (refused_) refuse(event::kGridCount);
  vertex(unpacked(vertex_of_bits(bits), number_++, codec_), last);
  refused_ = false;
}

void StreamModel::grid_beat(const Beat& beat) {
  grid_[0] = header_;
  grid_[++beat_] = beat;
  if (beat_ == 3) grid();
}

/// All vertices, if all of them are in the lattice and they are not too many.
void StreamModel::grid() {
  const Grid grid = grid_of(grid_);
  const int cells = flagged(kLargeFlag) ? kLargeAxisPoints : kSmallAxisPoints;
  if (page_ == nullptr || !grid_fits(grid, page_->dims, cells) ||
      vertex_count(grid) > std::uint64_t{1} << grid_limit_) {
    refuse(event::kGridCount);
    state_ = State::kDrop;
    return;
  }
  const std::array<int, 3> dims = page_->dims;
  std::size_t left = vertex_count(grid);
  for_each_vertex(grid, [&](const std::array<std::uint32_t, 3>& at) {
    vertex(grid_vertex(grid, dims, codec_, at), --left == 0);
  });
}

}  // namespace hwffd::model
