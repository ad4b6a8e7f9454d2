// What a stream model says of a vertex, and when it evaluates it.
#include <algorithm>
#include <vector>

#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/halves.hpp"

namespace hwffd::model {

void StreamModel::finish_vertex(bool truncated, bool last) {
  --left_;
  ++vertices_;
  const bool no_lattice = resident_ && page_ == nullptr;
  const bool no_functions = !loaded_ || (wanted_ != Results::kPosition && !derivatives_loaded_);
  const bool unloaded = no_functions || no_lattice || refused_;
  const bool out = outside_.any();
  const auto mode = static_cast<OutsideMode>(header_.words[2] & 3);
  const bool clamp = mode == OutsideMode::kClamp;
  const bool refused = out && !clamp && mode != OutsideMode::kPass;
  events_[event::kNoCoefficients] += no_functions ? 1 : 0;
  events_[event::kNoLattice] += no_lattice ? 1 : 0;
  events_[event::kCoordinateNan] += outside_.nan ? 1 : 0;
  events_[event::kCoordinateOutside] += outside_.coordinate ? 1 : 0;
  events_[event::kCellOutside] += outside_.cell ? 1 : 0;

  Beat result;
  result.words[3] = tag_ | (out && clamp ? kStatusClamped : 0) | (outside_.nan ? kStatusNan : 0) |
                    (out ? kStatusOutside : 0) | (truncated ? kStatusTruncated : 0) |
                    (unloaded ? kStatusUnloaded : 0);
  const bool blank = truncated || unloaded || outside_.nan || refused;
  const bool halves = flagged(kHalfFlag);
  const bool later = !blank && !halves && can_wait();
  if (later) wait();
  if (!blank) use_spans();
  if (halves) put_half(result, blank, last);
  for (int part = 0; part < results_of(wanted_) && !halves; ++part) {
    for (const bool fourth : {false, true}) {
      if (fourth && !flagged(kFourthFlag)) continue;
      results_.push_back(blank   ? blank_result(result)
                         : later ? result
                                 : evaluated(result, part, fourth));
      ++packet_results_;
    }
  }
  if (last) end_results(results_, packet_results_, flags());
}

/// The result of a vertex as half a beat, which leaves with its second half or with the packet.
void StreamModel::put_half(const Beat& result, bool blank, bool last) {
  HalfResult half;
  half.blank = blank;
  half.outside = (result.words[3] & kStatusOutside) != 0;
  if (!blank) {
    const Beat position = evaluated(result, 0, false);
    const bool saturated = (position.words[3] & kStatusSaturated) != 0;
    half.saturated = saturated;
    for (int c = 0; c < 3; ++c) {
      const HalfWord word = half_word(position.words[c]);
      half.words[c] = word.value;
      half.saturated |= word.saturated;
    }
    events_[event::kSaturated] += half.saturated && !saturated ? 1 : 0;
    if (wanted_ == Results::kDeterminant) {
      half.folded = (evaluated(result, 1, false).words[3] & kStatusFolded) != 0;
    }
  }
  const std::uint64_t bits = half_bits(half);
  if (!low_half_ && !last) {
    low_half_ = bits;
    return;
  }
  const std::uint64_t low = low_half_.value_or(bits), high = low_half_ ? bits : kNoHalf;
  low_half_.reset();
  results_.push_back({{static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32),
                       static_cast<std::uint32_t>(high), static_cast<std::uint32_t>(high >> 32)},
                      false});
  ++packet_results_;
}

Beat StreamModel::blank_result(Beat result) const {
  for (int c = 0; c < 3; ++c) result.words[c] = evaluator_->blank_word();
  return result;
}

Beat StreamModel::evaluated(Beat result, int part, bool fourth) {
  const bool determinant = has_determinant(wanted_) && part == results_of(wanted_) - 1;
  VertexWords vertex =
      resident_ ? with_support(*page_, {vertex_.local, vertex_.cell}, fourth) : vertex_;
  vertex.derivative = part == 0 ? VertexWords::kPosition : part - 1;
  const ResultWords words =
      determinant ? evaluator_->determinant(bank_, vertex) : evaluator_->evaluate(bank_, vertex);
  const std::uint32_t x = words.words[0];
  const bool folded = determinant && (x == 0 || (x >> 31) != 0);
  put(result, words, fourth ? 1 : 3);
  result.words[3] |= folded ? kStatusFolded : 0;
  return result;
}

void StreamModel::put(Beat& result, const ResultWords& words, int components) {
  std::copy_n(words.words.begin(), components, result.words.begin());
  result.words[3] |= (words.saturated ? kStatusSaturated : 0) | (words.nan ? kStatusNan : 0);
  events_[event::kSaturated] += words.saturated ? 1 : 0;
}

/// Whether the vertex may be evaluated with others of its page, behind it.
bool StreamModel::can_wait() const {
  return resident_ && spans_.spans() == 1 && !flagged(kFourthFlag) && !has_determinant(wanted_);
}

/// Keeps the vertex, whose results come next, for `evaluate_waiting`.
void StreamModel::wait() {
  if (waiting_.page != page_ || waiting_.each != results_of(wanted_)) evaluate_waiting();
  waiting_.page = page_;
  waiting_.each = results_of(wanted_);
  waiting_.vertices.push_back({vertex_.local, vertex_.cell});
  waiting_.results.push_back(results_.size());
}

/// Fills in the results of vertices that wait.
void StreamModel::evaluate_waiting() {
  if (waiting_.vertices.empty()) return;
  std::vector<ResultWords> words;
  for (int part = 0; part < waiting_.each; ++part) {
    evaluator_->evaluate(bank_, *waiting_.page, waiting_.vertices,
                         part == 0 ? VertexWords::kPosition : part - 1, words);
    for (std::size_t v = 0; v < words.size(); ++v) {
      put(results_[waiting_.results[v] + static_cast<std::size_t>(part)], words[v], 3);
    }
  }
  waiting_.vertices.clear();
  waiting_.results.clear();
}

}  // namespace hwffd::model
