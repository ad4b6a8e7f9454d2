// The registers behind Wishbone: random accesses with byte selects, unaligned and to addresses
// where nothing is, given up and reset in their midst. Every answer, and all outputs in every
// clock, are the model's, which is that of AXI4-Lite.
#include "hwffd/registers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "Vbus_registers.h"
#include "Vwb_slave.h"
#include "hwffd/tb/sim.hpp"
#include "register_traffic.hpp"
#include "register_words.hpp"
#include "wishbone_master.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kAccesses = 6'000;
constexpr unsigned kLatency = 3;     // clocks from stb to ack
constexpr unsigned kStartup = 18;    // clocks after reset in which none is answered
constexpr std::uint64_t kMost = 20;  // failures that are told

class WishboneBench {
 public:
  explicit WishboneBench(std::uint64_t seed, double willing = 1)
      : registers_(seed, 1'000'000),
        slave_(tb::derive_seed(seed, 1)),
        master_(tb::derive_seed(seed, 2), willing),
        input_ports_(hardware_ports(*registers_.dut().contextp(), "_i")),
        output_ports_(hardware_ports(*registers_.dut().contextp(), "_o")) {
    for (const auto& [name, port] : input_ports_) inputs_[name] = 0;
    reset(2);
  }

  void reset(unsigned clocks) {
    master_.clear();
    in_reset_ = true;
    for (unsigned i = 0; i < clocks; ++i) step();
    in_reset_ = false;
    model_.reset();
    acted_.reset();
    inside_.reset();
    known_ = false;
  }

  void step() {
    const cores::WishboneMasterPins& pins = master_.drive();
    auto& registers = registers_.dut();
    auto& slave = slave_.dut();
    registers.rst = in_reset_ ? 1 : 0;
    registers.eval();
    slave.rst = registers.s_clearing;
    cores::drive_pins(slave, pins);
    inputs_["error_any_i"] = inputs_.at("error_event_i") != 0;
    for (const auto& [name, port] : input_ports_) port.drive(inputs_.at(name));
    slave.eval();
    connect_words(slave, registers);
    registers.eval();
    connect_answers(registers, slave);
    slave.eval();
    cores::WishboneSlavePins answer;
    cores::sample_pins(slave, answer);
    if (!in_reset_) follow(pins, answer);
    if (master_.accept(answer)) {
      ++answered_;
      last_ = answer;
      latency_ = waited_;
    }
    registers_.tick();
    slave_.tick();
  }

  WishboneMaster& master() { return master_; }
  PortValues& inputs() { return inputs_; }
  const HardwarePorts& input_ports() const { return input_ports_; }
  const std::vector<std::string>& failures() const { return failures_; }
  std::uint64_t answered() const { return answered_; }
  std::uint64_t errors() const { return errors_; }
  std::uint64_t acted_unheard() const { return unheard_; }
  const cores::WishboneSlavePins& last() const { return last_; }
  unsigned latency() const { return latency_; }
  const RegisterModel& model() const { return model_; }

  cores::WishboneSlavePins access(const WishboneAccess& access) {
    master_.ask(access);
    for (unsigned i = 0; i < 100 && !master_.idle(); ++i) step();
    EXPECT_TRUE(master_.idle());
    return last_;
  }

 private:
  void fail(const std::string& what) {
    if (failures_.size() < kMost) failures_.push_back(what);
  }

  /// What acted in the clock before shows now: answer and outputs. What acts in this clock is
  /// compared with what the master has on the bus.
  void follow(const cores::WishboneMasterPins& pins, const cores::WishboneSlavePins& answer) {
    std::optional<tb::AxiLiteWrite> write;
    std::optional<std::uint32_t> read;
    if (acted_ && acted_->write) write = {acted_->address, acted_->data, acted_->select};
    if (acted_ && !acted_->write) read = acted_->address;
    if (known_) {
      const auto answers = model_.clock(was_inputs_, write, read);
      const auto expected = write ? answers.write : answers.read;
      const bool error = acted_ && expected.code != cores::kOkay;
      const bool heard = acted_ && wanted_;
      if (answer.ack != (heard && !error) || answer.err != (heard && error) ||
          (heard && answer.dat != expected.data)) {
        fail(fmt::format("answer {} {} {:08x}, expected {} {} {:08x}", answer.ack, answer.err,
                         answer.dat, heard && !error, heard && error, expected.data));
      }
      errors_ += heard && error ? 1 : 0;
      unheard_ += acted_ && !wanted_ ? 1 : 0;
      compare_outputs();
    }
    known_ = true;
    take_words(pins);
    was_inputs_ = inputs_;
  }

  void take_words(const cores::WishboneMasterPins& pins) {
    const auto& slave = slave_.dut();
    // The access that is inside, and whether its master has held it all the time; none is while the
    // block clears its memory.
    if (slave.rst) return;
    if (pins.asks() && !inside_ && !(slave.s_wb_ack || slave.s_wb_err)) {
      inside_ = WishboneAccess{pins.we, pins.adr, pins.dat, pins.sel};
      held_ = true;
      waited_ = 0;
    } else {
      ++waited_;
    }
    held_ = held_ && pins.asks();
    acted_.reset();
    if (!slave.m_write_valid && !slave.m_read_valid) return;
    if (!inside_ || inside_->write != (slave.m_write_valid != 0) ||
        (slave.m_write_valid && slave.m_read_valid)) {
      return fail("handed on: not what was asked");
    }
    acted_ = inside_;
    wanted_ = held_;
    inside_.reset();
  }

  void compare_outputs() {
    for (const auto& [name, value] : model_.outputs()) {
      const std::uint64_t got = output_ports_.at(name).read();
      if (got != value) fail(fmt::format("{} is {:x}, expected {:x}", name, got, value));
    }
  }

  tb::Sim<Vbus_registers> registers_;
  tb::Sim<Vwb_slave> slave_;
  WishboneMaster master_;
  RegisterModel model_;
  HardwarePorts input_ports_, output_ports_;
  PortValues inputs_, was_inputs_;
  bool in_reset_ = false, known_ = false, held_ = false, wanted_ = false;
  std::optional<WishboneAccess> inside_, acted_;
  cores::WishboneSlavePins last_;
  unsigned waited_ = 0, latency_ = 0;
  std::uint64_t answered_ = 0, errors_ = 0, unheard_ = 0;
  std::vector<std::string> failures_;
};

struct Traffic {
  std::string name;
  double willing;
  double give_up;
};

void PrintTo(const Traffic& traffic, std::ostream* out) { *out << traffic.name; }

class EveryMaster : public testing::TestWithParam<Traffic> {};
INSTANTIATE_TEST_SUITE_P(Wishbone, EveryMaster,
                         testing::Values(Traffic{"always", 1, 0}, Traffic{"half", 0.5, 0},
                                         Traffic{"rare", 0.1, 0}, Traffic{"impatient", 0.7, 0.2}),
                         [](const auto& traffic) { return traffic.param.name; });

TEST_P(EveryMaster, EqualsTheModelInEveryClock) {
  const std::uint64_t seed = tb::seed_from_environment(1);
  tb::Random random(tb::derive_seed(seed, 77));
  WishboneBench bench(seed, GetParam().willing);
  std::uint64_t resets = 0;
  while (bench.answered() < kAccesses && bench.failures().empty()) {
    bench.master().give_up(GetParam().give_up);
    const double pulses = random.pick({0.02, 0.1, 0.6});
    for (unsigned i = 0; i < 300; ++i) {
      const tb::AxiLiteWrite write = random_write(random);
      bench.master().ask({random.chance(0.5), write.address, write.data, write.strobe});
    }
    const unsigned clocks = static_cast<unsigned>(random.between(200, 2000));
    for (unsigned i = 0; i < clocks; ++i) {
      disturb(bench.inputs(), bench.input_ports(), random, pulses);
      bench.step();
    }
    resets += bench.master().idle() ? 0 : 1;
    bench.reset(static_cast<unsigned>(random.between(1, 3)));
  }
  for (const std::string& failure : bench.failures()) ADD_FAILURE() << failure;
  EXPECT_GT(resets, 0U);
  EXPECT_GT(bench.errors(), bench.answered() / 20);
  EXPECT_LT(bench.errors(), bench.answered() * 9 / 20);
  const bool impatient = GetParam().give_up > 0;
  EXPECT_EQ(bench.master().given_up() > 100, impatient);
  EXPECT_EQ(bench.acted_unheard() > 100, impatient);
  fmt::print("{} answers, {} given up\n", bench.answered(), bench.master().given_up());
}

TEST(Wishbone, AnAccessTakesThreeClocks) {
  WishboneBench bench(1);
  for (unsigned i = 0; i < kStartup + 2; ++i) bench.step();
  const std::uint64_t before = bench.answered();
  for (unsigned i = 0; i < 100; ++i) bench.master().ask({true, HWFFD_RESULT_SIZE_OFFSET, i, 0xF});
  for (unsigned i = 0; i < 400; ++i) bench.step();
  EXPECT_EQ(bench.answered() - before, 100U) << "one every four clocks";
  EXPECT_EQ(bench.latency(), kLatency);
  EXPECT_TRUE(bench.failures().empty());
}

TEST(Wishbone, ErrorsAreThoseOfAxi) {
  WishboneBench bench(2);
  EXPECT_TRUE(bench.access({false, HWFFD_ID_OFFSET}).ack);
  EXPECT_EQ(bench.last().dat, HWFFD_ID_RESET);
  EXPECT_EQ(bench.access({false, HWFFD_ID_OFFSET + 3}).dat, HWFFD_ID_RESET) << "unaligned";
  EXPECT_TRUE(bench.access({true, HWFFD_ID_OFFSET, 1}).err) << "constant";
  EXPECT_TRUE(bench.access({false, 0xFFC}).err);
  EXPECT_EQ(bench.last().dat, 0U);
  EXPECT_TRUE(bench.access({true, HWFFD_RING_HEAD_OFFSET + 1, 0x1234, 0x1}).ack);
  EXPECT_EQ(bench.access({false, HWFFD_RING_HEAD_OFFSET}).dat, 0x34U) << "one byte";
  EXPECT_TRUE(bench.access({true, HWFFD_WINDOW_LOCK_OFFSET, 1}).ack);
  EXPECT_TRUE(bench.access({true, HWFFD_READ_WINDOW_BASE_LO_OFFSET, 1, 0}).err) << "locked";
  EXPECT_TRUE(bench.failures().empty());
}

}  // namespace
}  // namespace hwffd::test
