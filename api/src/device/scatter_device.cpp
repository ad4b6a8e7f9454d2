#include "device/scatter_device.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "device/function_words.hpp"
#include "device/gradient_sums.hpp"
#include "device/stream_device.hpp"
#include "hwffd/cores/scatter_core_factory.hpp"
#include "hwffd/error.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/stream/gradients.hpp"

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

  Points run_pull_back(const Index3& dims, const std::vector<Embedded>& vertices,
                       const Points& gradient, const Blending& blending) override {
    if (*std::max_element(dims.begin(), dims.end()) > kAxisPoints) {
      throw Error(fmt::format(
          "{}: a lattice of {} x {} x {} points, and its pages have up to {} an axis; take device "
          "model, which has the same bits",
          name(), dims[0], dims[1], dims[2], kAxisPoints));
    }
    const int width = WordCodec(row_.format).weight_fraction() + 2;
    GradientSums sums(row_.format, width, dims, gradient);
    const auto vertices_of_a_page = static_cast<std::size_t>(model::scatter_exact_vertices(width));
    // A page is collected while the next one fills.
    std::vector<Beat> commands =
        coefficients_packet(function_words(blending, WordCodec(row_.format), row_, name()));
    std::size_t collects = 0;
    for (std::size_t first = 0; first < vertices.size(); first += vertices_of_a_page, ++collects) {
      const std::size_t end = std::min(vertices.size(), first + vertices_of_a_page);
      append_page(commands, static_cast<int>(collects % kPages), dims, vertices, first, end, sums);
    }
    const std::vector<Beat> results = answer(commands, collects * sums.points());
    for (std::size_t r = 0; r < results.size(); ++r) {
      const auto& words = results[r].words;
      sums.add(r % sums.points(), {words[0], words[1], words[2]});
      const bool told = results[r].last && (words[3] & kStatusSaturated) != 0;
      counts_.saturated += told ? 1 : 0;
    }
    return sums.result();
  }

 private:
  [[noreturn]] void evaluates_nothing() const {
    throw Error(name() + ": pulls gradients back, and evaluates nothing; take another device");
  }

  /// Gradients of a page, and its collect.
  void append_page(std::vector<Beat>& commands, int page, const Index3& dims,
                   const std::vector<Embedded>& vertices, std::size_t first, std::size_t end,
                   const GradientSums& sums) const {
    const std::vector<VertexBeat> beats =
        vertex_beats({vertices.begin() + static_cast<std::ptrdiff_t>(first),
                      vertices.begin() + static_cast<std::ptrdiff_t>(end)},
                     WordCodec(row_.format));
    std::vector<GradientBeats> some;
    some.reserve(beats.size());
    for (const VertexBeat& beat : beats) some.push_back({beat, sums.words(first + some.size())});
    Gradients how;
    how.dims = dims;
    append(commands, gradients_packet(page, some, how));
    append(commands, collect_packet(page));
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
