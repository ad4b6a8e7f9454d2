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

constexpr std::size_t kStepsSeen = 100;  // of progress

class ScatterDevice final : public Device {
 public:
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

    std::size_t count = 0;
    for (const LatticePage* page : collects) count += page->lattice.points.size();
    const std::vector<Beat> results = answer(commands, count);
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
    return sums.result();
  }

 private:
  [[noreturn]] void evaluates_nothing() const {
    throw Error(name() + ": pulls gradients back, and evaluates nothing; take another device");
  }

  /// The results of commands that have so many, each of a point, the tags of a page in order.
  std::vector<Beat> answer(const std::vector<Beat>& commands, std::size_t count) {
    if (count == 0) return {};
    std::vector<Beat> results;
    try {
      results = stream_->run(
          commands, count, [&](double done) { show(done); }, shows() ? kStepsSeen : 1);
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
      stream_->reset();
      throw;
    }
    counts_.clocks = stream_->clocks();
    return results;
  }

  Configuration row_ = find_configuration(cores::kScatterRow);
  std::unique_ptr<CommandStream> stream_ = rtl_scatter_stream("rtl scatter-fx17");
};

}  // namespace

std::unique_ptr<Device> scatter_device() { return std::make_unique<ScatterDevice>(); }

}  // namespace hwffd
