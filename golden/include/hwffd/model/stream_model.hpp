#pragma once

#include <array>
#include <memory>
#include <vector>

#include "hwffd/model/evaluator.hpp"
#include "hwffd/model/span_table.hpp"
#include "hwffd/stream/beat.hpp"
#include "hwffd/stream/events.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd::model {

/// How often each event of the stream occurred, by its number in `event::Code`.
using StreamEvents = std::array<std::uint64_t, kStreamEvents>;

/// What a core has, as the parameter FEATURES of `hwffd_stream` says it.
enum Feature : std::uint32_t {
  kSpansFeature = 1U << 3,
  kResidentFeature = 1U << 8,
  kInterleavedFeature = 1U << 9,
  kDerivativesFeature = 1U << 10,
  kDeterminantFeature = 1U << 11,
  kAllFeatures = 0xFU << 8,
};

/// The bit-true model of `hwffd_stream`: command beats in, result beats out, bad packets included.
/// docs/interface.md section 2. It knows order and bits, not clocks.
class StreamModel {
 public:
  /// @param features     bits of `Feature`; a packet of what is not there is one of unknown opcode
  /// @param axis_points  of a resident lattice, at most
  /// @param spans        of an axis, more than 1 with `kSpansFeature`
  explicit StreamModel(const Configuration& configuration, std::uint32_t features = kAllFeatures,
                       int axis_points = kAxisPoints, int spans = 1);

  /// Takes one beat of the command stream.
  void accept(const Beat& beat);
  /// Takes a sequence of beats and returns the results that they complete.
  std::vector<Beat> run(const std::vector<Beat>& beats);
  /// The results so far that were not yet taken.
  std::vector<Beat> take_results();
  /// As aresetn: forgets the packet under way, what is loaded, the events and how many vertices.
  void reset();

  const StreamEvents& events() const { return events_; }
  /// Vertices that have given their results, each once however many those are.
  std::uint64_t vertices() const { return vertices_; }

 private:
  enum class State { kHeader, kCoefficients, kSpans, kLattice, kVertex, kPoints, kDone, kDrop };
  using LatticePoint = std::array<std::uint32_t, 3>;

  bool known(const Beat& header) const;
  void header(const Beat& beat);
  bool start_lattice();
  void coefficients(const Beat& beat);
  bool start_spans();
  void span(const Beat& beat);
  void use_spans();
  void lattice_point(const Beat& beat);
  void vertex(const Beat& beat);
  void points(const Beat& beat);
  void check_vertex();
  void gather_support();
  void finish_vertex(bool truncated, bool last);
  Beat blank_result(Beat result) const;
  Beat evaluated(Beat result, int part);
  int header_exponent() const;

  std::unique_ptr<EvaluatorModel> evaluator_;
  std::uint32_t features_;
  int axis_points_;
  SpanTable spans_;
  std::vector<Beat> results_;
  StreamEvents events_{};
  std::uint64_t vertices_ = 0;
  State state_ = State::kHeader;
  Beat header_;
  int beat_ = 0;

  int bank_ = 0;
  bool loaded_ = false;
  bool derivatives_loaded_ = false;  // of the bank in use

  std::array<int, 3> new_dims_{};
  std::vector<LatticePoint> new_lattice_;
  std::array<int, 3> dims_{};
  std::vector<LatticePoint> lattice_;  // empty: none came yet
  int lattice_exponent_ = 0;

  bool resident_ = false;
  Results wanted_ = Results::kPosition;
  std::uint32_t vertices_left_ = 0;
  VertexWords vertex_;
  std::uint16_t tag_ = 0;
  bool nan_ = false;
  bool outside_ = false;  // a coordinate
  bool cell_outside_ = false;
};

}  // namespace hwffd::model
