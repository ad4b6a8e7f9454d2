#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "hwffd/register_port.hpp"

namespace hwffd {

/// A `hwffd_axi` as a program reaches it: its registers, a buffer that its DMA reads and writes,
/// and its interrupt.
class CoreAccess : public RegisterPort {
 public:
  using Milliseconds = std::chrono::milliseconds;
  using Words = std::array<std::uint32_t, 4>;

  /// The address of the buffer as the DMA has it, and its size in bytes.
  virtual std::uint64_t address() const = 0;
  virtual std::uint64_t bytes() const = 0;
  /// What a user can do, as messages end: for a larger buffer, and for an interrupt that does not
  /// come.
  struct Cures {
    const char* size;
    const char* interrupt;
  };
  virtual Cures cures() const = 0;
  /// 16 bytes of the buffer, at a multiple of 16.
  virtual void put(std::uint64_t offset, const Words& words) = 0;
  virtual Words get(std::uint64_t offset) = 0;
  /// Before a start: the next interrupt counts, none of before.
  virtual void expect_interrupt() = 0;
  /// Whether it comes within that time.
  virtual bool wait_interrupt(Milliseconds patience) = 0;
};

/// Where Linux shows them; other folders are for tests.
struct UioFolders {
  std::string devices = "/dev";
  std::string uio = "/sys/class/uio";
  std::string buffers = "/sys/class/u-dma-buf";
};

/// The device uioN, and the buffer udmabufN of the driver u-dma-buf.
/// @param number  N, in digits
/// @throws Error where one of them is not there, or not as it should be
std::unique_ptr<CoreAccess> uio_access(const std::string& number, const UioFolders& folders = {});

/// What a program asks of the process that serves a core, over a socket of this machine: 32 bytes
/// as they lie in memory. The first that the process says is address() and bytes(), two words of 64
/// bits; it answers kRead with 32 bits, kGet with 16 bytes, kWait with 32 bits, not 0 where the
/// interrupt came, and nothing else.
struct CoreRequest {
  enum Kind : std::uint32_t { kRead, kWrite, kPut, kGet, kExpect, kWait };
  std::uint32_t kind;
  std::uint32_t offset;     ///< of a register
  std::uint64_t place;      ///< offset in the buffer; of kWait milliseconds
  CoreAccess::Words words;  ///< what is written; of a register the first
};
static_assert(sizeof(CoreRequest) == 32);

/// A core that another process serves, at the socket (AF_UNIX, a stream) of that path.
/// @throws Error where nobody listens, answers or is there any more
std::unique_ptr<CoreAccess> socket_access(const std::string& path);

}  // namespace hwffd
