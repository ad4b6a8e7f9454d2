#include "register_traffic.hpp"

namespace hwffd::test {

std::uint32_t random_address(tb::Random& random) {
  static const std::vector<std::uint32_t> busy = {
      register_offset("CONTROL"), register_offset("STATUS"), register_offset("IRQ_STATE"),
      register_offset("ERROR_STATUS"), register_offset("ERROR_FIRST")};
  if (random.chance(0.25)) return random.pick(busy);
  const auto& table = register_table();
  const std::uint32_t any = random.word() & 0xFFF;
  const std::uint32_t mapped = table[random.below(table.size())].offset | (any & 3);
  return random.pick({mapped, mapped, mapped, mapped, mapped, mapped, mapped ^ 0x10, any});
}

tb::AxiLiteWrite random_write(tb::Random& random) {
  tb::AxiLiteWrite write;
  write.address = random_address(random);
  // The lock is for good until reset: not too often.
  if ((write.address & ~3u) == register_field("WINDOW_LOCK.windows").offset &&
      !random.chance(0.2)) {
    write.address = register_field("WINDOW_LOCK.windows").offset - 4;
  }
  const std::uint32_t word = random.word();
  write.data = random.pick({word, word, word & random.word(), 1u << (word & 31), ~0u, 0u, 1u});
  write.strobe = random.chance(0.6) ? 0xF : static_cast<std::uint8_t>(random.below(16));
  return write;
}

void disturb(PortValues& inputs, const HardwarePorts& ports, tb::Random& random, double pulses) {
  for (auto& [name, value] : inputs) {
    const std::uint64_t mask = ports.at(name).largest;
    const bool pulse = name.find("_set_i") != std::string::npos ||
                       name.find("_event_i") != std::string::npos ||
                       name == "error_address_valid_i";
    if (pulse) {
      const std::uint64_t some = mask == 1 ? 1 : random.bits() & random.bits() & mask;
      value = random.chance(pulses) ? some : 0;
    } else if (random.chance(0.1)) {
      value = random.bits() & mask;
    }
  }
}

}  // namespace hwffd::test
