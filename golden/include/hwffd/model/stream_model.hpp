#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "hwffd/model/evaluator.hpp"
#include "hwffd/model/function_sums.hpp"
#include "hwffd/model/outside.hpp"
#include "hwffd/model/span_table.hpp"
#include "hwffd/stream/beat.hpp"
#include "hwffd/stream/events.hpp"
#include "hwffd/stream/features.hpp"
#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd::model {

/// How often each event of the stream occurred, by its number in `event::Code`.
using StreamEvents = std::array<std::uint64_t, kStreamEvents>;

/// Bits of `Feature` of a core as it comes.
constexpr std::uint32_t kAllFeatures =
    kResidentFeature | kInterleavedFeature | kDerivativesFeature | kDeterminantFeature;

/// The bit-true model of `hwffd_stream`: command beats in, result beats out, bad packets included.
/// docs/interface.md section 2. It knows order and bits, not clocks.
class StreamModel {
 public:
  /// @param features     bits of `Feature`; a packet of what is not there is one of unknown opcode
  /// @param axis_points  of a resident lattice, at most
  /// @param pages        of the point store
  /// @param spans        of an axis, more than 1 with `kSpansFeature`
  /// @param grid_limit   a grid of more than 2^grid_limit vertices is refused
  explicit StreamModel(const Configuration& configuration, std::uint32_t features = kAllFeatures,
                       int axis_points = kAxisPoints, int pages = kPages, int spans = 1,
                       int grid_limit = kGridLimit);

  /// Takes one beat of the command stream.
  void accept(const Beat& beat);
  /// Takes a sequence of beats and returns the results that they complete; faster than one by one.
  std::vector<Beat> run(const std::vector<Beat>& beats);
  /// The results so far that were not yet taken.
  std::vector<Beat> take_results();
  /// As aresetn: forgets the packet under way, what is loaded, the events and how many vertices.
  void reset();

  const StreamEvents& events() const { return events_; }
  /// Those that occurred, as the bits of ERROR_STATUS (docs/registers.md).
  std::uint32_t error_status() const;
  /// Vertices that have given their results, each once however many those are.
  std::uint64_t vertices() const { return vertices_; }

 private:
  enum class State {
    kHeader,
    kCoefficients,
    kSpans,
    kLattice,
    kPart,
    kVertex,
    kPair,
    kGrid,
    kPoints,
    kDone,
    kDrop
  };

  /// A page of the point store.
  struct Page : ResidentPoints {
    bool loaded = false;
    bool fourth = false;
    std::array<int, 3> origin{};  // the cell of the whole lattice at which it begins
  };

  /// Vertices of one page whose results are there but for what the evaluator says.
  struct Waiting {
    const Page* page = nullptr;
    int each = 1;  // results of a vertex
    std::vector<ResidentVertex> vertices;
    std::vector<std::size_t> results;  // of each the place of its first
  };

  void take(const Beat& beat);
  bool has(Feature feature) const { return (features_ & feature) != 0; }
  bool known(const Beat& header) const;
  bool known_of_page(const Beat& header) const;
  bool known_grid(const Beat& header) const;
  bool known_halves(const Beat& header) const;
  bool packed() const;
  std::uint32_t flags() const;
  bool flagged(std::uint32_t flag) const { return (flags() & flag) != 0; }
  void header(const Beat& beat);
  bool start(Opcode opcode, int number);
  bool refuse(event::Code code);
  bool start_lattice(Opcode opcode, int number);
  bool start_part(int number);
  bool start_vertices(Opcode opcode, int number);
  void coefficients(const Beat& beat);
  bool start_spans();
  void span(const Beat& beat);
  void check_sums(int function, bool derivative, const FunctionWords& words);
  void use_spans();
  void lattice_point(const Beat& beat);
  void part_point(const Beat& beat);
  void vertex(const VertexBeat& read, bool last);
  void pair(const Beat& beat);
  void packed_vertex(std::uint64_t bits, bool last);
  void grid_beat(const Beat& beat);
  void grid();
  void points(const Beat& beat);
  void check_vertex();
  bool can_wait() const;
  void wait();
  void evaluate_waiting();
  void put(Beat& result, const ResultWords& words, int components);
  void finish_vertex(bool truncated, bool last);
  void put_half(const Beat& result, bool blank, bool last);
  Beat blank_result(Beat result) const;
  Beat evaluated(Beat result, int part, bool fourth);
  int header_exponent() const;
  /// That opcode 2 fills next: the one of the first two pages that it did not fill last, if there
  /// are two.
  int other_page() const { return pages_.size() > 1 ? 1 - newest_ : 0; }

  std::unique_ptr<EvaluatorModel> evaluator_;
  WordCodec codec_;
  std::uint32_t features_;
  int axis_points_;
  std::vector<Page> pages_;
  int newest_ = 0;         // the page that opcode 2 filled last
  bool turn_ = false;      // a lattice comes by opcode 2
  Page* page_ = nullptr;   // of the packet under way; of vertices, none if there is none
  std::size_t place_ = 0;  // of the next point of a part
  SpanTable spans_;
  int grid_limit_;
  bool sums_wanted_;  // functions must sum to one
  FunctionSums sums_;
  std::vector<Beat> results_;
  StreamEvents events_{};
  std::uint64_t vertices_ = 0;
  std::uint32_t packet_results_ = 0;       // of the packet under way
  std::optional<std::uint64_t> low_half_;  // of a beat of two vertices, the first one
  State state_ = State::kHeader;
  Beat header_;
  int beat_ = 0;

  int bank_ = 0;
  bool loaded_ = false;
  bool derivatives_loaded_ = false;  // of the bank in use

  bool resident_ = false;
  Results wanted_ = Results::kPosition;
  std::uint32_t left_ = 0;  // vertices, points of a part or spans
  std::array<Beat, 4> grid_;
  std::size_t number_ = 0;  // of a packed vertex in its packet
  bool refused_ = false;    // it is no vertex
  VertexWords vertex_;
  Waiting waiting_;
  std::uint16_t tag_ = 0;
  Outside outside_;
};

}  // namespace hwffd::model
