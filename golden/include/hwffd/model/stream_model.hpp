#pragma once

#include <memory>
#include <vector>

#include "hwffd/model/evaluator.hpp"
#include "hwffd/stream/beat.hpp"

namespace hwffd::model {

/// The bit-true model of `hwffd_stream`: command beats in, result beats out, bad packets included.
/// docs/interface.md section 2. It knows order and bits, not clocks.
class StreamModel {
 public:
  explicit StreamModel(const Configuration& configuration);

  /// Takes one beat of the command stream.
  void accept(const Beat& beat);
  /// Takes a sequence of beats and returns the results that they complete.
  std::vector<Beat> run(const std::vector<Beat>& beats);
  /// The results so far that were not yet taken.
  std::vector<Beat> take_results();
  /// As aresetn: forgets the packet under way, which bank is in use and that it was loaded.
  void reset();

 private:
  enum class State { kHeader, kCoefficients, kVertex, kPoints, kDrop };

  void header(const Beat& beat);
  void coefficients(const Beat& beat);
  void points(const Beat& beat);
  void finish_vertex(bool truncated, bool last);

  std::unique_ptr<EvaluatorModel> evaluator_;
  std::vector<Beat> results_;
  State state_ = State::kHeader;
  int bank_ = 0;
  bool loaded_ = false;
  Beat header_;
  std::uint32_t vertices_left_ = 0;
  int beat_ = 0;
  VertexWords vertex_;
  std::uint16_t tag_ = 0;
};

}  // namespace hwffd::model
