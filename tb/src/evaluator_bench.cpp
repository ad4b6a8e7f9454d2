#include "hwffd/tb/evaluator_bench.hpp"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>

namespace hwffd::tb {
namespace {

constexpr std::uint64_t kStallLimit = 20'000;   // clocks without a result
constexpr int kUntilIdle = 3;                   // clocks behind the last result
constexpr unsigned kBankOfEachAxis = 0b010101;  // of {derivative, bank} of u, t, s
constexpr unsigned kDerivative = 2;             // of an axis's {derivative, bank}
constexpr unsigned kJacobian = 0b101010;        // that of each axis
constexpr int kDerivativeAddress = 8;           // of {derivative, bank, function}
constexpr int kBankAddress = 4;
constexpr std::uint32_t kNoSecond = 0x9E37'79B1;  // of vertex 1, for which it counts for nothing

/// All bits change from one vertex to the next; no two of 65,536 have the same.
std::uint16_t tag_of(std::size_t index) { return static_cast<std::uint16_t>(index * 40503); }

cores::EvaluatorCore::Vertex pins_of(const EvaluatorStimulus& stimulus, std::size_t index) {
  const EvaluatorVertex& vertex = stimulus.vertices[index];
  cores::EvaluatorCore::Vertex pins;
  pins.words = vertex.local;
  pins.second = vertex.second.value_or(kNoSecond * static_cast<std::uint32_t>(index));
  for (int axis = 0; axis < 3; ++axis) {
    pins.cell = static_cast<std::uint16_t>(pins.cell | (vertex.cell[axis] & 15) << (4 * axis));
  }
  pins.support = vertex.support;
  // Supports are written before a run; in the core a bank comes into use when it is loaded. The
  // same support in another cell is another part of a lattice.
  const EvaluatorVertex& before = stimulus.vertices[index > 0 ? index - 1 : 0];
  pins.changed = index == 0 || vertex.bank != before.bank ||
                 (vertex.support == before.support && vertex.cell != before.cell);
  unsigned bank = vertex.bank != 0 ? kBankOfEachAxis : 0;
  if (vertex.derivative >= 0) bank |= kDerivative << (2 * vertex.derivative);
  if (vertex.jacobian) bank |= kJacobian;
  pins.bank = static_cast<std::uint8_t>(bank);
  pins.exponent = stimulus.supports[vertex.support].exponent;
  pins.tag = tag_of(index);
  return pins;
}

/// As a planted fault sees it.
Beat beat_of(const cores::EvaluatorCore::Result& result) {
  const std::uint32_t flags = (result.nan ? 2U : 0U) | (result.saturated ? 1U : 0U);
  return {{result.words[0], result.words[1], result.words[2], flags << 16 | result.tag}, false};
}

cores::EvaluatorCore::Result result_of(const Beat& beat) {
  const std::uint32_t user = beat.words[3];
  return {{beat.words[0], beat.words[1], beat.words[2]},
          (user >> 16 & 1) != 0,
          (user >> 17 & 1) != 0,
          static_cast<std::uint16_t>(user)};
}

}  // namespace

EvaluatorBench::EvaluatorBench(cores::EvaluatorCore& core, model::EvaluatorModel& model,
                               const Bank& bank)
    : core_(core), model_(model) {
  core_.drive_reset(true);
  core_.drive_vertex(false, {});
  core_.drive_result_ready(false);
  for (int i = 0; i < 3; ++i) core_.clock();
  core_.drive_reset(false);
  load(0, bank);
}

void EvaluatorBench::load(int number, const Bank& bank) {
  for (int axis = 0; axis < 3; ++axis) {
    const AxisWords& words = bank[axis];
    const DerivativeWords& derivative = words.derivative;
    for (int f = 0; f < 4; ++f) {
      const int address = kBankAddress * number + f;
      core_.load(axis, address, words.shift, words.word[f]);
      model_.load(number, axis, f, 3, words.shift, words.word[f]);
      core_.load(axis, kDerivativeAddress + address, derivative.shift, derivative.word[f]);
      model_.load_derivative(number, axis, f, 3, derivative.shift, derivative.word[f]);
    }
  }
}

void EvaluatorBench::run(const EvaluatorStimulus& stimulus, Throttle source, Throttle sink,
                         ScheduleRecorder* recorder) {
  write_supports(stimulus.supports);
  const auto start = std::chrono::steady_clock::now();
  const std::size_t first = results_.size();
  simulate(stimulus, source, sink, recorder);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  compare(stimulus, first);
}

void EvaluatorBench::write_supports(const std::vector<SupportWords>& supports) {
  if (supports.empty() || supports.size() > 256) {
    throw std::invalid_argument("an evaluator bench has 1 to 256 supports");
  }
  for (std::size_t s = 0; s < supports.size(); ++s) {
    for (int p = 0; p < 64; ++p) {
      core_.write(static_cast<std::uint8_t>(s), p, &supports[s].points[3 * p],
                  supports[s].exponent);
    }
  }
}

void EvaluatorBench::simulate(const EvaluatorStimulus& stimulus, Throttle& source, Throttle& sink,
                              ScheduleRecorder* recorder) {
  const std::size_t vertices = stimulus.vertices.size();
  std::size_t sent = 0;
  const std::size_t first = results_.size();
  std::uint64_t last_result = clock_;
  bool offered = false;
  while (results_.size() < first + vertices) {
    offered = sent < vertices && (offered || source.willing());
    const bool ready = sink.willing();
    core_.drive_vertex(offered, offered ? pins_of(stimulus, sent) : cores::EvaluatorCore::Vertex{});
    core_.drive_result_ready(ready);
    settle();
    if (recorder != nullptr) recorder->sample(clock_);
    if (offered && core_.vertex_ready()) {
      starts_.push_back(clock_);
      ++sent;
      ++entered_;
      offered = false;
    }
    if (ready && core_.result_valid()) {
      result_clocks_.push_back(clock_);
      ++left_;
      take(core_.result());
      last_result = clock_;
    }
    clock();
    if (clock_ - last_result > kStallLimit) {
      throw std::runtime_error(fmt::format("no result for {} clocks", kStallLimit));
    }
  }
  core_.drive_vertex(false, {});
  core_.drive_result_ready(false);
  for (int i = 0; i < kUntilIdle; ++i) {
    settle();
    clock();
  }
}

/// The core counts who came and who left a clock later, and says "inside" once more.
void EvaluatorBench::settle() {
  core_.settle();
  const bool evaluating = core_.evaluating(), inside = entered_ > left_before_;
  left_before_ = left_;
  if (evaluating == inside || ++mismatches_ > 1) return;
  first_mismatch_ = fmt::format("clock {}: evaluating_o is {}, {} vertices have come, {} have gone",
                                clock_, evaluating ? 1 : 0, entered_, left_);
}

void EvaluatorBench::take(const cores::EvaluatorCore::Result& result) {
  Beat beat = beat_of(result);
  for (unsigned copies = fault_.pass(beat); copies > 0; --copies) {
    results_.push_back(result_of(beat));
    results_.back().along = result.along;
  }
}

void EvaluatorBench::compare(const EvaluatorStimulus& stimulus, std::size_t first) {
  for (std::size_t v = 0; v < stimulus.vertices.size(); ++v) {
    const EvaluatorVertex& vertex = stimulus.vertices[v];
    const cores::EvaluatorCore::Result& got = results_[first + v];
    const bool tag_fits = got.tag == tag_of(v);
    compare_result(stimulus, v, vertex.derivative, {got.words, got.saturated, got.nan}, tag_fits);
    if (vertex.second) {
      compare_result(stimulus, v, vertex.derivative, got.along[0], tag_fits, vertex.second);
    }
    if (!vertex.jacobian) continue;
    for (int axis = 0; axis < 3; ++axis) {
      compare_result(stimulus, v, axis, got.along[axis], tag_fits);
    }
  }
}

void EvaluatorBench::compare_result(const EvaluatorStimulus& stimulus, std::size_t index,
                                    int derivative, const cores::EvaluatorCore::Derivative& got,
                                    bool tag_fits, std::optional<std::uint32_t> second) {
  const EvaluatorVertex& vertex = stimulus.vertices[index];
  const SupportWords& support = stimulus.supports[vertex.support];
  model::VertexWords words{vertex.local, vertex.cell, support.points};
  if (second) words.local[0] = *second;
  words.derivative = derivative;
  words.exponent = support.exponent;
  const model::ResultWords expected = model_.evaluate(vertex.bank, words);
  ++checked_;
  if (got.words == expected.words && got.saturated == expected.saturated &&
      got.nan == expected.nan && tag_fits) {
    return;
  }
  if (++mismatches_ > 1) return;
  first_mismatch_ = fmt::format(
      "vertex {}, bank {}, derivative {}: got {:08x} {:08x} {:08x}, {} tag, expected {:08x} {:08x} "
      "{:08x}",
      index, vertex.bank, derivative, got.words[0], got.words[1], got.words[2],
      tag_fits ? "its" : "another", expected.words[0], expected.words[1], expected.words[2]);
}

double mean_interval(const std::vector<std::uint64_t>& clocks, std::size_t first, int together) {
  const auto round = static_cast<std::size_t>(together);
  if (clocks.size() < first + 1 + round) {
    throw std::out_of_range("an interval needs two events, or a round of them");
  }
  const std::size_t intervals = (clocks.size() - 1 - first) / round * round;
  return static_cast<double>(clocks[first + intervals] - clocks[first]) /
         static_cast<double>(intervals);
}

}  // namespace hwffd::tb
