// Every register of the table: reset value, reading, writing, strobes, and what is refused. The
// bench compares each clock with the model besides.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "named.hpp"
#include "register_bench.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint32_t kWords = 1024;

/// One register: all of its fields.
struct Register {
  std::string name;
  std::uint32_t offset = 0;
  std::vector<RegisterField> fields;

  /// Bits of the fields of these accesses.
  std::uint32_t bits(const std::set<std::string>& accesses) const {
    std::uint32_t mask = 0;
    for (const auto& field : fields) mask |= accesses.count(field.access) ? field.mask() : 0;
    return mask;
  }
  bool writable() const {
    for (const auto& field : fields) {
      if (field.writable()) return true;
    }
    return false;
  }
  bool locked_by_something() const { return !fields[0].linked("locked").empty(); }
};

std::ostream& operator<<(std::ostream& out, const Register& reg) { return out << reg.name; }

std::vector<Register> all_registers() {
  std::vector<Register> found;
  for (const RegisterField& field : register_table()) {
    if (found.empty() || found.back().name != field.reg) {
      found.push_back({field.reg, field.offset, {}});
    }
    found.back().fields.push_back(field);
  }
  return found;
}

const std::set<std::string> kStored = {"rw"};

class EachRegister : public testing::TestWithParam<Register> {};
INSTANTIATE_TEST_SUITE_P(Table, EachRegister, testing::ValuesIn(all_registers()), by_name);

TEST_P(EachRegister, HasItsResetValue) {
  const Register& reg = GetParam();
  std::uint32_t expected = 0;
  for (const auto& field : reg.fields) expected |= field.reset << field.low;
  RegisterBench bench(1);
  EXPECT_EQ(bench.read(reg.offset).data, expected);
  // Again after it was changed as far as it can be.
  bench.inputs()["error_event_i"] = 0x3FFFF;
  bench.inputs()["error_packet_i"] = bench.inputs()["error_beat_i"] = 0xFFFFFFFF;
  bench.inputs()["error_address_i"] = ~std::uint64_t{0};
  bench.inputs()["error_address_valid_i"] = 1;
  bench.inputs()["status_done_set_i"] = 1;
  for (const char* port : {"vertices", "stalls", "busy"}) {
    bench.inputs()["counter_" + std::string(port) + "_event_i"] = 1;
  }
  bench.write(reg.offset, ~0u);
  bench.steps(3);
  for (auto& [name, value] : bench.inputs()) value = 0;
  bench.reset();
  EXPECT_EQ(bench.read(reg.offset).data, expected);
}

TEST_P(EachRegister, ReadsWhatTheHardwareSays) {
  const Register& reg = GetParam();
  RegisterBench bench(2);
  const std::uint32_t others = bench.read(reg.offset).data & ~reg.bits({"ro"});
  for (const auto& field : reg.fields) {
    if (field.access != "ro") continue;
    for (unsigned bit = 0; bit < field.width; ++bit) {
      bench.inputs()[field.port + "_i"] = std::uint64_t{1} << (bit + field.port_low);
      EXPECT_EQ(bench.read(reg.offset).data, others | 1u << (field.low + bit)) << field.path;
    }
    bench.inputs()[field.port + "_i"] = 0;
  }
}

TEST_P(EachRegister, KeepsWhatIsWritten) {
  const Register& reg = GetParam();
  RegisterBench bench(3);
  const std::uint32_t stored = reg.bits(kStored);
  const std::uint32_t others = bench.read(reg.offset).data & ~stored;
  for (unsigned bit = 0; bit < 32; ++bit) {
    for (const std::uint32_t data : {1u << bit, ~(1u << bit)}) {
      EXPECT_EQ(bench.write(reg.offset, data), reg.writable() ? cores::kOkay : cores::kSlvErr);
      const std::uint32_t read = bench.read(reg.offset).data;
      EXPECT_EQ(read & stored, data & stored) << reg.name << " bit " << bit;
      if (!reg.writable()) {
        EXPECT_EQ(read, others);
      }
    }
  }
}

TEST_P(EachRegister, IsWrittenByBytes) {
  const Register& reg = GetParam();
  RegisterBench bench(4);
  const std::uint32_t stored = reg.bits(kStored);
  for (unsigned strobe = 0; strobe < 16; ++strobe) {
    std::uint32_t mask = 0;
    for (unsigned byte = 0; byte < 4; ++byte) mask |= (strobe >> byte & 1) ? 0xFFu << 8 * byte : 0;
    for (const std::uint32_t before : {0u, ~0u, 0xA5A5A5A5u}) {
      bench.write(reg.offset, before);
      const auto code = bench.write(reg.offset, ~before, static_cast<std::uint8_t>(strobe));
      EXPECT_EQ(code, reg.writable() ? cores::kOkay : cores::kSlvErr) << strobe;
      const std::uint32_t expected = ((before & ~mask) | (~before & mask)) & stored;
      EXPECT_EQ(bench.read(reg.offset).data & stored, expected) << reg.name << " strobe " << strobe;
    }
  }
}

TEST_P(EachRegister, IsAloneAtItsAddress) {
  const Register& reg = GetParam();
  RegisterBench bench(5);
  if (reg.name == "CONTROL") bench.set("WINDOW_LOCK", 1);  // or a start would set what says no
  const auto before = bench.snapshot();
  bench.write(reg.offset, ~0u);
  const auto after = bench.snapshot();
  const std::uint32_t sticky = reg.bits({"rw", "w1s"});
  std::size_t changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i) changed += before[i] != after[i] ? 1 : 0;
  // IRQ_TEST sets IRQ_STATE.
  EXPECT_EQ(changed, sticky != 0 || reg.name == "IRQ_TEST" ? 1u : 0u);
  for (unsigned low = 0; low < 4; ++low) {  // the two low bits of an address are not looked at
    EXPECT_EQ(bench.read(reg.offset | low).data, bench.read(reg.offset).data);
    if (sticky == 0 || reg.locked_by_something()) continue;
    bench.write(reg.offset | low, 0x01010101u << low);
    EXPECT_EQ(bench.read(reg.offset).data & reg.bits(kStored),
              (0x01010101u << low) & reg.bits(kStored));
  }
}

TEST_P(EachRegister, ObeysItsLock) {
  const Register& reg = GetParam();
  RegisterBench bench(6);
  bench.write(reg.offset, 0x12345678);
  bench.set("WINDOW_LOCK", 0);  // writes nothing
  EXPECT_EQ(bench.get("WINDOW_LOCK"), 0u);
  EXPECT_EQ(bench.write(register_field("WINDOW_LOCK.windows").offset, ~0u, 0xE), cores::kOkay);
  EXPECT_EQ(bench.get("WINDOW_LOCK"), 0u);  // the bit is in byte 0
  bench.set("WINDOW_LOCK", 1);
  bench.set("WINDOW_LOCK", 0);
  EXPECT_EQ(bench.get("WINDOW_LOCK"), 1u);
  bench.set("CONTROL", 2);  // soft reset
  bench.steps(5);
  EXPECT_EQ(bench.get("WINDOW_LOCK"), 1u);
  for (const std::uint8_t strobe : {0, 1, 8, 15}) {
    const bool refused = reg.locked_by_something() || !reg.writable();
    EXPECT_EQ(bench.write(reg.offset, ~0u, strobe), refused ? cores::kSlvErr : cores::kOkay);
    if (reg.locked_by_something()) {
      EXPECT_EQ(bench.read(reg.offset).data, 0x12345678u);
    }
  }
  bench.reset();
  EXPECT_EQ(bench.get("WINDOW_LOCK"), 0u);
  EXPECT_EQ(bench.write(reg.offset, 3), reg.writable() ? cores::kOkay : cores::kSlvErr);
}

TEST(Table, TheLockIsOnTheWindowsAndNothingElse) {
  unsigned locked = 0;
  for (const Register& reg : all_registers()) {
    const bool window = reg.name.find("_WINDOW_") != std::string::npos;
    EXPECT_EQ(reg.locked_by_something(), window) << reg.name;
    locked += window ? 1 : 0;
  }
  EXPECT_EQ(locked, 8u);
}

TEST(Table, PortsAreThoseOfTheDesign) {
  std::set<std::string> inputs = {"error_event_i", "error_packet_i", "error_beat_i",
                                  "error_address_valid_i", "error_address_i"};
  for (const RegisterField& field : register_table()) {
    if (field.access == "ro") inputs.insert(field.port + "_i");
    if (field.access == "counter") inputs.insert(field.port + "_event_i");
    const bool own = field.linked("with").empty() && field.access == "w1c" &&
                     field.path != "STATUS.start_refused";
    if (own) inputs.insert(field.port + "_set_i");
  }
  for (const auto& [name, port] : hardware_inputs()) EXPECT_EQ(inputs.erase(name), 1u) << name;
  EXPECT_TRUE(inputs.empty()) << *inputs.begin();
  const PortValues outputs = RegisterModel().outputs();
  for (const auto& [name, value] : outputs) EXPECT_EQ(hardware_outputs().count(name), 1u) << name;
  EXPECT_EQ(outputs.size(), hardware_outputs().size());
}

TEST(Table, SaysWhatSoftwareReliesOn) {
  EXPECT_EQ(register_table().front().path, "ID.value");
  EXPECT_EQ(register_table().front().reset, 0x48464644u);  // "HFFD"
  const auto all = all_registers();
  EXPECT_EQ(all.size(), 40u);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](auto& reg) { return reg.writable(); }), 23);
}

TEST(Unmapped, IsRefusedWithoutSideEffect) {
  std::set<std::uint32_t> mapped;
  for (const RegisterField& field : register_table()) mapped.insert(field.offset);
  RegisterBench bench(7);
  for (const RegisterField& field : register_table()) {  // so that a stray write would show
    if (field.access == "rw") bench.write(field.offset, 0x5A5A5A5A);
  }
  const auto before = bench.snapshot();
  unsigned refused = 0;
  for (std::uint32_t word = 0; word < kWords; ++word) {
    if (mapped.count(4 * word) != 0) continue;
    const auto answer = bench.read(4 * word);
    EXPECT_EQ(answer.code, cores::kSlvErr) << word;
    EXPECT_EQ(answer.data, 0u) << word;
    EXPECT_EQ(bench.write(4 * word, ~0u), cores::kSlvErr) << word;
    ++refused;
  }
  EXPECT_EQ(refused, kWords - mapped.size());
  EXPECT_EQ(bench.snapshot(), before);
}

}  // namespace
}  // namespace hwffd::test
