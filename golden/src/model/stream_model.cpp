#include "hwffd/model/stream_model.hpp"

#include <utility>

#include "hwffd/stream/packets.hpp"

namespace hwffd::model {

StreamModel::StreamModel(const Configuration& configuration)
    : evaluator_(make_evaluator_model(configuration)) {}

void StreamModel::reset() {
  state_ = State::kHeader;
  bank_ = 0;
  loaded_ = false;
  results_.clear();
}

std::vector<Beat> StreamModel::run(const std::vector<Beat>& beats) {
  for (const Beat& beat : beats) accept(beat);
  return take_results();
}

std::vector<Beat> StreamModel::take_results() { return std::exchange(results_, {}); }

void StreamModel::accept(const Beat& beat) {
  switch (state_) {
    case State::kHeader:
      header(beat);
      break;
    case State::kCoefficients:
      coefficients(beat);
      break;
    case State::kVertex:
      vertex_ = {};
      for (int axis = 0; axis < 3; ++axis) {
        vertex_.local[axis] = beat.words[axis];
        vertex_.cell[axis] = static_cast<int>(beat.words[3] >> (16 + 4 * axis)) & 15;
      }
      tag_ = static_cast<std::uint16_t>(beat.words[3]);
      beat_ = 0;
      state_ = State::kPoints;
      if (beat.last) finish_vertex(true, true);
      break;
    case State::kPoints:
      points(beat);
      break;
    case State::kDrop:
      break;
  }
  if (beat.last) state_ = State::kHeader;
}

void StreamModel::header(const Beat& beat) {
  header_ = beat;
  beat_ = 0;
  vertices_left_ = beat.words[1];
  const auto opcode = static_cast<Opcode>(beat.words[0] & 0xFF);
  state_ = opcode == Opcode::kCoefficients                         ? State::kCoefficients
           : opcode == Opcode::kInterleaved && vertices_left_ != 0 ? State::kVertex
                                                                   : State::kDrop;
}

void StreamModel::coefficients(const Beat& beat) {
  const int axis = beat_ / 4;
  const int degree = static_cast<int>(header_.words[2] >> (2 * axis)) & 3;
  const int shift = static_cast<int>(header_.words[2] >> (8 + 2 * axis)) & 3;
  evaluator_->load(1 - bank_, axis, beat_ % 4, degree, shift, beat.words);
  if (++beat_ == kCoefficientBeats) {
    bank_ = 1 - bank_;
    loaded_ = true;
    state_ = State::kDrop;
  }
}

void StreamModel::points(const Beat& beat) {
  for (int lane = 0; lane < 4; ++lane) vertex_.points[4 * beat_ + lane] = beat.words[lane];
  ++beat_;
  const bool complete = beat_ == kPointBeats;
  if (!complete && !beat.last) return;
  const bool last = beat.last || vertices_left_ == 1;
  finish_vertex(!complete, last);
  state_ = last ? State::kDrop : State::kVertex;
}

void StreamModel::finish_vertex(bool truncated, bool last) {
  --vertices_left_;
  Beat result;
  result.last = last;
  if (truncated || !loaded_) {
    for (int c = 0; c < 3; ++c) result.words[c] = evaluator_->blank_word();
    result.words[3] = tag_ | (truncated ? kStatusTruncated : 0) | (loaded_ ? 0 : kStatusUnloaded);
  } else {
    const ResultWords words = evaluator_->evaluate(bank_, vertex_);
    for (int c = 0; c < 3; ++c) result.words[c] = words.words[c];
    result.words[3] =
        tag_ | (words.saturated ? kStatusSaturated : 0) | (words.nan ? kStatusNan : 0);
  }
  results_.push_back(result);
}

}  // namespace hwffd::model
