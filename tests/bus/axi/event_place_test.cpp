// Where the first error stands: its beat in a long packet, as the registers tell it.
#include <gtest/gtest.h>

#include "axi_run.hpp"

namespace hwffd::test {
namespace {

class AxiEventPlace : public PerAxiConfiguration {};

// The largest lattice, cut short around every power of two and where all bits alternate.
TEST_P(AxiEventPlace, BeatOfAPacketThatEndsEarly) {
  AxiRun run(GetParam(), 1);
  const std::vector<Beat> whole =
      lattice_packet(random_lattice(run.codec(), run.random(), {16, 16, 16}));
  std::vector<std::uint32_t> beats = {0x555, 0xAAA};
  for (std::uint32_t power = 4; power + 1 < whole.size(); power *= 2) {
    beats.insert(beats.end(), {power - 1, power});
  }
  for (const std::uint32_t beat : beats) {
    ASSERT_TRUE(run.soft_reset());  // packets count from 0
    std::vector<Beat> packet(whole.begin(), whole.begin() + beat + 1);
    packet.back().last = true;
    run.send_bspline();
    run.send(packet);
    ASSERT_TRUE(run.go());
    ASSERT_TRUE(run.only_error({kPacketShort, 1, beat, 0}));
  }
  EXPECT_TRUE(run.ends_well());
}

HWFFD_FOR_EACH_AXI_CONFIGURATION(AxiEventPlace);

}  // namespace
}  // namespace hwffd::test
