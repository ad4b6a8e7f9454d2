#include "register_ports.hpp"

namespace hwffd::test {

// The ports have no common type: a macro takes each by its name. The tests compare the names with
// those that follow from the table.
#define HWFFD_INPUT(port, width)                                         \
  {                                                                      \
#port, {                                                             \
      width, [](Vaxil_registers& dut, std::uint64_t value) {             \
        dut.port = static_cast<std::decay_t<decltype(dut.port)>>(value); \
      }                                                                  \
    }                                                                    \
  }
#define HWFFD_OUTPUT(port)                                                    \
  {                                                                           \
#port, [](const Vaxil_registers& dut) { return std::uint64_t{dut.port}; } \
  }

const std::map<std::string, InputPort>& hardware_inputs() {
  static const std::map<std::string, InputPort> ports = {
      HWFFD_INPUT(config_org_i, 8),
      HWFFD_INPUT(config_n_i, 8),
      HWFFD_INPUT(config_format_i, 8),
      HWFFD_INPUT(config_schedule_i, 1),
      HWFFD_INPUT(config_evaluator_i, 2),
      HWFFD_INPUT(limits_in_flight_i, 16),
      HWFFD_INPUT(limits_points_axis_i, 8),
      HWFFD_INPUT(status_busy_i, 1),
      HWFFD_INPUT(status_idle_i, 1),
      HWFFD_INPUT(status_stopped_i, 1),
      HWFFD_INPUT(status_ring_running_i, 1),
      HWFFD_INPUT(status_done_set_i, 1),
      HWFFD_INPUT(ring_tail_i, 16),
      HWFFD_INPUT(result_count_i, 32),
      HWFFD_INPUT(counter_vertices_event_i, 1),
      HWFFD_INPUT(counter_stalls_event_i, 1),
      HWFFD_INPUT(counter_busy_event_i, 1),
      HWFFD_INPUT(error_event_i, 24),
      HWFFD_INPUT(error_packet_i, 32),
      HWFFD_INPUT(error_beat_i, 32),
      HWFFD_INPUT(error_address_valid_i, 1),
      HWFFD_INPUT(error_address_i, 64),
  };
  return ports;
}

const std::map<std::string, OutputPort>& hardware_outputs() {
  static const std::map<std::string, OutputPort> ports = {
      HWFFD_OUTPUT(control_start_o),
      HWFFD_OUTPUT(control_soft_reset_o),
      HWFFD_OUTPUT(control_clear_counters_o),
      HWFFD_OUTPUT(ring_base_o),
      HWFFD_OUTPUT(ring_log2_size_o),
      HWFFD_OUTPUT(ring_head_o),
      HWFFD_OUTPUT(result_base_o),
      HWFFD_OUTPUT(result_size_o),
      HWFFD_OUTPUT(read_window_base_o),
      HWFFD_OUTPUT(read_window_limit_o),
      HWFFD_OUTPUT(write_window_base_o),
      HWFFD_OUTPUT(write_window_limit_o),
      HWFFD_OUTPUT(window_lock_windows_o),
      HWFFD_OUTPUT(irq_enable_done_o),
      HWFFD_OUTPUT(irq_enable_error_o),
      HWFFD_OUTPUT(irq_enable_refused_o),
      HWFFD_OUTPUT(irq_o),
  };
  return ports;
}

}  // namespace hwffd::test
