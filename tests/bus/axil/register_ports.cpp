#include "register_ports.hpp"

namespace hwffd::test {

// The ports have no common type: a line each. The tests compare the names with those that follow
// from the table.
const std::map<std::string, InputPort>& hardware_inputs() {
  using Dut = Vaxil_registers;
  static const std::map<std::string, InputPort> ports = {
      {"config_org_i",
       {8, [](Dut& dut, std::uint64_t value) { dut.config_org_i = static_cast<CData>(value); }}},
      {"config_n_i",
       {8, [](Dut& dut, std::uint64_t value) { dut.config_n_i = static_cast<CData>(value); }}},
      {"config_format_i",
       {8, [](Dut& dut, std::uint64_t value) { dut.config_format_i = static_cast<CData>(value); }}},
      {"config_schedule_i",
       {1,
        [](Dut& dut, std::uint64_t value) { dut.config_schedule_i = static_cast<CData>(value); }}},
      {"config_evaluator_i",
       {2,
        [](Dut& dut, std::uint64_t value) { dut.config_evaluator_i = static_cast<CData>(value); }}},
      {"limits_in_flight_i",
       {16,
        [](Dut& dut, std::uint64_t value) { dut.limits_in_flight_i = static_cast<SData>(value); }}},
      {"limits_points_axis_i",
       {8, [](Dut& dut,
              std::uint64_t value) { dut.limits_points_axis_i = static_cast<CData>(value); }}},
      {"status_busy_i",
       {1, [](Dut& dut, std::uint64_t value) { dut.status_busy_i = static_cast<CData>(value); }}},
      {"status_idle_i",
       {1, [](Dut& dut, std::uint64_t value) { dut.status_idle_i = static_cast<CData>(value); }}},
      {"status_stopped_i",
       {1,
        [](Dut& dut, std::uint64_t value) { dut.status_stopped_i = static_cast<CData>(value); }}},
      {"status_ring_running_i",
       {1, [](Dut& dut,
              std::uint64_t value) { dut.status_ring_running_i = static_cast<CData>(value); }}},
      {"status_done_set_i",
       {1,
        [](Dut& dut, std::uint64_t value) { dut.status_done_set_i = static_cast<CData>(value); }}},
      {"ring_tail_i",
       {16, [](Dut& dut, std::uint64_t value) { dut.ring_tail_i = static_cast<SData>(value); }}},
      {"result_count_i",
       {32, [](Dut& dut, std::uint64_t value) { dut.result_count_i = static_cast<IData>(value); }}},
      {"counter_vertices_event_i",
       {1, [](Dut& dut,
              std::uint64_t value) { dut.counter_vertices_event_i = static_cast<CData>(value); }}},
      {"counter_stalls_event_i",
       {1, [](Dut& dut,
              std::uint64_t value) { dut.counter_stalls_event_i = static_cast<CData>(value); }}},
      {"counter_busy_event_i",
       {1, [](Dut& dut,
              std::uint64_t value) { dut.counter_busy_event_i = static_cast<CData>(value); }}},
      {"error_event_i",
       {24, [](Dut& dut, std::uint64_t value) { dut.error_event_i = static_cast<IData>(value); }}},
      {"error_packet_i",
       {32, [](Dut& dut, std::uint64_t value) { dut.error_packet_i = static_cast<IData>(value); }}},
      {"error_beat_i",
       {32, [](Dut& dut, std::uint64_t value) { dut.error_beat_i = static_cast<IData>(value); }}},
      {"error_address_valid_i",
       {1, [](Dut& dut,
              std::uint64_t value) { dut.error_address_valid_i = static_cast<CData>(value); }}},
      {"error_address_i",
       {64,
        [](Dut& dut, std::uint64_t value) { dut.error_address_i = static_cast<QData>(value); }}},
  };
  return ports;
}

const std::map<std::string, OutputPort>& hardware_outputs() {
  using Dut = Vaxil_registers;
  static const std::map<std::string, OutputPort> ports = {
      {"control_start_o", [](const Dut& dut) { return std::uint64_t{dut.control_start_o}; }},
      {"control_soft_reset_o",
       [](const Dut& dut) { return std::uint64_t{dut.control_soft_reset_o}; }},
      {"control_clear_counters_o",
       [](const Dut& dut) { return std::uint64_t{dut.control_clear_counters_o}; }},
      {"ring_base_o", [](const Dut& dut) { return std::uint64_t{dut.ring_base_o}; }},
      {"ring_log2_size_o", [](const Dut& dut) { return std::uint64_t{dut.ring_log2_size_o}; }},
      {"ring_head_o", [](const Dut& dut) { return std::uint64_t{dut.ring_head_o}; }},
      {"result_base_o", [](const Dut& dut) { return std::uint64_t{dut.result_base_o}; }},
      {"result_size_o", [](const Dut& dut) { return std::uint64_t{dut.result_size_o}; }},
      {"read_window_base_o", [](const Dut& dut) { return std::uint64_t{dut.read_window_base_o}; }},
      {"read_window_limit_o",
       [](const Dut& dut) { return std::uint64_t{dut.read_window_limit_o}; }},
      {"write_window_base_o",
       [](const Dut& dut) { return std::uint64_t{dut.write_window_base_o}; }},
      {"write_window_limit_o",
       [](const Dut& dut) { return std::uint64_t{dut.write_window_limit_o}; }},
      {"window_lock_windows_o",
       [](const Dut& dut) { return std::uint64_t{dut.window_lock_windows_o}; }},
      {"irq_enable_done_o", [](const Dut& dut) { return std::uint64_t{dut.irq_enable_done_o}; }},
      {"irq_enable_error_o", [](const Dut& dut) { return std::uint64_t{dut.irq_enable_error_o}; }},
      {"irq_enable_refused_o",
       [](const Dut& dut) { return std::uint64_t{dut.irq_enable_refused_o}; }},
      {"irq_o", [](const Dut& dut) { return std::uint64_t{dut.irq_o}; }},
  };
  return ports;
}

}  // namespace hwffd::test
