#include "device/scatter_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "device/function_words.hpp"
#include "device/gradient_sums.hpp"
#include "device/stream_device.hpp"
#include "hwffd/cores/scatter_core_factory.hpp"
#include "hwffd/error.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/stream/gradients.hpp"
#include "hwffd/stream/large_lattice.hpp"

namespace hwffd {
namespace {

class ScatterDevice final : public Device {
 public:
  explicit ScatterDevice(bool rows) : rows_(rows) {}

  std::string name() const override { return "rtl scatter-fx17"; }

 protected:
  Points run(const Lattice& /*lattice*/, const std::vector<Embedded>& /*vertices*/,
             const Blending& /*blending*/) override {
    evaluates_nothing();
  }
  Points run(const std::vector<SupportedVertex>& /*vertices*/,
             const Blending& /*blending*/) override {
    evaluates_nothing();
  }
  Tangents run_tangents(const Lattice& /*lattice*/, const std::vector<Embedded>& /*vertices*/,
                        const Blending& /*blending*/) override {
    evaluates_nothing();
  }

  /// A lattice that is larger than a page of the core goes there in parts, whose sums are added.
  Points run_pull_back(const Index3& dims, const std::vector<Embedded>& vertices,
                       const Points& gradient, const Blending& blending) override {
    const WordCodec codec(row_.format);
    const int width = codec.weight_fraction() + 2;
    GradientSums sums(row_.format, width, dims, gradient);
    const std::vector<LatticePage> pages =
        pages_of({dims, std::vector<std::array<std::uint32_t, 3>>(sums.points())});
    const PagedVertices paged = by_page(vertex_beats(vertices, codec), dims);
    const auto most = static_cast<std::size_t>(model::scatter_exact_vertices(width));

    std::vector<Beat> commands = coefficients_packet(function_words(blending, codec, row_, name()));
    std::vector<const LatticePage*> collects;
    std::size_t sent = 0;
    for (const std::size_t p : paged.sent) {
      const std::vector<VertexBeat>& of_page = paged.of_page[p];
      Gradients how;
      how.dims = pages[p].lattice.dims;
      for (std::size_t first = 0; first < of_page.size(); first += most) {
        std::vector<GradientBeats> some;
        for (std::size_t v = first; v < std::min(of_page.size(), first + most); ++v) {
          some.push_back({of_page[v], sums.words(paged.from[sent++])});
        }
        // One is collected while the next one fills.
        const int page = static_cast<int>(collects.size() % kPages);
        append(commands, gradients_packet(page, some, how));
        append(commands, collect_packet(page));
        collects.push_back(&pages[p]);
      }
    }

    add_collected(vertex_core(), commands, collects, dims, sums);
    return sums.result();
  }

  /// By rows: slices, or rows of one, as many as a page of the core adds up exactly. No row is cut.
  Points run_pull_back_grid(const Index3& dims, const Grid& grid, const Points& gradient,
                            const Blending& blending) override {
    if (!rows_) return Device::run_pull_back_grid(dims, grid, gradient, blending);
    const WordCodec codec(row_.format);
    const int width = codec.weight_fraction() + 2;
    const std::int64_t most = model::scatter_exact_vertices(width);
    if (*std::max_element(dims.begin(), dims.end()) > cores::kScatterRowsAxis ||
        grid.count[0] > most) {
      throw Error(fmt::format(
          "{}: takes by rows lattices of up to {} points an axis, and rows of up to {} vertices; "
          "take the device model",
          name(), cores::kScatterRowsAxis, most));
    }
    GradientSums sums(row_.format, width, dims, gradient);
    const LatticePage whole{{}, {dims, std::vector<std::array<std::uint32_t, 3>>(sums.points())}};
    Gradients how;
    how.dims = dims;

    std::vector<Beat> commands = coefficients_packet(function_words(blending, codec, row_, name()));
    std::vector<const LatticePage*> collects;
    std::size_t sent = 0;
    const auto rows = static_cast<std::uint32_t>(most / grid.count[0]);  // of a page
    const std::uint32_t slices = std::max(1U, rows / grid.count[1]);
    for (std::uint32_t k = 0; k < grid.count[2]; k += slices) {
      for (std::uint32_t j = 0; j < grid.count[1]; j += rows) {
        Grid some = grid;
        some.start[1] += static_cast<std::uint64_t>(grid.step[1]) * j;
        some.start[2] += static_cast<std::uint64_t>(grid.step[2]) * k;
        some.count[1] =
            static_cast<std::uint16_t>(std::min<std::uint32_t>(rows, grid.count[1] - j));
        some.count[2] =
            static_cast<std::uint16_t>(std::min<std::uint32_t>(slices, grid.count[2] - k));
        std::vector<std::array<std::uint32_t, 3>> words;
        for (std::size_t v = 0; v < vertex_count(some); ++v) words.push_back(sums.words(sent++));
        const int page = static_cast<int>(collects.size() % kPages);
        append(commands, gradients_packet(page, some, words, how));
        append(commands, collect_packet(page));
        collects.push_back(&whole);
      }
    }
    add_collected(row_core(), commands, collects, dims, sums);
    return sums.result();
  }

 private:
  /// Adds what a core collects, of a lattice page by page.
  void add_collected(CommandStream& core, const std::vector<Beat>& commands,
                     const std::vector<const LatticePage*>& collects, const Index3& dims,
                     GradientSums& sums) {
    std::size_t count = 0;
    for (const LatticePage* page : collects) count += page->lattice.points.size();
    const std::vector<Beat> results = answer(core, commands, count);
    auto result = results.begin();
    for (const LatticePage* page : collects) {
      for (const Index3& at : places(page->lattice.dims)) {
        const Index3& from = page->origin;
        const int row = (from[0] + at[0]) * dims[1] + from[1] + at[1];
        const int point = row * dims[2] + from[2] + at[2];
        sums.add(static_cast<std::size_t>(point),
                 {result->words[0], result->words[1], result->words[2]});
        ++result;
      }
      counts_.saturated += (std::prev(result)->words[3] & kStatusSaturated) != 0 ? 1 : 0;
    }
  }

  [[noreturn]] void evaluates_nothing() const {
    throw Error(name() + ": pulls gradients back, and evaluates nothing; take another device");
  }

  /// The results of commands that have so many, each of a point, the tags of a page in order.
  std::vector<Beat> answer(CommandStream& core, const std::vector<Beat>& commands,
                           std::size_t count) {
    if (count == 0) return {};
    std::vector<Beat> results;
    try {
      results = core.run(
          commands, count, [&](double done) { show(done); },
          shows() ? CommandStream::kStepsSeen : 1);
      std::uint32_t tag = 0;
      bool asked_for = results.size() == count;
      for (const Beat& result : results) {
        asked_for = asked_for && (result.words[3] & ~kStatusSaturated) == tag;
        tag = result.last ? 0 : (tag + 1) & kTagMask;
      }
      if (!asked_for) {
        throw Error(fmt::format(
            "{}: {} results for {} points, or others; this is a fault of the hardware: please "
            "report it",
            name(), results.size(), count));
      }
    } catch (...) {
      core.reset();
      throw;
    }
    counts_.clocks = (vertices_ ? vertices_->clocks() : 0) + (grids_ ? grids_->clocks() : 0);
    return results;
  }

  CommandStream& vertex_core() { return ready(vertices_, false); }
  CommandStream& row_core() { return ready(grids_, true); }
  /// A core that is made when it is first asked for.
  CommandStream& ready(std::unique_ptr<CommandStream>& core, bool rows) const {
    if (!core) core = rtl_scatter_stream(rows, name());
    return *core;
  }

  Configuration row_ = find_configuration(cores::kScatterRow);
  bool rows_;
  std::unique_ptr<CommandStream> vertices_, grids_;
};

}  // namespace

std::unique_ptr<Device> scatter_device(bool rows) { return std::make_unique<ScatterDevice>(rows); }

}  // namespace hwffd
