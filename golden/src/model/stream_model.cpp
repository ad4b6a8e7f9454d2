#include "hwffd/model/stream_model.hpp"

#include <algorithm>
#include <utility>

namespace hwffd::model {

StreamModel::StreamModel(const Configuration& configuration, std::uint32_t features,
                         int axis_points, int spans)
    : evaluator_(make_evaluator_model(configuration)),
      features_(features),
      axis_points_(axis_points),
      spans_(spans) {}

void StreamModel::reset() {
  state_ = State::kHeader;
  bank_ = 0;
  loaded_ = false;
  derivatives_loaded_ = false;
  spans_.reset();
  lattice_.clear();
  results_.clear();
  events_ = {};
  vertices_ = 0;
}

std::vector<Beat> StreamModel::run(const std::vector<Beat>& beats) {
  for (const Beat& beat : beats) accept(beat);
  return take_results();
}

std::vector<Beat> StreamModel::take_results() { return std::exchange(results_, {}); }

void StreamModel::accept(const Beat& beat) {
  const bool payload = state_ != State::kHeader && state_ != State::kDone && state_ != State::kDrop;
  switch (state_) {
    case State::kHeader:
      header(beat);
      break;
    case State::kCoefficients:
      coefficients(beat);
      break;
    case State::kSpans:
      span(beat);
      break;
    case State::kLattice:
      lattice_point(beat);
      break;
    case State::kVertex:
      vertex(beat);
      break;
    case State::kPoints:
      points(beat);
      break;
    case State::kDone:
      ++events_[event::kPacketLong];
      state_ = State::kDrop;
      break;
    case State::kDrop:
      break;
  }
  if (!beat.last) return;
  if (payload && state_ != State::kDone) ++events_[event::kPacketShort];
  state_ = State::kHeader;
}

/// Whether the core has what a header asks for.
bool StreamModel::known(const Beat& header) const {
  const auto has = [&](Feature feature) { return (features_ & feature) != 0; };
  const std::uint32_t asked = header.words[2] >> 8 & 3;
  const bool results = asked == static_cast<std::uint32_t>(Results::kDerivatives)
                           ? has(kDerivativesFeature)
                       : asked == static_cast<std::uint32_t>(Results::kDeterminant)
                           ? has(kDeterminantFeature)
                           : asked == static_cast<std::uint32_t>(Results::kPosition);
  switch (static_cast<Opcode>(header.words[0] & 0xFF)) {
    case Opcode::kCoefficients:
      return has(kDerivativesFeature) || (header.words[2] & kDerivativesFollow) == 0;
    case Opcode::kSpans: {
      const std::uint32_t axis = header.words[2] >> 22 & 3;
      return has(kSpansFeature) && axis < 3 && (header.words[0] & ~(kEndsSet | 0xFFU)) == 0 &&
             (header.words[2] & 0x7F3300CCU) == 0 && header.words[3] == 0 &&
             (has(kDerivativesFeature) || (header.words[2] & kDerivativesFollow) == 0);
    }
    case Opcode::kLattice:
      return has(kResidentFeature);
    case Opcode::kVertices:
      return has(kResidentFeature) && results;
    case Opcode::kInterleaved:
      return has(kInterleavedFeature) && results;
    default:
      return false;
  }
}

void StreamModel::header(const Beat& beat) {
  header_ = beat;
  beat_ = 0;
  vertices_left_ = beat.words[1];
  state_ = State::kDrop;
  if (!known(beat)) {
    ++events_[event::kUnknownOpcode];
    return;
  }
  bool starts = false;
  switch (static_cast<Opcode>(beat.words[0] & 0xFF)) {
    case Opcode::kCoefficients:
      state_ = State::kCoefficients;
      starts = true;
      break;
    case Opcode::kSpans:
      if (!start_spans()) {
        ++events_[stream_event(event::kSpanBeyond)];
        return;
      }
      starts = vertices_left_ != 0;
      if (starts) state_ = State::kSpans;
      break;
    case Opcode::kLattice:
      if (!start_lattice()) {
        ++events_[event::kLatticeSize];
        return;
      }
      state_ = State::kLattice;
      starts = true;
      break;
    case Opcode::kVertices:
    case Opcode::kInterleaved:
      wanted_ = static_cast<Results>(beat.words[2] >> 8 & 3);
      resident_ = static_cast<Opcode>(beat.words[0] & 0xFF) == Opcode::kVertices;
      starts = vertices_left_ != 0;
      if (starts) state_ = State::kVertex;
      break;
  }
  if (!starts || beat.last) ++events_[event::kPacketShort];
}

/// Ten bits of word 3, two's complement.
int StreamModel::header_exponent() const {
  const int low = static_cast<int>(header_.words[3] & 0x3FF);
  return low < 512 ? low : low - 1024;
}

bool StreamModel::start_lattice() {
  for (int axis = 0; axis < 3; ++axis) {
    new_dims_[axis] = static_cast<int>(header_.words[2] >> (8 * axis)) & 0xFF;
    if (new_dims_[axis] < 4 || new_dims_[axis] > axis_points_) return false;
  }
  new_lattice_.clear();
  return true;
}

void StreamModel::coefficients(const Beat& beat) {
  const bool derivatives = (header_.words[2] & kDerivativesFollow) != 0;
  const int axis = beat_ % kCoefficientBeats / 4;
  const auto field = [&](int low) {
    return static_cast<int>(header_.words[2] >> (low + 2 * axis)) & 3;
  };
  if (beat_ < kCoefficientBeats) {
    evaluator_->load(1 - bank_, axis, beat_ % 4, field(0), field(8), beat.words);
  } else {
    evaluator_->load_derivative(1 - bank_, axis, beat_ % 4, field(0), field(16), beat.words);
  }
  const bool of_derivative = beat_ >= kCoefficientBeats;
  spans_.set_common(axis, beat_ % 4, of_derivative,
                    {field(0), field(of_derivative ? 16 : 8), beat.words});
  if (++beat_ == (derivatives ? 2 : 1) * kCoefficientBeats) {
    bank_ = 1 - bank_;
    spans_.take_common();
    loaded_ = true;
    derivatives_loaded_ = derivatives;
    state_ = State::kDone;
  }
}

/// Whether the spans of a header are all there.
bool StreamModel::start_spans() {
  const std::uint64_t first = header_.words[2] >> 8 & 0xFF;
  return first + header_.words[1] <= static_cast<std::uint64_t>(spans_.spans());
}

void StreamModel::span(const Beat& beat) {
  const std::uint32_t word = header_.words[2];
  const bool derivatives = (word & kDerivativesFollow) != 0;
  const auto field = [&](int low) { return static_cast<int>(word >> low) & 3; };
  const bool of_derivative = beat_ >= 4;
  const auto first = static_cast<std::uint32_t>(word >> 8 & 0xFF);
  const auto at = static_cast<int>(first + header_.words[1] - vertices_left_);
  spans_.receive(field(22), at, beat_ % 4, of_derivative,
                 {field(0), field(of_derivative ? 18 : 4), beat.words});
  if (++beat_ < (derivatives ? 8 : 4)) return;
  beat_ = 0;
  spans_.complete(field(22), at, derivatives);
  if (--vertices_left_ != 0) return;
  state_ = State::kDone;
  if ((header_.words[0] & kEndsSet) == 0) return;
  derivatives_loaded_ = derivatives_loaded_ && spans_.set_has_derivatives();
  spans_.take_set();
}

/// Gives the evaluator the functions of the vertex's cell.
void StreamModel::use_spans() {
  if (spans_.spans() == 1) return;
  for (int axis = 0; axis < 3; ++axis) {
    const AxisFunctions& used = spans_.of_cell(axis, vertex_.cell[axis]);
    for (int function = 0; function < 4; ++function) {
      const FunctionWords& own = used.function[function];
      const FunctionWords& derivative = used.derivative[function];
      evaluator_->load(bank_, axis, function, own.degree, own.shift, own.words);
      evaluator_->load_derivative(bank_, axis, function, derivative.degree, derivative.shift,
                                  derivative.words);
    }
  }
}

void StreamModel::lattice_point(const Beat& beat) {
  new_lattice_.push_back({beat.words[0], beat.words[1], beat.words[2]});
  const int all = new_dims_[0] * new_dims_[1] * new_dims_[2];
  if (static_cast<int>(new_lattice_.size()) < all) return;
  dims_ = new_dims_;
  lattice_ = std::exchange(new_lattice_, {});
  lattice_exponent_ = header_exponent();
  state_ = State::kDone;
}

void StreamModel::vertex(const Beat& beat) {
  vertex_ = {};
  for (int axis = 0; axis < 3; ++axis) {
    vertex_.local[axis] = beat.words[axis];
    vertex_.cell[axis] = static_cast<int>(beat.words[3] >> (16 + 4 * axis)) & 15;
  }
  vertex_.exponent = resident_ ? lattice_exponent_ : header_exponent();
  tag_ = static_cast<std::uint16_t>(beat.words[3]);
  beat_ = 0;
  check_vertex();
  if (!resident_) {
    state_ = State::kPoints;
    if (beat.last) finish_vertex(true, true);
    return;
  }
  if (!lattice_.empty()) gather_support();
  const bool complete = vertices_left_ == 1;
  finish_vertex(false, complete || beat.last);
  state_ = complete ? State::kDone : State::kVertex;
}

void StreamModel::check_vertex() {
  const bool clamp = static_cast<OutsideMode>(header_.words[2] & 3) == OutsideMode::kClamp;
  nan_ = outside_ = cell_outside_ = false;
  for (int axis = 0; axis < 3; ++axis) {
    const CoordinateRange range = evaluator_->range(vertex_.local[axis]);
    nan_ |= range.nan;
    outside_ |= range.outside;
    if (clamp) vertex_.local[axis] = range.clamped;
    if (!resident_ || lattice_.empty() || vertex_.cell[axis] <= dims_[axis] - 4) continue;
    cell_outside_ = true;
    vertex_.cell[axis] = dims_[axis] - 4;
    if (clamp) vertex_.local[axis] = evaluator_->one_word();
  }
}

void StreamModel::gather_support() {
  for (int p = 0; p < 64; ++p) {
    const std::array<int, 3> offset = {p / 16, p / 4 % 4, p % 4};
    int at = 0;
    for (int axis = 0; axis < 3; ++axis) {
      at = at * dims_[axis] + vertex_.cell[axis] + offset[axis];
    }
    for (int c = 0; c < 3; ++c) vertex_.points[3 * p + c] = lattice_[at][c];
  }
}

void StreamModel::points(const Beat& beat) {
  for (int lane = 0; lane < 4; ++lane) vertex_.points[4 * beat_ + lane] = beat.words[lane];
  ++beat_;
  const bool complete = beat_ == kPointBeats;
  if (!complete && !beat.last) return;
  const bool last_vertex = vertices_left_ == 1;
  finish_vertex(!complete, last_vertex || beat.last);
  if (complete) state_ = last_vertex ? State::kDone : State::kVertex;
}

void StreamModel::finish_vertex(bool truncated, bool last) {
  --vertices_left_;
  ++vertices_;
  const bool no_lattice = resident_ && lattice_.empty();
  const bool no_functions = !loaded_ || (wanted_ != Results::kPosition && !derivatives_loaded_);
  const bool unloaded = no_functions || no_lattice;
  const bool out = outside_ || cell_outside_;
  const auto mode = static_cast<OutsideMode>(header_.words[2] & 3);
  const bool clamp = mode == OutsideMode::kClamp;
  const bool refused = out && !clamp && mode != OutsideMode::kPass;
  events_[event::kNoCoefficients] += no_functions ? 1 : 0;
  events_[event::kNoLattice] += no_lattice ? 1 : 0;
  events_[event::kCoordinateNan] += nan_ ? 1 : 0;
  events_[event::kCoordinateOutside] += outside_ ? 1 : 0;
  events_[event::kCellOutside] += cell_outside_ ? 1 : 0;

  Beat result;
  result.words[3] = tag_ | (out && clamp ? kStatusClamped : 0) | (nan_ ? kStatusNan : 0) |
                    (out ? kStatusOutside : 0) | (truncated ? kStatusTruncated : 0) |
                    (unloaded ? kStatusUnloaded : 0);
  const bool blank = truncated || unloaded || nan_ || refused;
  if (!blank) use_spans();
  for (int part = 0; part < results_of(wanted_); ++part) {
    results_.push_back(blank ? blank_result(result) : evaluated(result, part));
  }
  results_.back().last = last;
}

Beat StreamModel::blank_result(Beat result) const {
  for (int c = 0; c < 3; ++c) result.words[c] = evaluator_->blank_word();
  return result;
}

Beat StreamModel::evaluated(Beat result, int part) {
  const bool determinant = part > 0 && wanted_ == Results::kDeterminant;
  vertex_.derivative = part == 0 ? VertexWords::kPosition : part - 1;
  const ResultWords words =
      determinant ? evaluator_->determinant(bank_, vertex_) : evaluator_->evaluate(bank_, vertex_);
  const std::uint32_t x = words.words[0];
  const bool folded = determinant && (x == 0 || (x >> 31) != 0);
  for (int c = 0; c < 3; ++c) result.words[c] = words.words[c];
  result.words[3] |= (words.saturated ? kStatusSaturated : 0) | (words.nan ? kStatusNan : 0) |
                     (folded ? kStatusFolded : 0);
  events_[event::kSaturated] += words.saturated ? 1 : 0;
  return result;
}

}  // namespace hwffd::model
