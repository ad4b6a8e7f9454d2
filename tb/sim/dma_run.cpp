#include "dma_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "hwffd/cores/axi_core_factory.hpp"
#include "hwffd/driver.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/tb/packet_ring.hpp"
#include "hwffd/tb/scoreboard.hpp"

namespace hwffd::sim {
namespace {

constexpr std::uint64_t kRing = 0x1000'0000;
constexpr std::uint64_t kPackets = 0x2000'0000;
constexpr std::uint64_t kResults = 0x10'0000'0000;
constexpr std::uint64_t kMemoryLatency = 30;    // clocks to the first answer
constexpr std::uint64_t kClocksAPoll = 256;     // between two looks at the registers
constexpr std::uint64_t kStallLimit = 100'000;  // watchdog: clocks without another result

unsigned ring_log2_size(const std::vector<Beat>& packets) {
  const auto count =
      std::count_if(packets.begin(), packets.end(), [](const Beat& b) { return b.last; });
  unsigned log2_size = 1;
  while ((std::int64_t{1} << log2_size) - 1 < count) ++log2_size;
  return log2_size;
}

/// Steps 1 to 5 of docs/registers.md section 4.
void prepare(tb::AxiSystem& system, Driver& driver, const std::vector<Beat>& packets,
             std::uint64_t results) {
  const DescriptorRing ring{kRing, ring_log2_size(packets)};
  const AddressWindow buffers{kPackets, kPackets + packets.size() * cores::kAxiBeatBytes - 1};
  const auto bytes = static_cast<std::uint32_t>(results * cores::kAxiBeatBytes);
  const AddressWindow read{kRing, buffers.limit}, write{kResults, kResults + bytes - 1};
  driver.probe();
  bool first = true;
  for (const Beat& beat : packets) {
    if (first) driver.check(beat.words);
    first = beat.last;
  }
  driver.set_windows(read, write);
  driver.lock_windows();
  system.allow(read, write);
  driver.set_results({kResults, bytes});
  tb::PacketRing packet_ring(system.memory, driver, ring, buffers);
  packet_ring.open();
  packet_ring.put(packets);
}

/// Steps 6 and 7. False: it does not end.
bool start_and_wait(tb::AxiSystem& system, Driver& driver, std::uint64_t results,
                    const std::function<void(double)>& progress) {
  driver.start();
  std::uint32_t seen = 0;
  std::uint64_t since = system.cycle();
  while (!driver.wait_done(1)) {
    system.run(kClocksAPoll);
    const std::uint32_t count = driver.result_count();
    progress(static_cast<double>(count) / static_cast<double>(results));
    if (count != seen) since = system.cycle();
    if (system.cycle() - since > kStallLimit) return false;
    seen = count;
  }
  progress(1);
  return true;
}

/// Step 8: what the registers say against what the model says.
std::string registers_against_model(Driver& driver, const model::StreamModel& model,
                                    std::uint64_t results) {
  const std::uint32_t status = model.error_status();
  const CoreErrors errors = driver.take_errors();
  std::string text;
  if (errors.status != status) {
    text += fmt::format("ERROR_STATUS is {:08x}, the model's {:08x}\n", errors.status, status);
  }
  const std::uint64_t vertices = driver.counters().vertices;
  if (driver.result_count() != results || vertices != model.vertices()) {
    text += fmt::format("{} results in memory, {} expected; {} vertices counted, {} expected\n",
                        driver.result_count(), results, vertices, model.vertices());
  }
  return text;
}

void compare(DmaRun& run, const tb::AxiSystem& system, const std::vector<Beat>& expected,
             const tb::TestIdentity& test) {
  tb::Scoreboard scoreboard(test);
  scoreboard.expect(expected);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    run.results.push_back(
        {system.memory.beat(kResults + i * cores::kAxiBeatBytes), expected[i].last});
    scoreboard.receive(run.results.back(), system.cycle());
  }
  scoreboard.finish();
  run.checked = scoreboard.checked();
  run.mismatches = scoreboard.mismatches();
  for (const std::string& report : scoreboard.reports()) run.failure += report + "\n";
}

}  // namespace

DmaRun run_dma(const Configuration& row, const std::vector<Beat>& packets,
               const tb::TestIdentity& test, const std::string& waveform,
               const std::function<void(double)>& progress) {
  model::StreamModel model(row);
  const std::vector<Beat> expected = model.run(packets);
  const auto core = cores::make_axi_core(row, test.seed, waveform);
  tb::AxiSystem system(*core, test.seed);
  system.memory.set_latency({kMemoryLatency, kMemoryLatency});
  Driver driver(system);
  DmaRun run;
  try {
    prepare(system, driver, packets, expected.size());
    if (!start_and_wait(system, driver, expected.size(), progress)) {
      run.failure = fmt::format("no result in {} clocks\n", kStallLimit);
    }
    run.failure += registers_against_model(driver, model, expected.size());
  } catch (const DriverError& error) {
    run.failure += fmt::format("driver: {}\n", error.what());
  }
  run.failure += system.faults();
  compare(run, system, expected, test);
  run.bus = system.utilisation();
  if (expected.size() > 1) {
    run.clocks_per_result = static_cast<double>(run.bus.last_write - run.bus.first_write) /
                            static_cast<double>(expected.size() - 1);
  }
  if (!run.failure.empty()) run.failure += "replay   " + tb::replay_command(test);
  return run;
}

}  // namespace hwffd::sim
