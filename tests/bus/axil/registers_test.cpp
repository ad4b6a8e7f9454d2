// Every register of the table: reset value, reading, writing, strobes, and what is refused; what
// the record of errors keeps. The bench compares each answer, and all outputs in each clock, with
// the model: most tests only ask.
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

  bool writable() const {
    return std::any_of(fields.begin(), fields.end(), [](auto& field) { return field.writable(); });
  }
  bool locked_by_something() const { return !fields[0].linked("locked").empty(); }
};

std::ostream& operator<<(std::ostream& out, const Register& reg) { return out << reg.name; }

std::vector<Register> all_registers() {
  std::vector<Register> registers;
  for (const RegisterField& field : register_table()) {
    if (registers.empty() || registers.back().name != field.reg) {
      registers.push_back({field.reg, field.offset, {}});
    }
    registers.back().fields.push_back(field);
  }
  return registers;
}

/// All that software can ask of a register, before the lock and after it.
class EachRegister : public testing::TestWithParam<Register> {
 protected:
  void write_and_read(std::uint32_t data, std::uint8_t strobe = 0xF, unsigned low = 0) {
    bench_.write(GetParam().offset | low, data, strobe);
    bench_.read(GetParam().offset | low);
  }
  RegisterBench bench_{1};
};
INSTANTIATE_TEST_SUITE_P(Table, EachRegister, testing::ValuesIn(all_registers()), by_name);

TEST_P(EachRegister, IsWrittenByBytesAndAloneAtItsAddress) {
  for (const bool locked : {false, true}) {
    if (locked) bench_.set("WINDOW_LOCK", 1);
    for (unsigned i = 0; i < 16; ++i) {
      const auto strobe = static_cast<std::uint8_t>(2 * i % 16 + i / 8);  // first without byte 0
      for (const std::uint32_t before : {0u, ~0u, 0xA5A5A5A5u}) {
        write_and_read(before, before == 0 ? strobe : 0xF);
        write_and_read(~before, strobe);
      }
    }
    // The two low bits of an address are not looked at.
    for (unsigned low = 0; low < 4; ++low) write_and_read(0x01010101u << low, 0xF, low);
    bench_.snapshot();
  }
}

TEST_P(EachRegister, KeepsEachBitAsItsAccessSays) {
  for (const bool locked : {false, true}) {
    if (locked) bench_.set("WINDOW_LOCK", 1);
    for (unsigned bit = 0; bit < 32; ++bit) {
      for (const std::uint32_t data : {1u << bit, ~(1u << bit)}) write_and_read(data);
    }
    bench_.set("CONTROL", 2);  // a soft reset changes nothing
    bench_.snapshot();
  }
}

TEST_P(EachRegister, ReadsWhatTheHardwareSays) {
  bench_.snapshot();
  for (const auto& field : GetParam().fields) {
    if (field.access != "ro") continue;
    std::uint64_t& port = bench_.inputs().at(field.port + "_i");
    for (unsigned bit = 0; bit < field.width; ++bit) {
      port = std::uint64_t{1} << (bit + field.port_low);
      EXPECT_EQ(bench_.read(field.offset).data & field.mask(), 1u << (field.low + bit));
    }
    port = 0;
  }
}

TEST_P(EachRegister, HasItsResetValue) {
  const Register& reg = GetParam();
  std::uint32_t expected = 0;
  for (const auto& field : reg.fields) expected |= field.reset << field.low;
  EXPECT_EQ(bench_.read(reg.offset).data, expected);
  // Again after it was changed as far as it can be.
  for (const auto& [name, port] : bench_.input_ports()) bench_.inputs()[name] = port.largest;
  bench_.write(reg.offset, ~0u);
  bench_.steps(3);
  for (auto& [name, value] : bench_.inputs()) value = 0;
  bench_.reset();
  EXPECT_EQ(bench_.read(reg.offset).data, expected);
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
  std::set<std::string> inputs = {"error_any_i",  "error_event_i",         "error_packet_i",
                                  "error_beat_i", "error_address_valid_i", "error_address_i"};
  for (const RegisterField& field : register_table()) {
    if (field.access == "ro") inputs.insert(field.port + "_i");
    if (field.access == "counter") inputs.insert(field.port + "_event_i");
    if (field.access == "counter") inputs.insert(field.port + "_second_i");
    const bool own = field.linked("with").empty() && field.access == "w1c" &&
                     field.path != "STATUS.start_refused";
    if (own) inputs.insert(field.port + "_set_i");
  }
  RegisterBench bench(1);
  for (const auto& [name, port] : bench.input_ports()) EXPECT_EQ(inputs.erase(name), 1u) << name;
  EXPECT_TRUE(inputs.empty()) << *inputs.begin();
  const PortValues outputs = bench.model().outputs();
  for (const auto& [name, value] : outputs) EXPECT_EQ(bench.output_ports().count(name), 1u) << name;
  EXPECT_EQ(outputs.size(), bench.output_ports().size());
  bench.get("ID");
}

TEST(Table, SaysWhatSoftwareReliesOn) {
  EXPECT_EQ(register_table().front().path, "ID.value");
  EXPECT_EQ(register_table().front().reset, 0x48464644u);  // "HFFD"
  const auto all = all_registers();
  EXPECT_EQ(all.size(), 49u);
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](auto& reg) { return reg.writable(); }), 24);
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

// ---- errors

struct Error {
  std::uint64_t events;
  std::uint32_t packet, beat;
  std::uint64_t address;
};

class FirstErrors : public testing::Test {
 protected:
  void raise(const Error& error) {
    PortValues& inputs = bench_.inputs();
    inputs["error_packet_i"] = error.packet;
    inputs["error_beat_i"] = error.beat;
    inputs["error_address_i"] = error.address;
    inputs["error_address_valid_i"] = error.address != 0 ? 1 : 0;
    bench_.pulse("error_event_i", error.events);
    inputs["error_address_valid_i"] = 0;
    inputs["error_packet_i"] = ~0u;
  }
  void expect_first(unsigned code, const Error& error) {
    EXPECT_EQ(bench_.get("ERROR_FIRST"), register_field("ERROR_FIRST.valid").mask() | code);
    EXPECT_EQ(bench_.get("ERROR_PACKET"), error.packet);
    EXPECT_EQ(bench_.get("ERROR_BEAT"), error.beat);
    EXPECT_EQ(bench_.get("ERROR_ADDRESS_LO"), static_cast<std::uint32_t>(error.address));
    EXPECT_EQ(bench_.get("ERROR_ADDRESS_HI"), static_cast<std::uint32_t>(error.address >> 32));
  }
  RegisterBench bench_{9};
};

TEST_F(FirstErrors, TheFirstIsKeptUntilItIsCleared) {
  const Error first{0x8420, 1, 2, 3};  // several at once: the lowest code
  raise(first);
  raise({0x0001, 4, 5, 6});
  expect_first(5, first);
  EXPECT_EQ(bench_.get("ERROR_COUNT"), 4u);
  EXPECT_EQ(bench_.get("ERROR_STATUS"), 0x8421u);
  bench_.set("ERROR_STATUS", 0x8400);
  EXPECT_EQ(bench_.get("ERROR_STATUS"), 0x0021u);
  expect_first(5, first);  // has nothing to do with the status
  bench_.set_bit("ERROR_FIRST.valid");
  EXPECT_EQ(bench_.get("ERROR_FIRST"), 5u);
  const Error third{0x1000, 9, 8, 7};
  raise(third);
  expect_first(12, third);
  EXPECT_EQ(bench_.get("ERROR_COUNT"), 5u);
  bench_.set_bit("CONTROL.clear_counters");
  EXPECT_EQ(bench_.get("ERROR_COUNT"), 0u);
  expect_first(12, third);
}

TEST_F(FirstErrors, AnErrorWithoutAnAddressHidesNone) {
  raise({0x0200, 1, 2, 0});
  expect_first(9, {0x0200, 1, 2, 0});
  raise({0x8000, 0, 0, 0x1'2345'6780});
  expect_first(9, {0x0200, 1, 2, 0x1'2345'6780});
  raise({0x10000, 0, 0, 0xFFF0});  // the second with an address
  raise({0x0001, 7, 7, 0});
  expect_first(9, {0x0200, 1, 2, 0x1'2345'6780});
  bench_.set_bit("ERROR_FIRST.valid");
  raise({0x0004, 3, 4, 0});
  expect_first(2, {0x0004, 3, 4, 0});
}

TEST_F(FirstErrors, EachCodeIsTheFirstAloneAndBelowAllOthers) {
  const std::uint64_t all = bench_.input_ports().at("error_event_i").largest;
  unsigned code = 0;
  for (std::uint64_t alone = 1; alone <= all; alone <<= 1, ++code) {
    for (const std::uint64_t events : {alone, all & ~(alone - 1)}) {
      const Error error{events, code + 1, code + 2, code + 3};
      raise(error);
      expect_first(code, error);
      bench_.set_bit("ERROR_FIRST.valid");
    }
  }
  EXPECT_EQ(code, 30u);
}

}  // namespace
}  // namespace hwffd::test
