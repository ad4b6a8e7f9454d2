// hwffd_axi with HARDENED: a bit that flips between the check of an address and the bus goes no
// further, a burst that ends too early is completed, copies are outvoted, and UPSET_STATUS tells.
#include <gtest/gtest.h>
#include <verilated_syms.h>

#include "Vaxi_hardened128.h"
#include "axi_run.hpp"
#include "hwffd/cores/verilated_axi_core.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kMoments = 400;  // clocks after the start
constexpr std::uint32_t kAll = HWFFD_UPSET_STATUS_MEMORY_MASK | HWFFD_UPSET_STATUS_STATE_MASK |
                               HWFFD_UPSET_STATUS_WINDOW_MASK | HWFFD_UPSET_STATUS_BURST_MASK |
                               HWFFD_UPSET_STATUS_COPY_MASK;

const Configuration& hardened_row() { return find_configuration("basic-fx18-overlapped"); }

struct Register {
  std::string instance;
  unsigned bits;
};

/// A core whose registers may be written (hardened.vlt), and what works it.
class Hardened {
 public:
  explicit Hardened(std::uint64_t seed) : Hardened(seed, std::make_unique<Core>(seed)) {}
  AxiRun* operator->() { return &run_; }

  /// Inverts a bit of a register of the DMA.
  void flip(const std::string& module, const char* name, unsigned bit) {
    flip_at("TOP.hwffd_axi.u_core.u_dma." + module, name, bit);
  }
  void flip_at(const std::string& instance, const char* name, unsigned bit) {
    const VerilatedScope* scope = core_.dut().contextp()->scopeFind(instance.c_str());
    ASSERT_NE(scope, nullptr) << instance;
    auto* bytes = static_cast<std::uint8_t*>(scope->varFind(name)->datap());
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
  }
  /// Instances that have such a register.
  std::vector<Register> registers(const std::string& name) {
    std::vector<Register> matches;
    for (const auto& [instance, scope] : *core_.dut().contextp()->scopeNameMap()) {
      const VerilatedVar* var = scope->varFind(name.c_str());
      if (var != nullptr)
        matches.push_back({instance, static_cast<unsigned>(var->packed().elements())});
    }
    return matches;
  }
  std::uint32_t upsets() { return run_.system().read32(HWFFD_UPSET_STATUS_OFFSET); }
  /// Each bit is cleared by a one, and by nothing else.
  void clear(std::uint32_t upset_bits) {
    run_.system().write32(HWFFD_UPSET_STATUS_OFFSET, kAll & ~upset_bits);
    EXPECT_EQ(upsets(), upset_bits);
    run_.system().write32(HWFFD_UPSET_STATUS_OFFSET, upset_bits);
    EXPECT_EQ(upsets(), 0U);
  }
  /// As a driver does after an error; then the core works as new.
  void expect_next() {
    ASSERT_TRUE(run_.soft_reset());
    run_.driver().take_errors();
    EXPECT_TRUE(run_.ends_well());
    EXPECT_EQ(upsets(), 0U);
  }
  std::uint64_t writes_outside() {
    std::uint64_t count = 0;
    for (const tb::AxiMemory::Burst& burst : run_.system().memory.writes()) {
      count += burst.address < kWriteWindow.base || burst.address > kWriteWindow.limit ? 1 : 0;
    }
    return count;
  }

 private:
  using Core = cores::VerilatedAxiCore<Vaxi_hardened128>;
  Hardened(std::uint64_t seed, std::unique_ptr<Core> core)
      : core_(*core), run_(hardened_row(), std::move(core), seed) {}

  Core& core_;
  AxiRun run_;
};

/// In how many of these runs UPSET_STATUS has the bit after the flip, which it has alone.
std::uint64_t flips_reported(const std::string& module, const char* name, unsigned bit,
                             std::uint32_t mask) {
  std::uint64_t reported = 0;
  for (std::uint64_t clock = 0; clock < kMoments; clock += 7) {
    SCOPED_TRACE(testing::Message() << name << " " << clock << " clocks after the start");
    Hardened run(1);
    run->send_scene(20);
    run->start();
    run->system().run(clock + 300);
    run.flip(module, name, bit);
    run->driver().wait_done(3000);
    const std::uint32_t upsets = run.upsets();
    EXPECT_EQ(upsets & ~mask, 0U);
    EXPECT_EQ(run.writes_outside(), 0U);
    EXPECT_FALSE(run->system().memory.writes().empty());
    if (upsets != 0) run.clear(upsets);
    reported += upsets != 0 ? 1 : 0;
    run.expect_next();
    if (testing::Test::HasFailure()) break;
  }
  return reported;
}

TEST(AxiHardened, AnAddressThatFlipsBehindItsCheckIsRefused) {
  EXPECT_GT(flips_reported("u_write.u_address", "next_q", 39, HWFFD_UPSET_STATUS_WINDOW_MASK), 0U);
}

TEST(AxiHardened, ABurstOfTooFewOrTooManyBeatsIsCompleted) {
  EXPECT_GT(flips_reported("u_write", "left_q", 7, HWFFD_UPSET_STATUS_BURST_MASK), 0U);
}

TEST(AxiHardened, AWindowThatFlipsIsOutvoted) {
  for (const char* copy : {"gen_window[0]", "gen_window[1]"}) {
    Hardened run(2);
    ASSERT_TRUE(run->good_run());
    EXPECT_EQ(run.upsets(), 0U);
    run.flip(std::string("u_guard.gen_guard.u_write.") + copy + ".u_copy", "q_o", 44);
    run->system().run(2);
    EXPECT_EQ(run.upsets(), HWFFD_UPSET_STATUS_COPY_MASK);
    run.clear(HWFFD_UPSET_STATUS_COPY_MASK);
    EXPECT_TRUE(run->ends_well());
  }
}

/// Of windows, of what is open on the bus, of the burst that is checked, of the reset inside and of
/// the count that clears the registers.
TEST(AxiHardened, AnyBitOfACopyIsOutvoted) {
  Hardened run(4);
  ASSERT_TRUE(run->good_run());
  unsigned bits = 0;
  for (const Register& copy : run.registers("q_o")) {
    for (unsigned bit = 0; bit < copy.bits; ++bit) {
      run.flip_at(copy.instance, "q_o", bit);
      run->system().run(2);
      ASSERT_EQ(run.upsets(), HWFFD_UPSET_STATUS_COPY_MASK) << copy.instance << ", bit " << bit;
      run->system().write32(HWFFD_UPSET_STATUS_OFFSET, HWFFD_UPSET_STATUS_COPY_MASK);
      ++bits;
    }
  }
  EXPECT_GT(bits, 1000U);
  EXPECT_EQ(run.upsets(), 0U);
  EXPECT_TRUE(run->ends_well());
}

TEST(AxiHardened, CopiesFlipWhileResultsComeAndAllAreRight) {
  Hardened run(5);
  const std::vector<Register> copies = run.registers("q_o");
  run->send_scene(300);
  run->start();
  unsigned flips = 0;
  for (; run->results_in_memory() < 290; ++flips) {
    const Register& copy = copies[run->random().below(copies.size())];
    run.flip_at(copy.instance, "q_o", static_cast<unsigned>(run->random().below(copy.bits)));
    run->system().run(1 + run->random().below(20));
    ASSERT_LT(flips, 10'000U);
  }
  EXPECT_GT(flips, 100U);
  ASSERT_TRUE(run->finish());
  EXPECT_EQ(run.upsets(), HWFFD_UPSET_STATUS_COPY_MASK);
  run.clear(HWFFD_UPSET_STATUS_COPY_MASK);
  EXPECT_TRUE(run->ends_well());
}

/// The one of three that believes in a request which nobody made is reset.
TEST(AxiHardened, ASlaveOfTheRegistersIsOutvoted) {
  Hardened run(6);
  const std::vector<Register> slaves = run.registers("aw_held_q");
  EXPECT_EQ(slaves.size(), 3U);
  for (const Register& slave : slaves) {
    run.flip_at(slave.instance, "aw_held_q", 0);
    run->system().run(4);
    EXPECT_EQ(run.upsets(), HWFFD_UPSET_STATUS_COPY_MASK) << slave.instance;
    run.clear(HWFFD_UPSET_STATUS_COPY_MASK);
  }
  EXPECT_TRUE(run->ends_well());
}

TEST(AxiHardened, RegistersAreWordsOfBytes) {
  Hardened run(7);
  expect_words_and_bytes(run->system());
  EXPECT_TRUE(run->ends_well());
}

/// Without HARDENED there is no such word.
TEST(AxiHardened, APlainCoreTellsOfNone) {
  AxiRun run(hardened_row(), 3);
  EXPECT_EQ(run.system().read32(HWFFD_LIMITS2_OFFSET) & HWFFD_LIMITS2_HARDENED_MASK, 0U);
  EXPECT_THROW(run.system().read32(HWFFD_UPSET_STATUS_OFFSET), RegisterError);
  EXPECT_EQ(run.system().try_write(HWFFD_UPSET_STATUS_OFFSET, kAll), cores::kSlvErr);
}

}  // namespace
}  // namespace hwffd::test
