#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bad_packets.hpp"
#include "hwffd/cores/axi_core_factory.hpp"
#include "hwffd/driver.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/registers.h"
#include "hwffd/stream/word_codec.hpp"
#include "hwffd/tb/axi_system.hpp"
#include "hwffd/tb/packet_ring.hpp"
#include "named.hpp"
#include "page_stimulus.hpp"

namespace hwffd::test {

/// Where things lie in the memory of these tests. Windows fit them to the byte; the results are
/// above 4 GB, no buffer begins at a border of 4 KB.
inline constexpr std::uint64_t kBeat = cores::kAxiBeatBytes;
inline constexpr DescriptorRing kRing{0x100200, 5};
inline constexpr AddressWindow kBuffers{0x200F70, 0x3FFFFF};
inline constexpr AddressWindow kReadWindow{kRing.base, kBuffers.limit};
inline constexpr AddressWindow kWriteWindow{0x100001230, 0x1001FFFFF};
inline constexpr std::uint64_t kPolls = 200'000;

/// The same, or farther up.
struct Places {
  DescriptorRing ring = kRing;
  AddressWindow buffers = kBuffers, read = kReadWindow, write = kWriteWindow;

  /// Results in one half of 64 bits, the others in the other one.
  static Places anywhere(tb::Random& random) {
    constexpr std::uint64_t kRingBytes = 512, kHalf = std::uint64_t{1} << 63;
    const auto by = [](std::uint64_t bytes, const AddressWindow& window) {
      return AddressWindow{window.base + bytes, window.limit + bytes};
    };
    const std::uint64_t upper = random.chance(0.5) ? kHalf : 0;
    const std::uint64_t read = upper + random.bits() / 4 * 2 / kRingBytes * kRingBytes;
    const std::uint64_t write =
        kHalf - upper + random.bits() / 4 * 2 / cores::kAxiBeatBytes * cores::kAxiBeatBytes;
    AddressWindow readable = by(read, kReadWindow);
    readable.base -= random.below(kRingBytes);  // in all its bits
    return {{kRing.base + read, kRing.log2_size},
            by(read, kBuffers),
            readable,
            by(write, kWriteWindow)};
  }
};

/// Bytes of a word are written as strobes say, and every bit of its address counts.
void expect_words_and_bytes(tb::AxiSystem& system);

/// A whole system of one configuration, the driver that works it and the model of what it does.
class AxiRun {
 public:
  /// Out of reset, windows set and locked, the ring open, all interrupts enabled.
  AxiRun(const Configuration& row, std::uint64_t seed, const std::string& throttles = "always");
  /// The same with a core of that row that is there already, and has what is said.
  AxiRun(const Configuration& row, std::unique_ptr<cores::AxiCore> core, std::uint64_t seed,
         const std::string& throttles = "always", const PageCore& has = {model::kAllFeatures});

  /// Puts packets into memory and ring, and what the model makes of them to the expectations.
  void send(const std::vector<Beat>& packets);
  /// The latter alone, for packets that lie in memory otherwise.
  void expect(const std::vector<Beat>& packets);
  void send_bspline();
  /// A random lattice of 4 to `size` points an axis, or of these, which later vertices lie in.
  template <class Size>
  void send_lattice(const Size& size) {
    send(random_lattice(codec_, random_, size));
  }
  void send(const LatticeWords& lattice) {
    lattice_ = lattice;
    send(lattice_packet(lattice));
  }
  /// Random vertices of the last lattice.
  void send_vertices(std::size_t count) { send(vertices_packet(vertices(count))); }
  std::vector<VertexBeat> vertices(std::size_t count) {
    return random_vertices(codec_, random_, lattice_.dims, count);
  }
  /// All three: what a run needs.
  void send_scene(std::size_t vertices, int size = 4) {
    send_bspline();
    send_lattice(size);
    send_vertices(vertices);
  }
  /// An area of that many results, or as many as are expected, behind the last one; then a start.
  void start(std::optional<std::uint64_t> results = {});
  /// The same, but the start is only on its way to the registers when `behind` is called.
  void start(std::optional<std::uint64_t> results, const std::function<void()>& behind);
  /// A start with an area like that, past the checks of the driver.
  void start_in(std::uint64_t base, std::uint32_t bytes);
  /// A start; then so many clocks in which the memory takes no data, and goes on to take none.
  void start_with_memory_shut(std::uint64_t clocks);
  /// Waits for the end; compares the count and every word in memory. What lies behind them is guard
  /// bytes for `clean`, even in the area.
  ::testing::AssertionResult finish();
  /// start and finish.
  ::testing::AssertionResult go();
  /// Waits for the end only.
  ::testing::AssertionResult wait();
  /// Soft reset of core and model; the ring is open again.
  ::testing::AssertionResult soft_reset();
  /// aresetn of everything for that many clocks; then as constructed.
  void hard_reset(unsigned clocks);
  /// The same, with other places from then on.
  void move_to(const Places& places);
  /// Coefficients, a lattice and a few vertices: exact, no error but what the model has.
  ::testing::AssertionResult good_run();
  /// Beats that were sent and are not expected to be seen any more, and their results.
  void forget_expected();
  /// No rule of a bus broken, nothing open, no byte changed but those of results, ring and buffers.
  ::testing::AssertionResult clean();
  /// good_run and clean.
  ::testing::AssertionResult ends_well();
  /// Takes the errors: so many of one code and of no other, of which this is the first.
  ::testing::AssertionResult only_error(const FirstError& first, std::uint32_t count = 1);

  const WordCodec& codec() const { return codec_; }
  const LatticeWords& lattice() const { return lattice_; }
  tb::AxiSystem& system() { return *system_; }
  Driver& driver() { return driver_; }
  tb::PacketRing& ring() { return *ring_; }
  tb::Random& random() { return random_; }
  model::StreamModel& model() { return model_; }
  const std::vector<Beat>& expected() const { return expected_; }
  std::uint64_t area() const { return area_; }
  /// How many of the expected results lie in memory, counted up to the first that does not.
  std::uint64_t results_in_memory() const;
  /// A word of result `index` of the last area.
  std::uint32_t result_word(std::uint64_t index, unsigned word) const;
  /// Results compared so far.
  std::uint64_t checked() const { return checked_; }

 private:
  void set_up();
  void choose_area(std::optional<std::uint64_t> results);

  Configuration row_;
  WordCodec codec_;
  tb::Random random_;
  std::unique_ptr<cores::AxiCore> core_;
  std::unique_ptr<tb::AxiSystem> system_;
  Driver driver_;
  Places places_;
  std::optional<tb::PacketRing> ring_;
  model::StreamModel model_;
  LatticeWords lattice_;
  std::vector<Beat> expected_;
  std::uint64_t next_area_ = 0;
  std::uint64_t area_ = 0;
  std::uint64_t area_results_ = 0;
  std::vector<tb::AxiMemory::Range> written_;  ///< rings and buffers
  std::vector<tb::AxiMemory::Range> areas_;
  std::uint64_t checked_ = 0;
};

/// The rows of the table whose hwffd_axi this build has.
std::vector<Configuration> axi_configurations();

/// For tests over configurations.
class PerAxiConfiguration : public ::testing::TestWithParam<Configuration> {};

}  // namespace hwffd::test

#define HWFFD_FOR_EACH_AXI_CONFIGURATION(suite)                                               \
  INSTANTIATE_TEST_SUITE_P(, suite, ::testing::ValuesIn(::hwffd::test::axi_configurations()), \
                           ::hwffd::test::by_name)
