#include "hwffd/model/stream_model.hpp"

#include <algorithm>
#include <utility>

#include "hwffd/model/coefficient_beat.hpp"
#include "hwffd/model/organizations.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd::model {

StreamModel::StreamModel(const Configuration& configuration, std::uint32_t features,
                         int axis_points, int pages, int spans, int grid_limit)
    : evaluator_(make_evaluator_model(configuration)),
      codec_(configuration.format),
      features_(features),
      axis_points_(axis_points),
      pages_(pages),
      spans_(spans),
      grid_limit_(grid_limit),
      sums_wanted_(completes(organization_of(configuration).form) && !wired_in(configuration)) {}

void StreamModel::reset() {
  state_ = State::kHeader;
  bank_ = 0;
  loaded_ = false;
  derivatives_loaded_ = false;
  pages_.assign(pages_.size(), {});
  newest_ = 0;
  spans_.reset();
  results_.clear();
  waiting_ = {};
  events_ = {};
  vertices_ = 0;
}

std::vector<Beat> StreamModel::run(const std::vector<Beat>& beats) {
  for (const Beat& beat : beats) take(beat);
  evaluate_waiting();
  return take_results();
}

std::vector<Beat> StreamModel::take_results() { return std::exchange(results_, {}); }

void StreamModel::accept(const Beat& beat) {
  take(beat);
  evaluate_waiting();
}

void StreamModel::take(const Beat& beat) {
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
    case State::kPart:
      part_point(beat);
      break;
    case State::kVertex:
      vertex(vertex_of(beat, axis_points_, flagged(kLargeFlag)), beat.last);
      break;
    case State::kPair:
      pair(beat);
      break;
    case State::kGrid:
      grid_beat(beat);
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
  if (payload && state_ != State::kDone && state_ != State::kDrop) ++events_[event::kPacketShort];
  state_ = State::kHeader;
}

void StreamModel::header(const Beat& beat) {
  header_ = beat;
  beat_ = 0;
  left_ = beat.words[1];
  state_ = State::kDrop;
  if (!known(beat)) {
    refuse(event::kUnknownOpcode);
    return;
  }
  const auto opcode = static_cast<Opcode>(beat.words[0] & 0xFF);
  const bool newest =
      opcode == Opcode::kVertices || (opcode == Opcode::kGrid && !has(kPagesFeature));
  const int number = opcode == Opcode::kLattice ? other_page()
                     : newest                   ? newest_
                                                : static_cast<int>(beat.words[0] >> 8 & 0xFF);
  // Others may change what vertices that wait are evaluated with.
  if (opcode != Opcode::kVertices && opcode != Opcode::kGrid) evaluate_waiting();
  if (!start(opcode, number)) return;
  if (state_ == State::kDrop || beat.last) ++events_[event::kPacketShort];
}

/// Makes ready for the payload, if there shall be any; false: the packet is refused.
bool StreamModel::start(Opcode opcode, int number) {
  switch (opcode) {
    case Opcode::kCoefficients:
      state_ = State::kCoefficients;
      return true;
    case Opcode::kSpans:
      return start_spans();
    case Opcode::kLattice:
    case Opcode::kPage:
      return start_lattice(opcode, number);
    case Opcode::kPoints:
      return start_part(number);
    default:
      return start_vertices(opcode, number);
  }
}

bool StreamModel::refuse(event::Code code) {
  ++events_[stream_event(code)];
  return false;
}

/// Ten bits of word 3, two's complement.
int StreamModel::header_exponent() const {
  const int low = static_cast<int>(header_.words[3] & 0x3FF);
  return low < 512 ? low : low - 1024;
}

bool StreamModel::start_lattice(Opcode opcode, int number) {
  if (number >= static_cast<int>(pages_.size())) return refuse(event::kNoLattice);
  const int most = flagged(kLargeFlag) ? axis_points_ : std::min(axis_points_, kSmallAxisPoints);
  std::array<int, 3> dims{};
  for (int axis = 0; axis < 3; ++axis) {
    dims[axis] = static_cast<int>(header_.words[2] >> (8 * axis)) & 0xFF;
    if (dims[axis] < 4 || dims[axis] > most) return refuse(event::kLatticeSize);
  }
  page_ = &pages_[number];
  *page_ = {};
  page_->dims = dims;
  page_->fourth = flagged(kFourthFlag);
  page_->exponent = header_exponent();
  for (int axis = 0; axis < 3 && opcode == Opcode::kPage; ++axis) {
    page_->origin[axis] = static_cast<int>(header_.words[3] >> (10 + 7 * axis) & 127);
  }
  turn_ = opcode == Opcode::kLattice;
  state_ = State::kLattice;
  return true;
}

bool StreamModel::start_part(int number) {
  if (number >= static_cast<int>(pages_.size())) return refuse(event::kNoLattice);
  page_ = &pages_[number];
  place_ = header_.words[2];
  const bool same_exponent = !codec_.is_block() || page_->exponent == header_exponent();
  if (!page_->loaded || !same_exponent || place_ + std::uint64_t{left_} > page_->points.size()) {
    return refuse(event::kPagePoints);
  }
  if (flagged(kFourthFlag) && !page_->fourth) return refuse(event::kNoFourth);
  if (left_ != 0) state_ = State::kPart;
  return true;
}

bool StreamModel::start_vertices(Opcode opcode, int number) {
  wanted_ = static_cast<Results>(header_.words[2] >> 8 & 3);
  resident_ = opcode != Opcode::kInterleaved;
  packet_results_ = 0;
  low_half_.reset();
  number_ = 0;
  page_ = nullptr;
  if (resident_ && number < static_cast<int>(pages_.size()) && pages_[number].loaded) {
    page_ = &pages_[number];
  }
  if (flagged(kFourthFlag) && (page_ == nullptr || !page_->fourth || has_determinant(wanted_))) {
    return refuse(event::kNoFourth);
  }
  if (opcode == Opcode::kGrid) {
    state_ = State::kGrid;
  } else if (left_ != 0 || flagged(kEveryFlag)) {
    state_ = packed() ? State::kPair : State::kVertex;
  }
  return true;
}

void StreamModel::coefficients(const Beat& beat) {
  const CoefficientBeat read = coefficient_of(header_, beat_, beat);
  const FunctionWords& words = read.words;
  if (read.derivative) {
    evaluator_->load_derivative(1 - bank_, read.axis, read.function, words.degree, words.shift,
                                words.words);
  } else {
    evaluator_->load(1 - bank_, read.axis, read.function, words.degree, words.shift, words.words);
  }
  spans_.set_common(read.axis, read.function, read.derivative, words);
  check_sums(read.function, read.derivative, words);
  if (++beat_ == coefficient_beats(header_)) {
    bank_ = 1 - bank_;
    spans_.take_common();
    loaded_ = true;
    derivatives_loaded_ = brings_derivatives(header_);
    state_ = State::kDone;
  }
}

bool StreamModel::start_spans() {
  const std::uint64_t first = header_.words[2] >> 8 & 0xFF;
  const bool beyond = first + left_ > static_cast<std::uint64_t>(spans_.spans());
  if (beyond) return refuse(event::kSpanBeyond);
  if (left_ != 0) state_ = State::kSpans;
  return true;
}

void StreamModel::span(const Beat& beat) {
  const std::uint32_t word = header_.words[2];
  const bool derivatives = (word & kDerivativesFollow) != 0;
  const auto field = [&](int low) { return static_cast<int>(word >> low) & 3; };
  const bool of_derivative = beat_ >= 4;
  const auto first = static_cast<std::uint32_t>(word >> 8 & 0xFF);
  const auto at = static_cast<int>(first + header_.words[1] - left_);
  const FunctionWords words{field(0), field(of_derivative ? 18 : 4), beat.words};
  spans_.receive(field(22), at, beat_ % 4, of_derivative, words);
  check_sums(beat_ % 4, of_derivative, words);
  if (++beat_ < (derivatives ? 8 : 4)) return;
  beat_ = 0;
  spans_.complete(field(22), at, derivatives);
  if (--left_ != 0) return;
  state_ = State::kDone;
  if ((header_.words[0] & kEndsSet) == 0) return;
  derivatives_loaded_ = derivatives_loaded_ && spans_.set_has_derivatives();
  spans_.take_set();
}

void StreamModel::check_sums(int function, bool derivative, const FunctionWords& words) {
  if (!sums_wanted_) return;
  const bool fault = sums_.fault(function, words.degree, words.shift, derivative, words.words);
  if (fault) ++events_[stream_event(event::kFunctionsSum)];
}

/// Gives the evaluator the functions of the vertex's cell.
void StreamModel::use_spans() {
  if (spans_.spans() == 1) return;
  for (int axis = 0; axis < 3; ++axis) {
    const int origin = page_ != nullptr ? page_->origin[axis] : 0;
    const AxisFunctions& used = spans_.of_cell(axis, origin + vertex_.cell[axis]);
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
  page_->points.push_back(beat.words);
  const std::array<int, 3>& dims = page_->dims;
  if (static_cast<int>(page_->points.size()) < dims[0] * dims[1] * dims[2]) return;
  page_->loaded = true;
  if (turn_) newest_ = other_page();
  state_ = State::kDone;
}

/// A point of a part; without its flag the fourth component stays.
void StreamModel::part_point(const Beat& beat) {
  ResidentPoints::Point& point = page_->points[place_++];
  std::copy_n(beat.words.begin(), flagged(kFourthFlag) ? 4 : 3, point.begin());
  if (--left_ == 0) state_ = State::kDone;
}

void StreamModel::vertex(const VertexBeat& read, bool last) {
  vertex_.local = read.local;
  vertex_.cell = read.cell;
  vertex_.exponent = page_ != nullptr ? page_->exponent : header_exponent();
  tag_ = static_cast<std::uint16_t>(read.tag & (flagged(kLargeFlag) ? kLargeTagMask : kTagMask));
  beat_ = 0;
  check_vertex();
  if (!resident_) {
    vertex_.points = {};
    state_ = State::kPoints;
    if (last) finish_vertex(true, true);
    return;
  }
  const bool counted = state_ != State::kGrid && !flagged(kEveryFlag);
  const bool complete = counted ? left_ == 1 : last;
  finish_vertex(false, complete || last);
  if (complete) state_ = State::kDone;
}

void StreamModel::check_vertex() {
  const bool clamp = static_cast<OutsideMode>(header_.words[2] & 3) == OutsideMode::kClamp;
  outside_ = bring_inside(vertex_.local, vertex_.cell, page_ != nullptr ? &page_->dims : nullptr,
                          clamp, evaluator_->one_word(),
                          [&](std::uint32_t word) { return evaluator_->range(word); });
}

void StreamModel::points(const Beat& beat) {
  for (int lane = 0; lane < 4; ++lane) vertex_.points[4 * beat_ + lane] = beat.words[lane];
  ++beat_;
  const bool complete = beat_ == kPointBeats;
  if (!complete && !beat.last) return;
  const bool last_vertex = left_ == 1;
  finish_vertex(!complete, last_vertex || beat.last);
  if (complete) state_ = last_vertex ? State::kDone : State::kVertex;
}

std::uint32_t StreamModel::error_status() const {
  std::uint32_t status = 0;
  for (unsigned code = 0; code < 32; ++code) {
    const bool of_stream = code <= event::kSaturated || code >= event::kPagePoints;
    const unsigned bit = stream_event(static_cast<event::Code>(code));
    if (of_stream && bit < kStreamEvents && events_[bit] != 0) status |= 1U << code;
  }
  return status;
}

}  // namespace hwffd::model
