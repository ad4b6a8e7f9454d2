#include "hwffd/model/scatter_stream.hpp"

#include <stdexcept>

#include "hwffd/model/coefficient_beat.hpp"
#include "hwffd/model/outside.hpp"
#include "hwffd/stream/events.hpp"

namespace hwffd::model {
namespace {

/// Any fixed point: a word that comes with a vertex means the same in all of them.
using Words = Fixed<kScatterMostWidth>;

constexpr int kModeAt = 24;
constexpr int kAlongAt = 26;
constexpr std::uint32_t kDimsBits = 0x00FFFFFF;

std::array<int, 3> dims_of(std::uint32_t word) {
  return {static_cast<int>(word & 0xFF), static_cast<int>(word >> 8 & 0xFF),
          static_cast<int>(word >> 16 & 0xFF)};
}

OutsideMode mode_of(const Beat& header) {
  return static_cast<OutsideMode>(header.words[2] >> kModeAt & 3);
}

/// Whether a header of gradients has no flag, mode or bit but those that there are.
bool known_gradients(const Beat& header, std::uint32_t flags) {
  const std::uint32_t counts = (flags & kGridGradientsFlag) != 0 ? 0xFFFF : 0;  // n_u
  const OutsideMode mode = mode_of(header);
  return (flags & ~(kGridGradientsFlag | kBeginFlag)) == 0 &&
         (header.words[2] & ~(kDimsBits | 3U << kModeAt | 3U << kAlongAt)) == 0 &&
         (header.words[3] & ~counts) == 0 &&
         (mode == OutsideMode::kClamp || mode == OutsideMode::kBlank);
}

/// The same of a collect.
bool known_collect(const Beat& header, std::uint32_t flags) {
  return (flags & ~(kCountFlag | kInterruptFlag)) == 0 && header.words[1] == 0 &&
         header.words[2] <= kScatterMostShift && header.words[3] <= kTagMask;
}

}  // namespace

ScatterStreamModel::ScatterStreamModel(const Configuration& row, int axis_points, int pages,
                                       bool rows)
    : scatter_(make_scatter_model(row)),
      codec_(row.format),
      axis_points_(axis_points),
      sums_wanted_(!wired_in(row)),
      pages_(static_cast<std::size_t>(pages)) {
  if (axis_points > kSmallAxisPoints) throw std::invalid_argument("cells that have no name");
  if (rows) row_.emplace(*scatter_);
}

void ScatterStreamModel::reset() {
  loaded_ = false;
  derivatives_loaded_ = false;
  pages_.assign(pages_.size(), std::nullopt);
  results_.clear();
  events_.clear();
  vertices_ = 0;
  if (row_) row_.emplace(*scatter_);
  state_ = State::kHeader;
  packet_ = 0;
  beat_ = 0;
}

std::vector<Beat> ScatterStreamModel::run(const std::vector<Beat>& beats) {
  for (const Beat& beat : beats) accept(beat);
  return take_results();
}

void ScatterStreamModel::accept(const Beat& beat) {
  const bool payload = state_ != State::kHeader && state_ != State::kDone && state_ != State::kDrop;
  switch (state_) {
    case State::kHeader:
      header(beat);
      break;
    case State::kCoefficients:
      coefficients(beat);
      break;
    case State::kAxes:
      axis(beat);
      break;
    case State::kVertex:
      vertex_ = vertex_of(beat, axis_points_, false);
      state_ = State::kGradient;
      break;
    case State::kGradient:
      gradient(beat);
      break;
    case State::kDone:
      refuse(event::kPacketLong);
      break;
    case State::kDrop:
      break;
  }
  ++beat_;
  if (!beat.last) return;
  if (payload && state_ != State::kDone && state_ != State::kDrop) {
    --beat_;
    tell(event::kPacketShort);
    end_row();
  }
  state_ = State::kHeader;
  ++packet_;
  beat_ = 0;
}

void ScatterStreamModel::tell(unsigned event, bool occurs) {
  if (occurs) events_.push_back({event, packet_, beat_});
}

/// Drops the packet.
bool ScatterStreamModel::refuse(unsigned event) {
  tell(event);
  state_ = State::kDrop;
  return false;
}

void ScatterStreamModel::header(const Beat& beat) {
  header_ = beat;
  if (!start() || state_ == State::kDone) return;
  tell(event::kPacketShort, beat.last || state_ == State::kDrop);
}

/// Makes ready for the payload, if there shall be any; false: the packet is refused.
bool ScatterStreamModel::start() {
  switch (static_cast<Opcode>(header_.words[0] & 0xFF)) {
    case Opcode::kCoefficients:
      state_ = State::kCoefficients;
      return true;
    case Opcode::kGradients:
      return start_gradients();
    case Opcode::kCollect:
      return start_collect();
    default:
      return refuse(event::kUnknownOpcode);
  }
}

bool ScatterStreamModel::start_gradients() {
  if (!known_gradients(header_, flags())) return refuse(event::kUnknownOpcode);
  if (page_number() >= pages_.size()) return refuse(event::kNoLattice);
  const std::array<int, 3> dims = dims_of(header_.words[2]);
  for (const int points : dims) {
    if (points < 4 || points > axis_points_) return refuse(event::kLatticeSize);
  }
  std::optional<Page>& page = pages_[page_number()];
  if ((flags() & kBeginFlag) != 0) page.reset();
  if (!page) page = Page{dims, ScatterPage(scatter_->width(), dims)};
  if (page->dims != dims) return refuse(stream_event(event::kPagePoints));
  page_ = &*page;
  left_ = header_.words[1];
  grid_.reset();
  if ((flags() & kGridGradientsFlag) != 0) {
    axes_[0] = header_;
    state_ = State::kAxes;
  } else {
    state_ = left_ != 0 ? State::kVertex : State::kDrop;
  }
  return true;
}

void ScatterStreamModel::coefficients(const Beat& beat) {
  const auto number = static_cast<int>(beat_) - 1;
  const CoefficientBeat read = coefficient_of(header_, number, beat);
  AxisWords& axis = next_functions_[read.axis];
  axis.degree = read.words.degree;
  (read.derivative ? axis.derivative.word : axis.word)[read.function] = read.words.words;
  (read.derivative ? axis.derivative.shift : axis.shift) = read.words.shift;
  const bool fault = sums_.fault(read.function, read.words.degree, read.words.shift,
                                 read.derivative, read.words.words);
  tell(stream_event(event::kFunctionsSum), fault && sums_wanted_);
  if (number + 1 < coefficient_beats(header_)) return;
  for (int a = 0; a < 3; ++a) scatter_->load(a, next_functions_[a]);
  loaded_ = true;
  derivatives_loaded_ = brings_derivatives(header_);
  state_ = State::kDone;
}

/// One of the three axes of a grid, which is refused with the last of them.
void ScatterStreamModel::axis(const Beat& beat) {
  axes_[beat_] = beat;
  if (beat_ < 3) return;
  grid_ = GridVertices{grid_of(axes_), {}};
  left_ = vertex_count(grid_->grid);
  state_ = State::kGradient;
  const bool fits = grid_fits(grid_->grid, page_->dims, kSmallAxisPoints);
  if (!fits) refuse(stream_event(event::kGridCount));
}

VertexBeat ScatterStreamModel::next_of_grid() {
  const VertexBeat vertex = grid_vertex(grid_->grid, page_->dims, codec_, grid_->next);
  for (int axis = 0; axis < 3; ++axis) {
    if (++grid_->next[axis] < grid_->grid.count[axis]) break;
    grid_->next[axis] = 0;
  }
  return vertex;
}

void ScatterStreamModel::gradient(const Beat& beat) {
  add(grid_ ? next_of_grid() : vertex_, beat);
  if (!grid_ || grid_->next[0] == 0) end_row();
  if (--left_ == 0) {
    state_ = State::kDone;
  } else if (!grid_) {
    state_ = State::kVertex;
  }
}

void ScatterStreamModel::add(const VertexBeat& vertex, const Beat& gradient) {
  const bool clamp = mode_of(header_) == OutsideMode::kClamp;
  GradientWords words;
  words.local = vertex.local;
  words.cell = vertex.cell;
  words.derivative = static_cast<int>(header_.words[2] >> kAlongAt & 3) - 1;
  for (int c = 0; c < 3; ++c) words.gradient[c] = gradient.words[c];
  const Outside outside =
      bring_inside(words.local, words.cell, &page_->dims, clamp, Words::kOneWord, Words::range);
  const bool functions = loaded_ && (words.derivative < 0 || derivatives_loaded_);
  tell(event::kNoCoefficients, !functions);
  tell(event::kCellOutside, outside.cell);
  tell(event::kCoordinateOutside, outside.coordinate);
  if (!functions || (outside.any() && !clamp)) return;
  const bool overflowed = page_->sums.overflowed();
  bool saturated = false;
  if (row_) {
    saturated = row_->add(words);
    page_->sums.count(saturated);
  } else {
    const VertexParts parts = scatter_->parts(words);
    saturated = parts.saturated;
    page_->sums.add(words.cell, parts);
  }
  ++vertices_;
  tell(event::kSaturated, saturated);
  tell(stream_event(event::kPageOverflowed), page_->sums.overflowed() && !overflowed);
}

/// With the last vertex of a row, or where the packet ends within it.
void ScatterStreamModel::end_row() {
  if (!row_ || row_->empty()) return;
  for (const bool saturated : row_->end(page_->sums)) tell(event::kSaturated, saturated);
}

bool ScatterStreamModel::start_collect() {
  if (!known_collect(header_, flags())) return refuse(event::kUnknownOpcode);
  if (page_number() >= pages_.size() || !pages_[page_number()]) return refuse(event::kNoLattice);
  collect(*pages_[page_number()]);
  pages_[page_number()].reset();
  state_ = State::kDone;
  return true;
}

void ScatterStreamModel::collect(Page& page) {
  const std::uint32_t overflowed = page.sums.overflowed() ? kStatusOverflowed : 0;
  std::uint32_t number = 0;
  for (const CollectedPoint& point : page.sums.collect(static_cast<int>(header_.words[2]))) {
    Beat result;
    for (int c = 0; c < 3; ++c) result.words[c] = point.words[c];
    result.words[3] = ((header_.words[3] + number++) & kTagMask) | overflowed |
                      (point.saturated ? kStatusSaturated : 0);
    results_.push_back(result);
    tell(event::kSaturated, point.word_saturated);
  }
  end_results(results_, number, flags());
}

}  // namespace hwffd::model
