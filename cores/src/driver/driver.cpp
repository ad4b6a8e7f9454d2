#include "hwffd/driver.hpp"

#include <string>

#include "hwffd/registers.h"

namespace hwffd {
namespace {

constexpr unsigned kMajor = HWFFD_VERSION_MAJOR_RESET;
constexpr std::uint64_t kDescriptorBytes = 16;
constexpr std::uint64_t kBeatBytes = 16;

unsigned field(std::uint32_t word, std::uint32_t mask, unsigned shift) {
  return (word & mask) >> shift;
}

}  // namespace

std::uint64_t Driver::read64(std::uint32_t low) {
  const std::uint64_t half = port_.read32(low);
  return std::uint64_t{port_.read32(low + 4)} << 32 | half;
}

void Driver::write64(std::uint32_t low, std::uint64_t value) {
  port_.write32(low, static_cast<std::uint32_t>(value));
  port_.write32(low + 4, static_cast<std::uint32_t>(value >> 32));
}

std::uint32_t Driver::status() { return port_.read32(HWFFD_STATUS_OFFSET); }

CoreIdentity Driver::probe() {
  const std::uint32_t id = port_.read32(HWFFD_ID_OFFSET);
  if (id != HWFFD_ID_RESET) throw DriverError("no hwffd here: ID reads " + std::to_string(id));
  const std::uint32_t version = port_.read32(HWFFD_VERSION_OFFSET);
  const std::uint32_t config = port_.read32(HWFFD_CONFIG_OFFSET);
  const std::uint32_t limits = port_.read32(HWFFD_LIMITS_OFFSET);
  CoreIdentity identity{};
  identity.version_major = field(version, HWFFD_VERSION_MAJOR_MASK, HWFFD_VERSION_MAJOR_SHIFT);
  identity.version_minor = field(version, HWFFD_VERSION_MINOR_MASK, HWFFD_VERSION_MINOR_SHIFT);
  identity.version_patch = field(version, HWFFD_VERSION_PATCH_MASK, HWFFD_VERSION_PATCH_SHIFT);
  identity.org = field(config, HWFFD_CONFIG_ORG_MASK, HWFFD_CONFIG_ORG_SHIFT);
  identity.n = field(config, HWFFD_CONFIG_N_MASK, HWFFD_CONFIG_N_SHIFT);
  identity.format = field(config, HWFFD_CONFIG_FORMAT_MASK, HWFFD_CONFIG_FORMAT_SHIFT);
  identity.schedule = field(config, HWFFD_CONFIG_SCHEDULE_MASK, HWFFD_CONFIG_SCHEDULE_SHIFT);
  identity.evaluator = field(config, HWFFD_CONFIG_EVALUATOR_MASK, HWFFD_CONFIG_EVALUATOR_SHIFT);
  identity.in_flight = field(limits, HWFFD_LIMITS_IN_FLIGHT_MASK, HWFFD_LIMITS_IN_FLIGHT_SHIFT);
  identity.points_axis =
      field(limits, HWFFD_LIMITS_POINTS_AXIS_MASK, HWFFD_LIMITS_POINTS_AXIS_SHIFT);
  if (identity.version_major != kMajor) {
    throw DriverError("registers of version " + std::to_string(identity.version_major) +
                      ", this driver knows " + std::to_string(kMajor));
  }
  read_features(identity);
  core_ = identity;
  return identity;
}

/// Cores before these registers were there have all that the first ones had.
void Driver::read_features(CoreIdentity& identity) {
  try {
    identity.features = port_.read32(HWFFD_FEATURES_OFFSET);
    const std::uint32_t limits = port_.read32(HWFFD_LIMITS2_OFFSET);
    identity.pages = field(limits, HWFFD_LIMITS2_PAGES_MASK, HWFFD_LIMITS2_PAGES_SHIFT);
    identity.count_width =
        field(limits, HWFFD_LIMITS2_COUNT_WIDTH_MASK, HWFFD_LIMITS2_COUNT_WIDTH_SHIFT);
    identity.spans = field(limits, HWFFD_LIMITS2_SPANS_MASK, HWFFD_LIMITS2_SPANS_SHIFT);
  } catch (const RegisterError&) {
    identity.features = HWFFD_FEATURES_RESIDENT_MASK | HWFFD_FEATURES_INTERLEAVED_MASK |
                        HWFFD_FEATURES_DERIVATIVES_MASK | HWFFD_FEATURES_DETERMINANT_MASK;
    identity.pages = 2;
    identity.spans = 1;
  }
}

void Driver::check(const PacketHeader& header) const {
  if (!core_) throw DriverError("the core is not known yet: probe it first");
  check_packet(*core_, header);
}

void Driver::set_windows(const AddressWindow& read, const AddressWindow& write) {
  if (read.base > read.limit || write.base > write.limit) {
    throw DriverError("a window's base is above its limit");
  }
  if (windows_locked()) throw DriverError("the windows are locked until reset");
  write64(HWFFD_READ_WINDOW_BASE_LO_OFFSET, read.base);
  write64(HWFFD_READ_WINDOW_LIMIT_LO_OFFSET, read.limit);
  write64(HWFFD_WRITE_WINDOW_BASE_LO_OFFSET, write.base);
  write64(HWFFD_WRITE_WINDOW_LIMIT_LO_OFFSET, write.limit);
}

void Driver::lock_windows() {
  port_.write32(HWFFD_WINDOW_LOCK_OFFSET, HWFFD_WINDOW_LOCK_WINDOWS_MASK);
}

bool Driver::windows_locked() {
  return (port_.read32(HWFFD_WINDOW_LOCK_OFFSET) & HWFFD_WINDOW_LOCK_WINDOWS_MASK) != 0;
}

void Driver::set_ring(const DescriptorRing& ring) {
  if (ring.log2_size < 1 || ring.log2_size > HWFFD_RING_LOG2_SIZE_MASK) {
    throw DriverError("a ring of 2^" + std::to_string(ring.log2_size) +
                      " descriptors: 2^1 to 2^15 are possible");
  }
  const unsigned size = 1u << ring.log2_size;
  if (ring.base % (kDescriptorBytes * size) != 0) {
    throw DriverError("the ring's base is no multiple of its " +
                      std::to_string(kDescriptorBytes * size) + " bytes");
  }
  const std::uint32_t tail = port_.read32(HWFFD_RING_TAIL_OFFSET);
  if (tail >= size || (status() & HWFFD_STATUS_RING_RUNNING_MASK) != 0) {
    throw DriverError("another ring is in use: soft reset first");
  }
  write64(HWFFD_RING_BASE_LO_OFFSET, ring.base);
  port_.write32(HWFFD_RING_LOG2_SIZE_OFFSET, ring.log2_size);
  port_.write32(HWFFD_RING_HEAD_OFFSET, tail);
  ring_size_ = size;
}

void Driver::set_results(const ResultArea& area) {
  if (area.bytes == 0 || area.base % kBeatBytes != 0 || area.bytes % kBeatBytes != 0) {
    throw DriverError("result area: base and bytes must be multiples of 16, bytes not 0");
  }
  write64(HWFFD_RESULT_BASE_LO_OFFSET, area.base);
  port_.write32(HWFFD_RESULT_SIZE_OFFSET, area.bytes);
}

std::array<std::uint32_t, 4> Driver::descriptor(std::uint64_t address, std::uint32_t bytes,
                                                bool interrupt) const {
  if (bytes == 0 || address % kBeatBytes != 0 || bytes % kBeatBytes != 0) {
    throw DriverError("descriptor: address and bytes must be multiples of 16, bytes not 0");
  }
  if (interrupt && !core_) throw DriverError("the core is not known yet: probe it first");
  if (interrupt && (core_->features & HWFFD_FEATURES_MARKS_MASK) == 0) {
    throw DriverError(
        "this core has no interrupts of descriptors: wait for the end of the run, or"
        " build it with FEATURES + " +
        std::to_string(HWFFD_FEATURES_MARKS_MASK));
  }
  return {static_cast<std::uint32_t>(address), static_cast<std::uint32_t>(address >> 32), bytes,
          interrupt ? 1U : 0U};
}

void Driver::push(unsigned descriptors) {
  const unsigned used = pending();
  if (descriptors > ring_size_ - 1 - used) {
    throw DriverError("no room for " + std::to_string(descriptors) +
                      " descriptors: " + std::to_string(used) + " of " +
                      std::to_string(ring_size_ - 1) + " are pending");
  }
  const std::uint32_t head = port_.read32(HWFFD_RING_HEAD_OFFSET);
  port_.write32(HWFFD_RING_HEAD_OFFSET, (head + descriptors) & (ring_size_ - 1));
}

unsigned Driver::next_entry() { return port_.read32(HWFFD_RING_HEAD_OFFSET) & (ring_size_ - 1); }

unsigned Driver::pending() {
  const std::uint32_t head = port_.read32(HWFFD_RING_HEAD_OFFSET);
  return (head - port_.read32(HWFFD_RING_TAIL_OFFSET)) & (ring_size_ - 1);
}

void Driver::start() {
  port_.write32(HWFFD_STATUS_OFFSET, HWFFD_STATUS_DONE_MASK | HWFFD_STATUS_START_REFUSED_MASK);
  take_interrupts();
  port_.write32(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_START_MASK);
  const std::uint32_t now = status();
  if ((now & HWFFD_STATUS_START_REFUSED_MASK) == 0) return;
  if (!windows_locked()) throw DriverError("start refused: lock the windows first");
  throw DriverError((now & HWFFD_STATUS_STOPPED_MASK) != 0
                        ? "start refused: a bus error stopped the DMA: soft reset first"
                        : "start refused: busy");
}

bool Driver::wait_done(std::uint64_t polls) {
  for (std::uint64_t i = 0; i < polls; ++i) {
    if ((status() & HWFFD_STATUS_DONE_MASK) != 0) return true;
  }
  return false;
}

bool Driver::stopped() { return (status() & HWFFD_STATUS_STOPPED_MASK) != 0; }

std::uint32_t Driver::result_count() { return port_.read32(HWFFD_RESULT_COUNT_OFFSET); }

CoreErrors Driver::take_errors() {
  CoreErrors errors;
  errors.status = port_.read32(HWFFD_ERROR_STATUS_OFFSET);
  errors.count = port_.read32(HWFFD_ERROR_COUNT_OFFSET);
  const std::uint32_t first = port_.read32(HWFFD_ERROR_FIRST_OFFSET);
  if ((first & HWFFD_ERROR_FIRST_VALID_MASK) != 0) {
    FirstError error;
    error.code = field(first, HWFFD_ERROR_FIRST_CODE_MASK, HWFFD_ERROR_FIRST_CODE_SHIFT);
    error.packet = port_.read32(HWFFD_ERROR_PACKET_OFFSET);
    error.beat = port_.read32(HWFFD_ERROR_BEAT_OFFSET);
    error.address = read64(HWFFD_ERROR_ADDRESS_LO_OFFSET);
    errors.first = error;
    // An error of another code that comes meanwhile keeps its bit: only those read are cleared.
    port_.write32(HWFFD_ERROR_FIRST_OFFSET, HWFFD_ERROR_FIRST_VALID_MASK);
  }
  if (errors.status != 0) port_.write32(HWFFD_ERROR_STATUS_OFFSET, errors.status);
  return errors;
}

bool Driver::soft_reset(std::uint64_t polls) {
  port_.write32(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_SOFT_RESET_MASK);
  for (std::uint64_t i = 0; i < polls; ++i) {
    const std::uint32_t activity = HWFFD_STATUS_BUSY_MASK | HWFFD_STATUS_IDLE_MASK;
    if ((status() & activity) != HWFFD_STATUS_IDLE_MASK) continue;
    port_.write32(HWFFD_RING_HEAD_OFFSET, 0);  // as RING_TAIL
    ring_size_ = 1;
    return true;
  }
  return false;
}

CoreCounters Driver::counters() {
  CoreCounters counters;
  counters.vertices = read64(HWFFD_COUNTER_VERTICES_LO_OFFSET);
  counters.stalls = read64(HWFFD_COUNTER_STALLS_LO_OFFSET);
  counters.busy = read64(HWFFD_COUNTER_BUSY_LO_OFFSET);
  return counters;
}

CoreWaits Driver::waits() {
  if (!core_) throw DriverError("the core is not known yet: probe it first");
  if (core_->count_width == 0) {
    throw DriverError("this core counts no waits: build it with COUNT_WIDTH 32");
  }
  CoreWaits waits;
  waits.input = port_.read32(HWFFD_WAIT_INPUT_OFFSET);
  waits.memory = port_.read32(HWFFD_WAIT_MEMORY_OFFSET);
  waits.evaluator = port_.read32(HWFFD_WAIT_EVALUATOR_OFFSET);
  waits.forming = port_.read32(HWFFD_WAIT_FORMING_OFFSET);
  waits.read = port_.read32(HWFFD_WAIT_READ_OFFSET);
  waits.write = port_.read32(HWFFD_WAIT_WRITE_OFFSET);
  return waits;
}

void Driver::clear_counters() {
  port_.write32(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_CLEAR_COUNTERS_MASK);
}

void Driver::enable_interrupts(std::uint32_t bits) { port_.write32(HWFFD_IRQ_ENABLE_OFFSET, bits); }

std::uint32_t Driver::take_interrupts() {
  const std::uint32_t state = port_.read32(HWFFD_IRQ_STATE_OFFSET);
  if (state != 0) port_.write32(HWFFD_IRQ_STATE_OFFSET, state);
  return state;
}

void Driver::test_interrupts(std::uint32_t bits) { port_.write32(HWFFD_IRQ_TEST_OFFSET, bits); }

}  // namespace hwffd
