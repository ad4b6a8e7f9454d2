#include "dma_core.hpp"

#include <map>
#include <stdexcept>

#include "Vdma_hardened.h"
#include "Vdma_hardened256.h"
#include "Vdma_hardened64.h"
#include "Vdma_large.h"
#include "Vdma_marked.h"
#include "Vdma_medium.h"
#include "Vdma_narrow.h"
#include "Vdma_pair.h"
#include "Vdma_small.h"
#include "Vdma_watched.h"
#include "Vdma_watched256.h"
#include "Vdma_watched64.h"
#include "Vdma_wide.h"
#include "hwffd/cores/verilated_pins.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

template <class Wide>
void put(Wide& port, const std::array<std::uint32_t, 4>& words) {
  for (int i = 0; i < 4; ++i) port[i] = words[i];
}
template <class Wide>
std::array<std::uint32_t, 4> get(const Wide& port) {
  return {port[0], port[1], port[2], port[3]};
}

template <class VDut>
class VerilatedDmaCore : public DmaCore {
 public:
  explicit VerilatedDmaCore(std::uint64_t seed) : sim_(seed) {}

  void exchange(const DmaControls& controls, DmaStatus& status, cores::AxiPins& bus,
                DmaStream& packets, DmaStream& results) override {
    VDut& dut = sim_.dut();
    drive(controls);
    cores::drive_pins(dut, bus);
    dut.m_packet_ready = packets.ready;
    dut.s_result_valid = results.valid;
    dut.s_result_last = results.beat.last;
    dut.s_result_mark = results.mark;
    put(dut.s_result_data, results.beat.words);
    dut.eval();
    packets.valid = dut.m_packet_valid;
    packets.beat = {get(dut.m_packet_data), dut.m_packet_last != 0};
    results.ready = dut.s_result_ready;
    sample(status);
    cores::sample_pins(dut, bus);
  }
  void clock() override { sim_.tick(); }

 private:
  void drive(const DmaControls& controls) {
    VDut& dut = sim_.dut();
    dut.rst = controls.rst;
    dut.soft_reset_i = controls.soft_reset;
    dut.read_first_i = controls.read_first;
    dut.read_last_i = controls.read_last;
    dut.ring_start_i = controls.ring_start;
    dut.ring_base_i = controls.ring_base;
    dut.ring_entries_log2_i = controls.ring_entries_log2;
    dut.ring_head_i = controls.ring_head;
    dut.write_first_i = controls.write_first;
    dut.write_last_i = controls.write_last;
    dut.result_start_i = controls.result_start;
    dut.result_base_i = controls.result_base;
    dut.result_size_i = controls.result_size;
    dut.windows_locked_i = controls.windows_locked;
  }

  void sample(DmaStatus& status) {
    const VDut& dut = sim_.dut();
    status.clearing = dut.clearing_o;
    status.idle = dut.idle_o;
    status.halted = dut.halted_o;
    status.fault = dut.fault_o;
    status.timeout = dut.timeout_o;
    status.ring_tail = dut.ring_tail_o;
    status.ring_running = dut.ring_running_o;
    status.result_running = dut.result_running_o;
    status.result_busy = dut.result_busy_o;
    status.result_overflow = dut.result_overflow_o;
    status.result_count = dut.result_count_o;
    status.ring_marked = dut.ring_marked_o;
    status.result_marked = dut.result_marked_o;
    status.read_error = {dut.read_error_o != 0, dut.read_error_code_o, dut.read_error_address_o};
    status.write_error = {dut.write_error_o != 0, dut.write_error_code_o,
                          dut.write_error_address_o};
    status.upset = dut.upset_o;
  }

  tb::Sim<VDut> sim_;
};

template <class VDut>
std::unique_ptr<DmaCore> make(std::uint64_t seed) {
  return std::make_unique<VerilatedDmaCore<VDut>>(seed);
}

}  // namespace

const std::vector<DmaSize>& dma_sizes() {
  static const std::vector<DmaSize> sizes = {{"large", 256, 512, 8},
                                             {"medium", 16, 64, 4},
                                             {"small", 4, 8, 2, 0, 128, false, 2},
                                             {"narrow", 128, 512, 8, 0, 64},
                                             {"wide", 16, 64, 4, 0, 256},
                                             {"hardened", 16, 64, 4, 0, 128, true},
                                             {"hardened64", 16, 64, 4, 0, 64, true},
                                             {"hardened256", 16, 64, 4, 0, 256, true}};
  return sizes;
}

const DmaSize& small_dma_size() { return dma_sizes()[2]; }

const std::vector<DmaSize>& watched_dma_sizes() {
  static const std::vector<DmaSize> sizes = {{"watched", 16, 64, 4, 100},
                                             {"watched64", 16, 64, 4, 100, 64},
                                             {"watched256", 16, 64, 4, 100, 256}};
  return sizes;
}

const DmaSize& marked_dma_size() {
  static const DmaSize size{"marked", 16, 64, 4};
  return size;
}

std::unique_ptr<DmaCore> make_dma_core(const std::string& name, std::uint64_t seed) {
  using Make = std::unique_ptr<DmaCore> (*)(std::uint64_t seed);
  static const std::map<std::string, Make> makers = {{"hardened", make<Vdma_hardened>},
                                                     {"hardened256", make<Vdma_hardened256>},
                                                     {"hardened64", make<Vdma_hardened64>},
                                                     {"large", make<Vdma_large>},
                                                     {"marked", make<Vdma_marked>},
                                                     {"medium", make<Vdma_medium>},
                                                     {"narrow", make<Vdma_narrow>},
                                                     {"pair", make<Vdma_pair>},
                                                     {"small", make<Vdma_small>},
                                                     {"watched", make<Vdma_watched>},
                                                     {"watched256", make<Vdma_watched256>},
                                                     {"watched64", make<Vdma_watched64>},
                                                     {"wide", make<Vdma_wide>}};
  const auto it = makers.find(name);
  if (it != makers.end()) return it->second(seed);
  throw std::invalid_argument("make_dma_core: no size \"" + name + "\"");
}

}  // namespace hwffd::test
