#include "grid_stop.hpp"

#include <algorithm>

#include "event_run.hpp"

namespace hwffd::test {

Stopped stopped_at(cores::StreamCore& core, tb::Random& random, const std::vector<Beat>& beats,
                   std::uint64_t at) {
  constexpr std::uint64_t kMost = 100'000;
  const double source = random.pick({1.0, 0.5}), sink = random.pick({1.0, 0.5});
  Stopped out;
  std::size_t taken = 0;
  bool offered = false;
  for (std::uint64_t clock = 0; clock < kMost; ++clock) {
    core.drive_reset(clock < 3);
    offered = clock > 3 && taken < beats.size() && (offered || random.chance(source));
    const bool ready = random.chance(sink);
    core.drive_input(offered, beats[std::min(taken, beats.size() - 1)]);
    core.drive_output_ready(ready);
    core.drive_grid_stop(clock == at);
    core.settle();
    if (clock > 3 && taken == beats.size() && core.idle()) break;
    if (clock > 3) out.refusals += core.events() >> stream_event(event::kGridCount) & 1;
    if (offered && core.input_ready()) {
      ++taken;
      offered = false;
    }
    if (clock > 3 && ready && core.output_valid()) out.results.push_back(core.output());
    core.clock();
  }
  return out;
}

}  // namespace hwffd::test
