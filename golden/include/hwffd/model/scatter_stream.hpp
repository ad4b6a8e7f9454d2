#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hwffd/model/function_sums.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/stream/beat.hpp"
#include "hwffd/stream/gradients.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd::model {

/// A pulse of an event of `hwffd_scatter`, and its place. That of event::kSaturated and of
/// event::kPageOverflowed is what the model reads then; a core, whose vertices take their time, has
/// another.
struct ScatterEvent {
  unsigned event = 0;        ///< bit of event_o
  std::uint32_t packet = 0;  ///< since reset, from 0
  std::uint32_t beat = 0;    ///< of which the header is 0
};

/// The bit-true model of `hwffd_scatter`: command beats in, result beats out, bad packets included.
/// docs/interface.md section 2, opcodes 1, 10 and 11. It knows order and bits, not clocks: a vertex
/// adds at once, or with its row, and nothing waits.
class ScatterStreamModel {
 public:
  /// @param row          an organization that has a transpose, whose weights are those
  /// @param axis_points  of a page, at most; up to `kSmallAxisPoints`
  /// @param rows         whether grids go by rows, and a vertex of a list is a row by itself
  /// @throws std::invalid_argument as `make_scatter_model`, or for more points an axis
  explicit ScatterStreamModel(const Configuration& row, int axis_points = kAxisPoints,
                              int pages = kPages, bool rows = false);

  /// Takes one beat of the command stream.
  void accept(const Beat& beat);
  /// Takes a sequence of beats and returns the results that they complete.
  std::vector<Beat> run(const std::vector<Beat>& beats);
  /// The results so far that were not yet taken.
  std::vector<Beat> take_results() { return std::exchange(results_, {}); }
  /// As aresetn: all sums are zero, and nothing is loaded.
  void reset();

  /// All pulses since reset, in the order of what is read; of one beat in that of their bits.
  const std::vector<ScatterEvent>& events() const { return events_; }
  /// Vertices that have added since reset, to any page.
  std::uint64_t vertices() const { return vertices_; }

 private:
  enum class State { kHeader, kCoefficients, kAxes, kVertex, kGradient, kDone, kDrop };

  /// A page that is not zero, or has been told its points an axis.
  struct Page {
    std::array<int, 3> dims{};
    ScatterPage sums;
  };

  /// The vertices of a grid, those that come first.
  struct GridVertices {
    Grid grid;
    std::array<std::uint32_t, 3> next{};
  };

  void header(const Beat& beat);
  bool start();
  bool start_gradients();
  bool start_collect();
  void coefficients(const Beat& beat);
  void axis(const Beat& beat);
  void gradient(const Beat& beat);
  VertexBeat next_of_grid();
  void add(const VertexBeat& vertex, const Beat& gradient);
  void end_row();
  void collect(Page& page);
  bool refuse(unsigned event);
  void tell(unsigned event, bool occurs = true);
  std::uint32_t flags() const { return header_.words[0] & 0xFFFF0000; }
  std::size_t page_number() const { return header_.words[0] >> 8 & 0xFF; }

  std::unique_ptr<ScatterModel> scatter_;
  WordCodec codec_;
  int axis_points_;
  std::optional<ScatterRow> row_;  // of a core with rows
  bool sums_wanted_;               // functions must sum to one
  FunctionSums sums_;
  std::array<AxisWords, 3> next_functions_{};  // of the packet under way
  bool loaded_ = false;
  bool derivatives_loaded_ = false;

  std::vector<std::optional<Page>> pages_;
  Page* page_ = nullptr;  // of the packet under way
  std::vector<Beat> results_;
  std::vector<ScatterEvent> events_;
  std::uint64_t vertices_ = 0;

  State state_ = State::kHeader;
  std::uint32_t packet_ = 0;
  std::uint32_t beat_ = 0;  // of the packet
  Beat header_;
  std::array<Beat, 4> axes_{};
  std::optional<GridVertices> grid_;
  VertexBeat vertex_;
  std::uint64_t left_ = 0;  // vertices
};

}  // namespace hwffd::model
