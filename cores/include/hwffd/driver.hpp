#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "hwffd/core_driver.h"
#include "hwffd/error.hpp"
#include "hwffd/register_port.hpp"
#include "hwffd/stream/resident_pages.hpp"

namespace hwffd {

/// What went wrong between driver and core, in one line.
class DriverError : public Error {
 public:
  using Error::Error;
};

/// The bus answered an access with an error response. For implementations of RegisterPort.
class RegisterError : public DriverError {
 public:
  using DriverError::DriverError;
};

/// What was built: VERSION, CONFIG, LIMITS, FEATURES and LIMITS2.
struct CoreIdentity {
  unsigned version_major, version_minor, version_patch;
  unsigned org;            ///< number in rtl/organizations.csv
  unsigned n;              ///< units of a step
  unsigned format;         ///< 0 fp32, W fxW, 99 bfp32
  unsigned schedule;       ///< 0 overlapped, 1 paper
  unsigned evaluator;      ///< 0 pipelined, 1 iterative, 3 powers
  unsigned in_flight;      ///< most evaluations at once
  unsigned points_axis;    ///< of the resident lattice; 0: none
  std::uint32_t features;  ///< HWFFD_FEATURES_*_MASK
  unsigned pages;          ///< of points, the two buffers of opcode 2 among them; 0: none
  unsigned count_width;    ///< bits of the counts of waits, 8 to 32; 0: there are none
  unsigned spans;          ///< of an axis, each with functions of its own
  unsigned grid_limit;     ///< a grid has 2^grid_limit vertices at most; 0 without grids
};

/// A packet's first beat: the four words of its header (docs/interface.md section 2).
using PacketHeader = std::array<std::uint32_t, 4>;

/// Throws DriverError, which names what is missing and the cure, where a core that was built so
/// would drop the packet, or give nothing but blanks for it. A header says all that is needed.
void check_packet(const CoreIdentity& core, const PacketHeader& header);

/// Addresses from base to limit, both included. Both 0, as after reset: too small for any transfer.
struct AddressWindow {
  std::uint64_t base = 0;
  std::uint64_t limit = 0;
};

/// 2^log2_size descriptors of 16 bytes, 2 to 2^15, from base on, a multiple of the ring's size; one
/// stays unused.
struct DescriptorRing {
  std::uint64_t base = 0;
  unsigned log2_size = 0;
};

struct ResultArea {
  std::uint64_t base = 0;
  std::uint32_t bytes = 0;
};

struct CoreCounters {
  std::uint64_t vertices = 0;
  std::uint64_t stalls = 0;
  std::uint64_t busy = 0;
};

/// Clocks in which something waited; each wraps at 2 to the power of CoreIdentity::count_width.
struct CoreWaits {
  std::uint32_t input = 0;      ///< the core for a beat, during a run
  std::uint32_t memory = 0;     ///< coefficients or a lattice, for what they overwrite
  std::uint32_t evaluator = 0;  ///< a vertex, for room in the evaluator
  std::uint32_t read = 0;       ///< a read burst for its data
  std::uint32_t write = 0;      ///< a burst of results for its response
};

/// The first error since the record was last cleared.
struct FirstError {
  unsigned code = 0;  ///< bit of ERROR_STATUS
  std::uint32_t packet = 0;
  std::uint32_t beat = 0;
  std::uint64_t address = 0;  ///< of the first error of the DMA since then; 0: there was none
};

struct CoreErrors {
  std::uint32_t status = 0;  ///< a bit a code
  std::uint32_t count = 0;   ///< since it was last cleared
  std::optional<FirstError> first;
};

/// The programming sequence of docs/registers.md section 4, step by step, by that in C
/// (`hwffd/core_driver.h`):
///
///     Driver driver(port);
///     driver.probe();
///     driver.set_windows(read, write);
///     driver.lock_windows();
///     driver.set_ring(ring);
///     driver.set_results(area);  // from here on once a run
///     driver.check(header);      // of each packet
///     driver.push(packets);
///     driver.start();
///     if (!driver.wait_done(polls)) ...
///     const CoreErrors errors = driver.take_errors();
///
/// After an error that the DMA raised: soft_reset, then from set_ring on. All functions throw what
/// the port throws; those that say so throw DriverError.
class Driver {
 public:
  /// The port must outlive the driver.
  explicit Driver(RegisterPort& port) : port_(port) {}

  /// Step 1. Throws DriverError where ID is another, or VERSION.major is.
  CoreIdentity probe();
  /// check_packet with what probe found; throws DriverError where it was not called.
  void check(const PacketHeader& header) const;
  /// What the core keeps of lattices, for `pages_of`, `by_page` and `ResidentPages`. Throws
  /// DriverError before probe, and for a core that keeps none.
  PointStore store() const;
  /// Packets of a core with pages, for memory: a lattice into a page, some of its points, and
  /// vertices of it, as page_packet, points_packet and page_vertices_packet make them. They throw
  /// as check does, and for a cell that the beat of a vertex cannot say to this core.
  std::vector<Beat> page(int page, const LatticeWords& lattice,
                         const std::array<int, 3>& origin = {}) const;
  std::vector<Beat> points(int page, const LatticeWords& lattice, std::size_t first,
                           std::size_t count) const;
  std::vector<Beat> page_vertices(int page, const std::vector<VertexBeat>& vertices,
                                  const PageVertices& how = {}) const;

  /// Step 2. Throws DriverError where the windows are locked, or a base is above its limit.
  void set_windows(const AddressWindow& read, const AddressWindow& write);
  /// For good, until aresetn. Nothing starts before.
  void lock_windows();
  bool windows_locked();

  /// Step 3: an empty ring. Throws DriverError for one descriptor or more than 2^15, a base that is
  /// no multiple of the ring's size, or while another is in use (soft_reset ends that).
  void set_ring(const DescriptorRing& ring);

  /// Step 4. The next start takes it. Throws DriverError where base or bytes is no multiple of 16,
  /// or bytes is 0.
  void set_results(const ResultArea& area);

  /// The descriptor of a packet, four words as they stand in memory.
  /// @param interrupt  IRQ_STATE.descriptor is set when the packet has been read
  /// Throws DriverError where address or bytes is no multiple of 16, bytes is 0, or the core, which
  /// probe has found, has no such interrupt.
  std::array<std::uint32_t, 4> descriptor(std::uint64_t address, std::uint32_t bytes,
                                          bool interrupt = false) const;
  /// Step 5: that many more descriptors are in the ring; they must be in memory by now. Throws
  /// DriverError where it has no room for them.
  void push(unsigned descriptors);
  /// Place of the next descriptor: the index of its entry in the ring.
  unsigned next_entry();
  /// Descriptors in the ring that are not done.
  unsigned pending();

  /// Steps 4 and 6: clears what is left of the last start, interrupts too, then starts. Throws
  /// DriverError where the start is refused.
  void start();
  /// Step 7: reads STATUS until it is done, `polls` times at most. False: it is not.
  bool wait_done(std::uint64_t polls);
  /// Results in memory since the last start.
  std::uint32_t result_count();
  /// A bus error or a time-out of the bus stopped the DMA: only soft_reset helps.
  bool stopped();

  /// Step 8: the errors so far, which are cleared; ERROR_COUNT is not.
  CoreErrors take_errors();

  /// Ends the grid that the core is making, without a reset: the next vertex that it makes is the
  /// last, and ERROR_STATUS.grid_count tells of it. What the grid has made, and all packets behind
  /// it, have their results, and the run goes on. Where the core is at no grid nothing happens, nor
  /// to a grid whose header it has not read yet. See step 10.
  void stop_grid();

  /// Step 9; the ring is empty then, and has to be set again. False: still not idle after reading
  /// STATUS `polls` times. A bus that has stopped to answer ends it after the core's time-out; its
  /// slave is to be reset then, too, before the next start.
  bool soft_reset(std::uint64_t polls);

  /// Clocks and vertices, each once however many results it has, since they were last cleared. Each
  /// is one number, but not of one clock.
  CoreCounters counters();
  /// Why the core is slow. Throws DriverError where it does not count that, or before probe.
  CoreWaits waits();
  /// Sets the counters, the waits and ERROR_COUNT to 0.
  void clear_counters();

  /// @param bits  HWFFD_IRQ_ENABLE_*_MASK; what is not among them is disabled
  void enable_interrupts(std::uint32_t bits);
  /// What is set in IRQ_STATE, which is cleared.
  std::uint32_t take_interrupts();
  /// Raises interrupts by hand. @param bits  HWFFD_IRQ_TEST_*_MASK
  void test_interrupts(std::uint32_t bits);

 private:
  template <class Step, class... Arguments>
  hwffd_core_status status_of(const Step& step, Arguments... arguments);
  template <class Step, class... Arguments>
  void go(const Step& step, Arguments... arguments);
  std::uint64_t read64(std::uint32_t low);

  RegisterPort& port_;
  std::optional<CoreIdentity> core_;
  hwffd_core sequence_{};
};

}  // namespace hwffd
