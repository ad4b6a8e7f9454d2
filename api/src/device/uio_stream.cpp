#include "device/uio_stream.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "device/packets_of.hpp"
#include "device/row_question.hpp"
#include "hwffd/driver.hpp"
#include "hwffd/error.hpp"
#include "hwffd/model/organizations.hpp"
#include "hwffd/registers.h"

namespace hwffd {
namespace {

using Milliseconds = CoreAccess::Milliseconds;

constexpr unsigned kRingLog2 = 8;
constexpr std::uint64_t kRingBytes = kBeatBytes << kRingLog2;
constexpr std::size_t kMostPackets = (std::size_t{1} << kRingLog2) - 1;
constexpr std::uint64_t kFewestBytes = std::uint64_t{1} << 20;  // a packet of any kind, and results
constexpr std::uint64_t kPolls = 100'000;
// What stops the DMA, or loses results; the other errors are those of vertices, which results say.
constexpr std::uint32_t kFaults =
    HWFFD_ERROR_STATUS_DMA_ZERO_MASK | HWFFD_ERROR_STATUS_DMA_MISALIGNED_MASK |
    HWFFD_ERROR_STATUS_DMA_WRAP_MASK | HWFFD_ERROR_STATUS_DMA_WINDOW_MASK |
    HWFFD_ERROR_STATUS_DMA_DESCRIPTOR_MASK | HWFFD_ERROR_STATUS_DMA_READ_RESPONSE_MASK |
    HWFFD_ERROR_STATUS_DMA_WRITE_RESPONSE_MASK | HWFFD_ERROR_STATUS_RESULT_OVERFLOW_MASK |
    HWFFD_ERROR_STATUS_DMA_RING_MASK | HWFFD_ERROR_STATUS_TIMEOUT_AR_MASK |
    HWFFD_ERROR_STATUS_TIMEOUT_R_MASK | HWFFD_ERROR_STATUS_TIMEOUT_AW_MASK |
    HWFFD_ERROR_STATUS_TIMEOUT_W_MASK | HWFFD_ERROR_STATUS_TIMEOUT_B_MASK;

/// The format of a row as the register CONFIG has it.
unsigned format_number(const std::string& format) {
  if (format == "fp32") return 0;
  if (format == "bfp32") return 99;
  return static_cast<unsigned>(std::stoul(format.substr(2)));
}

unsigned evaluator_number(const std::string& evaluator) {
  return evaluator == "iterative" ? 1 : evaluator == "powers" ? 3 : 0;
}

/// Whether CONFIG of a core may be that of a row.
bool is_like(const CoreIdentity& core, const Configuration& row) {
  return overlaps(row) == (core.schedule == 0) && core.n == static_cast<unsigned>(row.n) &&
         core.org == static_cast<unsigned>(organization_of(row).number) &&
         core.format == format_number(row.format) &&
         core.evaluator == evaluator_number(row.evaluator);
}

class UioStream final : public CommandStream {
 public:
  UioStream(const std::string& name, std::unique_ptr<CoreAccess> access, Milliseconds patience)
      : name_(name), access_(std::move(access)), driver_(*access_), patience_(patience) {
    named([&] { set_up(); });
  }

  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t /*results*/,
                        const Progress& progress, std::size_t /*steps*/) override {
    std::vector<Beat> out;
    const std::vector<Packet> packets = packets_of(commands);
    for (std::size_t first = 0; first < packets.size();) {
      const std::size_t end = end_of_batch(packets, first);
      named([&] { run(packets, first, end, out); });
      first = end;
      progress(static_cast<double>(end) / static_cast<double>(packets.size()));
    }
    return out;
  }

  void reset() override {
    named([&] { open_ring(); });
  }
  PointStore store() const override { return driver_.store(); }
  const CoreIdentity& identity() const { return identity_; }

 private:
  /// What the driver throws, with the name of the device before it.
  template <class Body>
  void named(const Body& body) const {
    try {
      body();
    } catch (const DriverError& error) {
      throw Error(fmt::format("{}: {}", name_, error.what()));
    }
  }

  void set_up() {
    identity_ = driver_.probe();
    if (access_->bytes() < kFewestBytes) {
      throw Error(fmt::format("{}: its buffer has {} bytes, and {} are needed; {}", name_,
                              access_->bytes(), kFewestBytes, access_->cures().size));
    }
    if (access_->address() % kRingBytes != 0) {
      throw Error(fmt::format("{}: its buffer is at {:#x}, which is no multiple of {}", name_,
                              access_->address(), kRingBytes));
    }
    const AddressWindow whole{access_->address(), access_->address() + access_->bytes() - 1};
    if (!driver_.windows_locked()) {
      driver_.set_windows(whole, whole);
      driver_.lock_windows();
    } else if (!has_inside(HWFFD_READ_WINDOW_BASE_LO_OFFSET, whole) ||
               !has_inside(HWFFD_WRITE_WINDOW_BASE_LO_OFFSET, whole)) {
      throw Error(
          fmt::format("{}: its windows are locked, and not around the buffer at {:#x}; "
                      "reset the core",
                      name_, whole.base));
    }
    driver_.enable_interrupts(HWFFD_IRQ_ENABLE_DONE_MASK);
    open_ring();
  }

  /// Whether a window, whose registers begin there, has all of another.
  bool has_inside(std::uint32_t base, const AddressWindow& inner) {
    const auto read64 = [&](std::uint32_t low) {
      return std::uint64_t{access_->read32(low + 4)} << 32 | access_->read32(low);
    };
    return read64(base) <= inner.base && read64(base + 8) >= inner.limit;
  }

  void open_ring() {
    if (!driver_.soft_reset(kPolls)) {
      throw Error(fmt::format("{}: does not come out of a soft reset; reset the core", name_));
    }
    driver_.take_errors();  // a reset keeps those of before, which are not the next run's
    driver_.set_ring({access_->address(), kRingLog2});
  }

  /// Packets from `first` on that ring and buffer have room for.
  std::size_t end_of_batch(const std::vector<Packet>& packets, std::size_t first) const {
    std::uint64_t rest = access_->bytes() - kRingBytes;
    std::size_t end = first;
    while (end < packets.size() && end - first < kMostPackets) {
      const Packet& packet = packets[end];
      const std::uint64_t bytes = kBeatBytes * (packet.count + packet.results);
      if (bytes + kBeatBytes > rest) break;  // the area of results is never empty
      rest -= bytes;
      ++end;
    }
    if (end > first) return end;
    throw Error(
        fmt::format("{}: its buffer of {} bytes has no room for a packet of {} beats and {} "
                    "results; {}",
                    name_, access_->bytes(), packets[first].count, packets[first].results,
                    access_->cures().size));
  }

  /// Those packets, in one run; their results go to the end of `out`.
  void run(const std::vector<Packet>& packets, std::size_t first, std::size_t end,
           std::vector<Beat>& out) {
    std::uint64_t offset = kRingBytes;
    std::uint64_t results = 0;
    for (std::size_t p = first; p < end; ++p) {
      const Packet& packet = packets[p];
      driver_.check(packet.beats->words);
      const std::uint64_t entry = kBeatBytes * driver_.next_entry();
      access_->put(entry,
                   driver_.descriptor(access_->address() + offset,
                                      static_cast<std::uint32_t>(kBeatBytes * packet.count)));
      for (std::size_t b = 0; b < packet.count; ++b, offset += kBeatBytes) {
        access_->put(offset, packet.beats[b].words);
      }
      results += packet.results;
      driver_.push(1);
    }
    const auto area = static_cast<std::uint32_t>(kBeatBytes * std::max<std::uint64_t>(results, 1));
    driver_.set_results({access_->address() + offset, area});
    driver_.take_interrupts();  // a line that is high would be one already
    access_->expect_interrupt();
    driver_.start();
    wait(results);
    read(packets, first, end, offset, out);
  }

  void wait(std::uint64_t results) {
    const auto end = std::chrono::steady_clock::now() + patience_;
    bool came = false;
    bool done = false;
    do {
      const auto rest = std::chrono::ceil<Milliseconds>(end - std::chrono::steady_clock::now());
      came = access_->wait_interrupt(std::max(rest, Milliseconds(0)));
      done = driver_.wait_done(1);
    } while (came && !done);  // it was one of before
    const double seconds = std::chrono::duration<double>(patience_).count();
    if (!came && done) {
      throw Error(fmt::format("{}: a run has ended, but no interrupt came for {} s; {}", name_,
                              seconds, access_->cures().interrupt));
    }
    if (!done) {
      throw Error(fmt::format("{}: a run has not ended after {} s, {} of {} results came", name_,
                              seconds, driver_.result_count(), results));
    }
    const CoreErrors errors = driver_.take_errors();
    if ((errors.status & kFaults) != 0 || driver_.result_count() != results) {
      throw Error(
          fmt::format("{}: {} of {} results came, ERROR_STATUS {:#x}{}", name_,
                      driver_.result_count(), results, errors.status,
                      errors.first ? fmt::format(" at address {:#x}", errors.first->address) : ""));
    }
  }

  void read(const std::vector<Packet>& packets, std::size_t first, std::size_t end,
            std::uint64_t offset, std::vector<Beat>& out) {
    for (std::size_t p = first; p < end; ++p) {
      for (std::size_t r = 0; r < packets[p].results; ++r, offset += kBeatBytes) {
        Beat beat;
        beat.words = access_->get(offset);
        beat.last = r + 1 == packets[p].results;
        out.push_back(beat);
      }
    }
  }

  std::string name_;
  std::unique_ptr<CoreAccess> access_;
  Driver driver_;
  Milliseconds patience_;
  CoreIdentity identity_{};
};

}  // namespace

UioCore uio_core(const std::string& name, std::unique_ptr<CoreAccess> access,
                 const Configuration* wanted, Milliseconds patience) {
  auto stream = std::make_unique<UioStream>(name, std::move(access), patience);
  bool alike = false;
  for (const Configuration& row : configurations()) {
    if (!is_like(stream->identity(), row)) continue;
    alike = true;
    if (wanted != nullptr && wanted->name != std::string(row.name)) continue;
    if (answers_as(*stream, row)) return {&row, std::move(stream)};
  }
  if (wanted != nullptr) throw Error(fmt::format("{}: is not {}", name, wanted->name));
  throw Error(fmt::format("{}: {}", name,
                          alike ? "its results are not those of its row"
                                : "its organization and format are no row of the table"));
}

}  // namespace hwffd
