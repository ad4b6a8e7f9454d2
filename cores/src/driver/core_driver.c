#include "hwffd/core_driver.h"

#include "hwffd/registers.h"

typedef enum hwffd_core_status Status;

enum { kDescriptorBytes = 16, kBeatBytes = 16 };

// Ends the function that it stands in where an access went wrong.
#define CHECK(call)                               \
  do {                                            \
    const Status status_ = (call);                \
    if (status_ != HWFFD_CORE_OK) return status_; \
  } while (0)

#define FIELD(word, name) (((word)&HWFFD_##name##_MASK) >> HWFFD_##name##_SHIFT)

const char* hwffd_core_text(Status status) {
  switch (status) {
    case HWFFD_CORE_OK:
      return "nothing is wrong";
    case HWFFD_CORE_BUS_ERROR:
      return "the bus answered an access to a register with an error";
    case HWFFD_CORE_ABSENT:
      return "no hwffd here: ID is another";
    case HWFFD_CORE_OTHER_VERSION:
      return "registers of a version that this driver does not know";
    case HWFFD_CORE_NOT_PROBED:
      return "the core is not known yet: probe it first";
    case HWFFD_CORE_WINDOW:
      return "a window's base is above its limit";
    case HWFFD_CORE_LOCKED:
      return "the windows are locked until reset";
    case HWFFD_CORE_RING_SIZE:
      return "a ring has 2^1 to 2^15 descriptors";
    case HWFFD_CORE_RING_BASE:
      return "the ring's base is no multiple of its size";
    case HWFFD_CORE_RING_USED:
      return "another ring is in use: soft reset first";
    case HWFFD_CORE_RING_FULL:
      return "no room for so many descriptors in the ring";
    case HWFFD_CORE_AREA:
      return "address and bytes must be multiples of 16, bytes not 0";
    case HWFFD_CORE_NO_MARKS:
      return "this core has no interrupts of descriptors: wait for the end of the run";
    case HWFFD_CORE_UNLOCKED:
      return "start refused: lock the windows first";
    case HWFFD_CORE_STOPPED:
      return "start refused: a bus error stopped the DMA: soft reset first";
    case HWFFD_CORE_BUSY:
      return "start refused: busy";
    case HWFFD_CORE_LATE:
      return "the core does not end: soft reset";
  }
  return "no status of hwffd";
}

static Status read32(struct hwffd_core* core, uint32_t offset, uint32_t* value) {
  return core->port.read32(core->port.context, offset, value) == 0 ? HWFFD_CORE_OK
                                                                   : HWFFD_CORE_BUS_ERROR;
}

static Status write32(struct hwffd_core* core, uint32_t offset, uint32_t value) {
  return core->port.write32(core->port.context, offset, value) == 0 ? HWFFD_CORE_OK
                                                                    : HWFFD_CORE_BUS_ERROR;
}

static Status read64(struct hwffd_core* core, uint32_t low, uint64_t* value) {
  uint32_t half = 0;
  uint32_t high = 0;
  CHECK(read32(core, low, &half));
  CHECK(read32(core, low + 4, &high));
  *value = (uint64_t)high << 32 | half;
  return HWFFD_CORE_OK;
}

static Status write64(struct hwffd_core* core, uint32_t low, uint64_t value) {
  CHECK(write32(core, low, (uint32_t)value));
  return write32(core, low + 4, (uint32_t)(value >> 32));
}

/** Cores before these registers were there have all that the first ones had. */
static Status read_features(struct hwffd_core* core) {
  struct hwffd_core_identity* identity = &core->identity;
  uint32_t limits = 0;
  if (read32(core, HWFFD_FEATURES_OFFSET, &identity->features) != HWFFD_CORE_OK ||
      read32(core, HWFFD_LIMITS2_OFFSET, &limits) != HWFFD_CORE_OK) {
    identity->features = HWFFD_FEATURES_RESIDENT_MASK | HWFFD_FEATURES_INTERLEAVED_MASK |
                         HWFFD_FEATURES_DERIVATIVES_MASK | HWFFD_FEATURES_DETERMINANT_MASK;
    identity->pages = 2;
    identity->spans = 1;
    identity->count_width = 0;
    return HWFFD_CORE_OK;
  }
  identity->pages = FIELD(limits, LIMITS2_PAGES);
  identity->spans = FIELD(limits, LIMITS2_SPANS);
  identity->count_width = FIELD(limits, LIMITS2_COUNT_WIDTH);
  return HWFFD_CORE_OK;
}

Status hwffd_core_probe(struct hwffd_core* core) {
  struct hwffd_core_identity* identity = &core->identity;
  uint32_t id = 0;
  uint32_t version = 0;
  uint32_t config = 0;
  uint32_t limits = 0;
  core->probed = 0;
  CHECK(read32(core, HWFFD_ID_OFFSET, &id));
  if (id != HWFFD_ID_RESET) return HWFFD_CORE_ABSENT;
  CHECK(read32(core, HWFFD_VERSION_OFFSET, &version));
  identity->version_major = FIELD(version, VERSION_MAJOR);
  identity->version_minor = FIELD(version, VERSION_MINOR);
  identity->version_patch = FIELD(version, VERSION_PATCH);
  if (identity->version_major != HWFFD_VERSION_MAJOR_RESET) return HWFFD_CORE_OTHER_VERSION;
  CHECK(read32(core, HWFFD_CONFIG_OFFSET, &config));
  CHECK(read32(core, HWFFD_LIMITS_OFFSET, &limits));
  identity->org = FIELD(config, CONFIG_ORG);
  identity->n = FIELD(config, CONFIG_N);
  identity->format = FIELD(config, CONFIG_FORMAT);
  identity->schedule = FIELD(config, CONFIG_SCHEDULE);
  identity->evaluator = FIELD(config, CONFIG_EVALUATOR);
  identity->in_flight = FIELD(limits, LIMITS_IN_FLIGHT);
  identity->points_axis = FIELD(limits, LIMITS_POINTS_AXIS);
  identity->grid_limit = FIELD(limits, LIMITS_GRID_LIMIT);
  CHECK(read_features(core));
  core->probed = 1;
  return HWFFD_CORE_OK;
}

Status hwffd_core_windows_locked(struct hwffd_core* core, int* locked) {
  uint32_t lock = 0;
  CHECK(read32(core, HWFFD_WINDOW_LOCK_OFFSET, &lock));
  *locked = (lock & HWFFD_WINDOW_LOCK_WINDOWS_MASK) != 0;
  return HWFFD_CORE_OK;
}

Status hwffd_core_set_windows(struct hwffd_core* core, uint64_t read_base, uint64_t read_limit,
                              uint64_t write_base, uint64_t write_limit) {
  int locked = 0;
  if (read_base > read_limit || write_base > write_limit) return HWFFD_CORE_WINDOW;
  CHECK(hwffd_core_windows_locked(core, &locked));
  if (locked) return HWFFD_CORE_LOCKED;
  CHECK(write64(core, HWFFD_READ_WINDOW_BASE_LO_OFFSET, read_base));
  CHECK(write64(core, HWFFD_READ_WINDOW_LIMIT_LO_OFFSET, read_limit));
  CHECK(write64(core, HWFFD_WRITE_WINDOW_BASE_LO_OFFSET, write_base));
  return write64(core, HWFFD_WRITE_WINDOW_LIMIT_LO_OFFSET, write_limit);
}

Status hwffd_core_lock_windows(struct hwffd_core* core) {
  return write32(core, HWFFD_WINDOW_LOCK_OFFSET, HWFFD_WINDOW_LOCK_WINDOWS_MASK);
}

Status hwffd_core_set_ring(struct hwffd_core* core, uint64_t base, unsigned log2_size) {
  uint32_t tail = 0;
  uint32_t status = 0;
  if (log2_size < 1 || log2_size > HWFFD_RING_LOG2_SIZE_MASK) return HWFFD_CORE_RING_SIZE;
  const uint32_t size = 1u << log2_size;
  if ((base & (kDescriptorBytes * size - 1)) != 0) return HWFFD_CORE_RING_BASE;
  CHECK(read32(core, HWFFD_RING_TAIL_OFFSET, &tail));
  CHECK(read32(core, HWFFD_STATUS_OFFSET, &status));
  if (tail >= size || (status & HWFFD_STATUS_RING_RUNNING_MASK) != 0) return HWFFD_CORE_RING_USED;
  CHECK(write64(core, HWFFD_RING_BASE_LO_OFFSET, base));
  CHECK(write32(core, HWFFD_RING_LOG2_SIZE_OFFSET, log2_size));
  CHECK(write32(core, HWFFD_RING_HEAD_OFFSET, tail));
  core->ring_size = size;
  return HWFFD_CORE_OK;
}

/** What a transfer or an area may not be. */
static int is_bad(uint64_t address, uint32_t bytes) {
  return bytes == 0 || address % kBeatBytes != 0 || bytes % kBeatBytes != 0;
}

Status hwffd_core_set_results(struct hwffd_core* core, uint64_t base, uint32_t bytes) {
  if (is_bad(base, bytes)) return HWFFD_CORE_AREA;
  CHECK(write64(core, HWFFD_RESULT_BASE_LO_OFFSET, base));
  return write32(core, HWFFD_RESULT_SIZE_OFFSET, bytes);
}

Status hwffd_core_descriptor(const struct hwffd_core* core, uint32_t descriptor[4],
                             uint64_t address, uint32_t bytes, int interrupt) {
  if (is_bad(address, bytes)) return HWFFD_CORE_AREA;
  if (interrupt && !core->probed) return HWFFD_CORE_NOT_PROBED;
  if (interrupt && (core->identity.features & HWFFD_FEATURES_MARKS_MASK) == 0) {
    return HWFFD_CORE_NO_MARKS;
  }
  descriptor[0] = (uint32_t)address;
  descriptor[1] = (uint32_t)(address >> 32);
  descriptor[2] = bytes;
  descriptor[3] = interrupt ? 1u : 0u;
  return HWFFD_CORE_OK;
}

static unsigned ring_mask(const struct hwffd_core* core) {
  return core->ring_size == 0 ? 0 : core->ring_size - 1;
}

Status hwffd_core_next_entry(struct hwffd_core* core, unsigned* entry) {
  uint32_t head = 0;
  CHECK(read32(core, HWFFD_RING_HEAD_OFFSET, &head));
  *entry = head & ring_mask(core);
  return HWFFD_CORE_OK;
}

Status hwffd_core_pending(struct hwffd_core* core, unsigned* pending) {
  uint32_t head = 0;
  uint32_t tail = 0;
  CHECK(read32(core, HWFFD_RING_HEAD_OFFSET, &head));
  CHECK(read32(core, HWFFD_RING_TAIL_OFFSET, &tail));
  *pending = (head - tail) & ring_mask(core);
  return HWFFD_CORE_OK;
}

Status hwffd_core_push(struct hwffd_core* core, unsigned descriptors) {
  unsigned pending = 0;
  uint32_t head = 0;
  CHECK(hwffd_core_pending(core, &pending));
  if (descriptors > ring_mask(core) - pending) return HWFFD_CORE_RING_FULL;
  CHECK(read32(core, HWFFD_RING_HEAD_OFFSET, &head));
  return write32(core, HWFFD_RING_HEAD_OFFSET, (head + descriptors) & ring_mask(core));
}

Status hwffd_core_take_interrupts(struct hwffd_core* core, uint32_t* bits) {
  CHECK(read32(core, HWFFD_IRQ_STATE_OFFSET, bits));
  return *bits == 0 ? HWFFD_CORE_OK : write32(core, HWFFD_IRQ_STATE_OFFSET, *bits);
}

Status hwffd_core_enable_interrupts(struct hwffd_core* core, uint32_t bits) {
  return write32(core, HWFFD_IRQ_ENABLE_OFFSET, bits);
}

Status hwffd_core_start(struct hwffd_core* core) {
  uint32_t bits = 0;
  uint32_t status = 0;
  int locked = 0;
  CHECK(
      write32(core, HWFFD_STATUS_OFFSET, HWFFD_STATUS_DONE_MASK | HWFFD_STATUS_START_REFUSED_MASK));
  CHECK(hwffd_core_take_interrupts(core, &bits));
  CHECK(write32(core, HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_START_MASK));
  CHECK(read32(core, HWFFD_STATUS_OFFSET, &status));
  if ((status & HWFFD_STATUS_START_REFUSED_MASK) == 0) return HWFFD_CORE_OK;
  CHECK(hwffd_core_windows_locked(core, &locked));
  if (!locked) return HWFFD_CORE_UNLOCKED;
  return (status & HWFFD_STATUS_STOPPED_MASK) != 0 ? HWFFD_CORE_STOPPED : HWFFD_CORE_BUSY;
}

Status hwffd_core_wait_done(struct hwffd_core* core, uint64_t polls) {
  uint32_t status = 0;
  for (uint64_t i = 0; i < polls; ++i) {
    CHECK(read32(core, HWFFD_STATUS_OFFSET, &status));
    if ((status & HWFFD_STATUS_DONE_MASK) != 0) return HWFFD_CORE_OK;
  }
  return HWFFD_CORE_LATE;
}

Status hwffd_core_result_count(struct hwffd_core* core, uint32_t* count) {
  return read32(core, HWFFD_RESULT_COUNT_OFFSET, count);
}

Status hwffd_core_stopped(struct hwffd_core* core, int* stopped) {
  uint32_t status = 0;
  CHECK(read32(core, HWFFD_STATUS_OFFSET, &status));
  *stopped = (status & HWFFD_STATUS_STOPPED_MASK) != 0;
  return HWFFD_CORE_OK;
}

Status hwffd_core_take_errors(struct hwffd_core* core, struct hwffd_core_errors* errors) {
  uint32_t first = 0;
  CHECK(read32(core, HWFFD_ERROR_STATUS_OFFSET, &errors->status));
  CHECK(read32(core, HWFFD_ERROR_COUNT_OFFSET, &errors->count));
  CHECK(read32(core, HWFFD_ERROR_FIRST_OFFSET, &first));
  errors->recorded = (first & HWFFD_ERROR_FIRST_VALID_MASK) != 0;
  if (errors->recorded) {
    errors->first_code = FIELD(first, ERROR_FIRST_CODE);
    CHECK(read32(core, HWFFD_ERROR_PACKET_OFFSET, &errors->first_packet));
    CHECK(read32(core, HWFFD_ERROR_BEAT_OFFSET, &errors->first_beat));
    CHECK(read64(core, HWFFD_ERROR_ADDRESS_LO_OFFSET, &errors->first_address));
    // An error of another code that comes meanwhile keeps its bit: only those read are cleared.
    CHECK(write32(core, HWFFD_ERROR_FIRST_OFFSET, HWFFD_ERROR_FIRST_VALID_MASK));
  }
  return errors->status == 0 ? HWFFD_CORE_OK
                             : write32(core, HWFFD_ERROR_STATUS_OFFSET, errors->status);
}

Status hwffd_core_soft_reset(struct hwffd_core* core, uint64_t polls) {
  const uint32_t activity = HWFFD_STATUS_BUSY_MASK | HWFFD_STATUS_IDLE_MASK;
  uint32_t status = 0;
  CHECK(write32(core, HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_SOFT_RESET_MASK));
  for (uint64_t i = 0; i < polls; ++i) {
    CHECK(read32(core, HWFFD_STATUS_OFFSET, &status));
    if ((status & activity) != HWFFD_STATUS_IDLE_MASK) continue;
    core->ring_size = 1;
    return write32(core, HWFFD_RING_HEAD_OFFSET, 0);  // as RING_TAIL
  }
  return HWFFD_CORE_LATE;
}

Status hwffd_core_stop_grid(struct hwffd_core* core) {
  return write32(core, HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_STOP_GRID_MASK);
}
