// ffd_mem_sdp with a registered read, as simulators have it: what is undefined in hardware is wrong
// here.
#include <gtest/gtest.h>

#include <array>

#include "Vmem_sdp.h"
#include "Vmem_sdp_twelve.h"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint32_t kDepth = 16;

TEST(Memory, AReadOfTheWordBeingWrittenGivesTheComplement) {
  tb::Sim<Vmem_sdp> sim(1);
  tb::Random random(1);
  std::array<std::uint32_t, kDepth> words{};
  for (std::uint32_t address = 0; address < kDepth; ++address) {
    sim->write_i = 1;
    sim->write_address_i = address;
    sim->write_data_i = words[address] = random.word();
    sim.tick();
  }
  int clashes = 0;
  for (int i = 0; i < 10000; ++i) {
    const std::uint32_t read = random.word() % kDepth;
    const std::uint32_t written = random.word() % kDepth;
    const bool write = random.word() % 2 != 0;
    const bool clash = write && read == written;
    sim->write_i = write;
    sim->write_address_i = written;
    sim->write_data_i = random.word();
    sim->read_address_i = read;
    sim.tick();
    ASSERT_EQ(sim->read_data_o, clash ? ~words[read] : words[read]);
    if (write) words[written] = sim->write_data_i;
    clashes += clash ? 1 : 0;
  }
  EXPECT_GT(clashes, 100);
}

/// The simulation ends where an assertion fails.
TEST(Memory, AWordBeyondTheLastEndsTheSimulation) {
  constexpr std::uint32_t kTwelve = 12, kClocks = 100;
  tb::Sim<Vmem_sdp_twelve> sim(1);
  sim->write_i = 1;
  for (std::uint32_t clock = 0; clock < kClocks; ++clock) {
    sim->write_address_i = clock % kTwelve;
    sim.tick();
  }
  sim->write_address_i = kTwelve;
  EXPECT_DEATH(sim.tick(), "");
}

}  // namespace
}  // namespace hwffd::test
