#include "register_model.hpp"

namespace hwffd::test {
namespace {

std::uint32_t mask_of(std::uint8_t strobe) {
  std::uint32_t mask = 0;
  for (unsigned byte = 0; byte < 4; ++byte) {
    if ((strobe >> byte & 1) != 0) mask |= 0xFFu << 8 * byte;
  }
  return mask;
}

}  // namespace

void RegisterModel::reset() {
  fields_.clear();
  counters_.clear();
  for (const RegisterField& field : register_table()) {
    fields_[field.path] = field.reset;
    if (field.access == "counter") counters_[field.port] = {};
  }
  irq_ = false;
  located_ = false;
  errors_ = 0;
}

std::uint32_t RegisterModel::field_value(const PortValues& inputs,
                                         const RegisterField& field) const {
  if (field.access == "w1") return 0;
  if (field.access == "ro") {
    const std::uint64_t port = inputs.at(field.port + "_i");
    return static_cast<std::uint32_t>(port >> field.port_low) & (field.mask() >> field.low);
  }
  if (field.access == "counter") {
    const Counter& counter = counters_.at(field.port);
    return field.port_low == 0 ? static_cast<std::uint32_t>(counter.value) : counter.latched_high;
  }
  return fields_.at(field.path);
}

RegisterModel::Answer RegisterModel::do_read(const PortValues& inputs, std::uint32_t address) {
  Answer answer{cores::kSlvErr, 0};
  for (const RegisterField& field : register_table()) {
    if (field.offset != (address & ~3u)) continue;
    answer.code = cores::kOkay;
    answer.data |= field_value(inputs, field) << field.low;
    if (field.access == "counter" && field.port_low == 0) {
      Counter& counter = counters_.at(field.port);
      counter.latched_high = static_cast<std::uint32_t>(counter.value >> 32);
    }
  }
  return answer;
}

std::uint8_t RegisterModel::code_of(const tb::AxiLiteWrite& write) const {
  bool writable = false;
  bool locked = false;
  for (const RegisterField& field : register_table()) {
    if (field.offset != (write.address & ~3u)) continue;
    writable = writable || field.writable();
    for (const std::string& lock : field.linked("locked")) locked = locked || fields_.at(lock) != 0;
  }
  return writable && !locked ? cores::kOkay : cores::kSlvErr;
}

std::vector<std::string> RegisterModel::blocks(const PortValues& inputs,
                                               const RegisterField& start) const {
  std::vector<std::string> paths;
  if (fields_.at(start.path) != 0) paths.push_back(start.path);  // in the clock of the pulse
  for (const std::string& path : start.linked("unless")) {
    if (field_value(inputs, register_field(path)) != 0) paths.push_back(path);
  }
  for (const std::string& path : start.linked("needs")) {
    if (fields_.at(path) == 0) paths.push_back(path);
  }
  return paths;
}

std::set<std::string> RegisterModel::store(const tb::AxiLiteWrite& write) {
  const std::uint32_t mask = mask_of(write.strobe);
  std::set<std::string> cleared;
  for (const RegisterField& field : register_table()) {
    if (field.offset != (write.address & ~3u)) continue;
    std::uint32_t& value = fields_.at(field.path);
    const std::uint32_t written = (mask & field.mask()) >> field.low;
    const std::uint32_t ones = (write.data & mask & field.mask()) >> field.low;
    if (field.access == "rw") value = (value & ~written) | ones;
    if (field.access == "w1" || field.access == "w1s") value |= ones;
    if (!field.sticky()) continue;
    if ((value & ones) != 0) cleared.insert(field.path);
    value &= ~ones;
  }
  return cleared;
}

void RegisterModel::record(const PortValues& inputs, bool held, bool clear) {
  const std::uint64_t events = inputs.at("error_event_i");
  const std::uint64_t count = clear ? 0 : std::uint64_t{fields_.at("ERROR_COUNT.value")} + errors_;
  fields_.at("ERROR_COUNT.value") =
      static_cast<std::uint32_t>(count > 0xFFFFFFFFu ? 0xFFFFFFFFu : count);
  errors_ = 0;
  for (unsigned code = 0; code < 64; ++code) errors_ += events >> code & 1;
  const bool located = inputs.at("error_address_valid_i") != 0;
  if ((events != 0 && !held) || (located && !(held && located_))) {
    const std::uint64_t address = located ? inputs.at("error_address_i") : 0;
    fields_.at("ERROR_ADDRESS_LO.value") = static_cast<std::uint32_t>(address);
    fields_.at("ERROR_ADDRESS_HI.value") = static_cast<std::uint32_t>(address >> 32);
    located_ = located;
  }
  if (events == 0 || held) return;
  unsigned code = 0;
  while ((events >> code & 1) == 0) ++code;
  fields_.at("ERROR_FIRST.code") = code;
  fields_.at("ERROR_PACKET.value") = static_cast<std::uint32_t>(inputs.at("error_packet_i"));
  fields_.at("ERROR_BEAT.value") = static_cast<std::uint32_t>(inputs.at("error_beat_i"));
}

void RegisterModel::count(const PortValues& inputs, bool clear) {
  for (auto& [port, counter] : counters_) {
    counter.value = clear ? 0 : counter.value + counter.event;
    counter.event = inputs.at(port + "_event_i") + inputs.at(port + "_second_i");
  }
}

RegisterModel::Answers RegisterModel::clock(const PortValues& inputs,
                                            const std::optional<tb::AxiLiteWrite>& write,
                                            const std::optional<std::uint32_t>& read) {
  Answers answers;
  if (read) answers.read = do_read(inputs, *read);
  if (write) answers.write.code = code_of(*write);

  irq_ = false;
  std::set<std::string> set;  // sticky fields that are set in this clock
  for (const RegisterField& field : register_table()) {
    if (field.reg == "IRQ_STATE" && fields_.at(field.path) != 0) {
      irq_ = irq_ || fields_.at("IRQ_ENABLE." + field.name) != 0;
    }
    if (field.access == "event" && (inputs.at("error_event_i") >> field.low & 1) != 0) {
      set.insert(field.path);
      set.insert(field.reg);
    }
    const auto port = inputs.find(field.port + "_set_i");
    if (port != inputs.end() && port->second != 0) set.insert(field.path);
  }

  const bool clear = fields_.at("CONTROL.clear_counters") != 0;  // the pulse of the last clock
  count(inputs, clear);
  std::map<std::string, std::vector<std::string>> refused_by;
  for (const RegisterField& field : register_table()) {
    if (field.access != "w1") continue;
    if (!field.linked("refused").empty()) refused_by[field.path] = blocks(inputs, field);
    fields_.at(field.path) = 0;
  }
  std::set<std::string> cleared;
  if (write && answers.write.code == cores::kOkay) cleared = store(*write);
  for (const RegisterField& field : register_table()) {
    if (field.access != "w1" || fields_.at(field.path) == 0) continue;
    for (const std::string& target : field.linked("sets")) set.insert(target);
    const std::vector<std::string>& reasons = refused_by[field.path];
    if (reasons.empty()) ++seen_[field.path + " taken"];
    if (reasons.size() == 1) ++seen_[field.path + " refused by " + reasons[0]];
    if (reasons.empty()) continue;
    fields_.at(field.path) = 0;
    for (const std::string& target : field.linked("refused")) set.insert(target);
  }

  record(inputs, fields_.at("ERROR_FIRST.valid") != 0, clear);  // cleared by the write: not held
  for (const RegisterField& field : register_table()) {
    bool sets = set.count(field.path) != 0;
    for (const std::string& other : field.linked("with")) sets = sets || set.count(other) != 0;
    if (sets) fields_.at(field.path) = 1;
    const bool clears = cleared.count(field.path) != 0;
    if (sets && clears) ++seen_[field.path + " set and cleared"];
    if (sets != clears) ++seen_[field.path + (sets ? " set" : " cleared")];
  }
  return answers;
}

PortValues RegisterModel::outputs() const {
  PortValues ports;
  for (const RegisterField& field : register_table()) {
    const bool pulse = field.access == "w1" && field.linked("sets").empty();
    if (field.access != "rw" && field.access != "w1s" && !pulse) continue;
    ports[field.port + "_o"] |= std::uint64_t{fields_.at(field.path)} << field.port_low;
  }
  ports["irq_o"] = irq_ ? 1 : 0;
  ports["differs_o"] = 0;  // nothing flips
  return ports;
}

}  // namespace hwffd::test
