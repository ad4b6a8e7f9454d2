#include "hwffd/driver.hpp"

#include <exception>
#include <string>

#include "hwffd/registers.h"

namespace hwffd {
namespace {

constexpr std::uint64_t kDescriptorBytes = 16;

/// An access that the sequence in C makes. What the port throws waits until that has returned.
struct Access {
  RegisterPort& port;
  std::exception_ptr thrown;

  template <class Body>
  int tried(const Body& body) {
    try {
      body();
      return 0;
    } catch (...) {
      thrown = std::current_exception();
      return 1;
    }
  }
};

int read_register(void* context, std::uint32_t offset, std::uint32_t* value) {
  auto& access = *static_cast<Access*>(context);
  return access.tried([&] { *value = access.port.read32(offset); });
}

int write_register(void* context, std::uint32_t offset, std::uint32_t value) {
  auto& access = *static_cast<Access*>(context);
  return access.tried([&] { access.port.write32(offset, value); });
}

}  // namespace

/// The status of a step in C; throws what the port throws.
template <class Step, class... Arguments>
hwffd_core_status Driver::status_of(const Step& step, Arguments... arguments) {
  Access access{port_, nullptr};
  sequence_.port = {&access, read_register, write_register};
  const hwffd_core_status status = step(&sequence_, arguments...);
  sequence_.port = {};
  if (access.thrown == nullptr) return status;
  try {
    std::rethrow_exception(access.thrown);
  } catch (const RegisterError&) {
    if (status == HWFFD_CORE_BUS_ERROR) throw;
    return status;  // a register that a core may lack
  }
}

/// The same; any other status than HWFFD_CORE_OK is a DriverError.
template <class Step, class... Arguments>
void Driver::go(const Step& step, Arguments... arguments) {
  const hwffd_core_status status = status_of(step, arguments...);
  if (status != HWFFD_CORE_OK) throw DriverError(hwffd_core_text(status));
}

std::uint64_t Driver::read64(std::uint32_t low) {
  const std::uint64_t half = port_.read32(low);
  return std::uint64_t{port_.read32(low + 4)} << 32 | half;
}

CoreIdentity Driver::probe() {
  const hwffd_core_status status = status_of(hwffd_core_probe);
  const hwffd_core_identity& is = sequence_.identity;
  if (status == HWFFD_CORE_ABSENT) {
    throw DriverError("no hwffd here: ID reads " + std::to_string(port_.read32(HWFFD_ID_OFFSET)));
  }
  if (status == HWFFD_CORE_OTHER_VERSION) {
    throw DriverError("registers of version " + std::to_string(is.version_major) +
                      ", this driver knows " + std::to_string(HWFFD_VERSION_MAJOR_RESET));
  }
  core_ = CoreIdentity{
      is.version_major, is.version_minor, is.version_patch, is.org,       is.n,
      is.format,        is.schedule,      is.evaluator,     is.in_flight, is.points_axis,
      is.features,      is.pages,         is.count_width,   is.spans,     is.grid_limit};
  return *core_;
}

void Driver::check(const PacketHeader& header) const {
  if (!core_) throw DriverError(hwffd_core_text(HWFFD_CORE_NOT_PROBED));
  check_packet(*core_, header);
}

void Driver::set_windows(const AddressWindow& read, const AddressWindow& write) {
  go(hwffd_core_set_windows, read.base, read.limit, write.base, write.limit);
}

void Driver::lock_windows() { go(hwffd_core_lock_windows); }

bool Driver::windows_locked() {
  int locked = 0;
  go(hwffd_core_windows_locked, &locked);
  return locked != 0;
}

void Driver::set_ring(const DescriptorRing& ring) {
  const hwffd_core_status status = status_of(hwffd_core_set_ring, ring.base, ring.log2_size);
  if (status == HWFFD_CORE_RING_SIZE) {
    throw DriverError("a ring of 2^" + std::to_string(ring.log2_size) +
                      " descriptors: 2^1 to 2^15 are possible");
  }
  if (status == HWFFD_CORE_RING_BASE) {
    throw DriverError("the ring's base is no multiple of its " +
                      std::to_string(kDescriptorBytes << ring.log2_size) + " bytes");
  }
  if (status != HWFFD_CORE_OK) throw DriverError(hwffd_core_text(status));
}

void Driver::set_results(const ResultArea& area) {
  const hwffd_core_status status = status_of(hwffd_core_set_results, area.base, area.bytes);
  if (status == HWFFD_CORE_OK) return;
  throw DriverError("result area: base and bytes must be multiples of 16, bytes not 0");
}

std::array<std::uint32_t, 4> Driver::descriptor(std::uint64_t address, std::uint32_t bytes,
                                                bool interrupt) const {
  std::array<std::uint32_t, 4> words{};
  const hwffd_core_status status =
      hwffd_core_descriptor(&sequence_, words.data(), address, bytes, interrupt ? 1 : 0);
  if (status == HWFFD_CORE_OK) return words;
  const std::string text = hwffd_core_text(status);
  if (status == HWFFD_CORE_AREA) throw DriverError("descriptor: " + text);
  if (status != HWFFD_CORE_NO_MARKS) throw DriverError(text);
  throw DriverError(text + ", or build it with MARKS = 1");
}

void Driver::push(unsigned descriptors) {
  const hwffd_core_status status = status_of(hwffd_core_push, descriptors);
  if (status == HWFFD_CORE_OK) return;
  const unsigned room = sequence_.ring_size == 0 ? 0 : sequence_.ring_size - 1;
  throw DriverError("no room for " + std::to_string(descriptors) + " descriptors: " +
                    std::to_string(pending()) + " of " + std::to_string(room) + " are pending");
}

unsigned Driver::next_entry() {
  unsigned entry = 0;
  go(hwffd_core_next_entry, &entry);
  return entry;
}

unsigned Driver::pending() {
  unsigned pending = 0;
  go(hwffd_core_pending, &pending);
  return pending;
}

void Driver::start() { go(hwffd_core_start); }

bool Driver::wait_done(std::uint64_t polls) {
  return status_of(hwffd_core_wait_done, polls) == HWFFD_CORE_OK;
}

bool Driver::stopped() {
  int stopped = 0;
  go(hwffd_core_stopped, &stopped);
  return stopped != 0;
}

std::uint32_t Driver::result_count() {
  std::uint32_t count = 0;
  go(hwffd_core_result_count, &count);
  return count;
}

CoreErrors Driver::take_errors() {
  hwffd_core_errors taken{};
  go(hwffd_core_take_errors, &taken);
  CoreErrors errors;
  errors.status = taken.status;
  errors.count = taken.count;
  if (taken.recorded != 0) {
    errors.first =
        FirstError{taken.first_code, taken.first_packet, taken.first_beat, taken.first_address};
  }
  return errors;
}

void Driver::stop_grid() { go(hwffd_core_stop_grid); }

bool Driver::soft_reset(std::uint64_t polls) {
  return status_of(hwffd_core_soft_reset, polls) == HWFFD_CORE_OK;
}

CoreCounters Driver::counters() {
  CoreCounters counters;
  counters.vertices = read64(HWFFD_COUNTER_VERTICES_LO_OFFSET);
  counters.stalls = read64(HWFFD_COUNTER_STALLS_LO_OFFSET);
  counters.busy = read64(HWFFD_COUNTER_BUSY_LO_OFFSET);
  return counters;
}

CoreWaits Driver::waits() {
  if (!core_) throw DriverError(hwffd_core_text(HWFFD_CORE_NOT_PROBED));
  if (core_->count_width == 0) {
    throw DriverError("this core counts no waits: build it with COUNT_WIDTH 32");
  }
  CoreWaits waits;
  waits.input = port_.read32(HWFFD_WAIT_INPUT_OFFSET);
  waits.memory = port_.read32(HWFFD_WAIT_MEMORY_OFFSET);
  waits.evaluator = port_.read32(HWFFD_WAIT_EVALUATOR_OFFSET);
  waits.read = port_.read32(HWFFD_WAIT_READ_OFFSET);
  waits.write = port_.read32(HWFFD_WAIT_WRITE_OFFSET);
  return waits;
}

void Driver::clear_counters() {
  port_.write32(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_CLEAR_COUNTERS_MASK);
}

void Driver::enable_interrupts(std::uint32_t bits) { go(hwffd_core_enable_interrupts, bits); }

std::uint32_t Driver::take_interrupts() {
  std::uint32_t bits = 0;
  go(hwffd_core_take_interrupts, &bits);
  return bits;
}

void Driver::test_interrupts(std::uint32_t bits) { port_.write32(HWFFD_IRQ_TEST_OFFSET, bits); }

}  // namespace hwffd
