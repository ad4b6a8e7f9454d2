#include "grid_stop.hpp"

#include <fmt/format.h>

namespace hwffd::test {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;

namespace {

constexpr int kGridPage = 1;
constexpr std::uint32_t kGridPacket = 2;  // behind functions and lattice

/// The events of a run: a stopped grid, and what the model says of saturated results.
AssertionResult errors_are(AxiRun& run, const GridStop& stop, std::uint64_t saturated) {
  const CoreErrors errors = run.driver().take_errors();
  const std::uint32_t status =
      (stop.stopped ? 1U << kGridCount : 0) | (saturated != 0 ? 1U << kSaturated : 0);
  const std::uint64_t count = saturated + (stop.stopped ? 1 : 0);
  run.driver().clear_counters();
  if (errors.status != status || errors.count != count) {
    return AssertionFailure() << fmt::format("status {:x}, {} errors, wanted {:x}, {}",
                                             errors.status, errors.count, status, count);
  }
  // A result that saturates has no place of its own.
  if (!stop.stopped || errors.first->code != kGridCount) return ::testing::AssertionSuccess();
  if (errors.first->packet == kGridPacket && errors.first->beat == stop.vertices)
    return ::testing::AssertionSuccess();
  return AssertionFailure() << fmt::format("told at beat {} of packet {}, not at {} of {}",
                                           errors.first->beat, errors.first->packet, stop.vertices,
                                           kGridPacket);
}

}  // namespace

AssertionResult stop_grid_at(AxiRun& run, GridStore store, const Grid& grid, std::uint64_t clock,
                             GridStop& stop) {
  const bool pages = store == GridStore::kPage;
  const auto packet_of = [&](const std::vector<VertexBeat>& vertices) {
    return pages ? page_vertices_packet(kGridPage, vertices) : vertices_packet(vertices);
  };
  if (const AssertionResult reset = run.soft_reset(); !reset) return reset;
  run.driver().clear_counters();
  const std::uint64_t saturated = run.model().events()[kSaturated];
  const LatticeWords lattice = random_lattice(run.codec(), run.random(), 6);
  run.send_bspline();
  run.send(pages ? page_packet(kGridPage, lattice) : lattice_packet(lattice));
  const std::vector<Beat> behind =
      packet_of(random_vertices(run.codec(), run.random(), lattice.dims, kBehindGrid));
  run.ring().put(grid_packet(grid, pages ? kGridPage : 0));
  run.ring().put(behind);
  run.start(vertex_count(grid) + kBehindGrid);
  run.system().run(clock);
  stop.before = run.driver().result_count();
  run.driver().stop_grid();
  const std::uint64_t at = run.system().cycle();
  if (const AssertionResult ended = run.wait(); !ended) return ended;
  stop.clocks = run.system().cycle() - at;

  const std::uint32_t count = run.driver().result_count();
  if (count <= kBehindGrid || count > vertex_count(grid) + kBehindGrid)
    return AssertionFailure() << count << " results of a grid and " << kBehindGrid << " vertices";
  stop.vertices = count - kBehindGrid;
  stop.stopped = stop.vertices < vertex_count(grid);
  std::vector<VertexBeat> vertices = grid_vertices(grid, lattice.dims, run.codec());
  vertices.resize(stop.vertices);
  run.expect(packet_of(vertices));
  run.expect(behind);
  if (const AssertionResult exact = run.finish(); !exact) return exact;
  if (run.driver().counters().vertices != count)
    return AssertionFailure() << run.driver().counters().vertices << " vertices, not " << count;
  const std::uint32_t status = run.system().read32(HWFFD_STATUS_OFFSET);
  if ((status & (HWFFD_STATUS_BUSY_MASK | HWFFD_STATUS_IDLE_MASK)) != HWFFD_STATUS_IDLE_MASK)
    return AssertionFailure() << fmt::format("not idle: status {:x}", status);
  return errors_are(run, stop, run.model().events()[kSaturated] - saturated);
}

}  // namespace hwffd::test
