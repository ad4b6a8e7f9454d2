#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "device/core_access.hpp"
#include "device/patient_poll.hpp"
#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"

namespace hwffd {
namespace {

constexpr std::uint64_t kRegisterBytes = 4096;  // 12 bits of address
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 32;

/// A file of one number, decimal or with 0x.
/// @param wanted  what the folder belongs to, and how it comes to be there
std::uint64_t number_in(const std::string& path, const std::string& wanted) {
  std::ifstream file(path);
  std::string text;
  if (!(file >> text)) throw Error(fmt::format("{}: cannot be read; {}", path, wanted));
  std::size_t length = 0;
  std::uint64_t value = 0;
  try {
    value = std::stoull(text, &length, 0);
  } catch (const std::exception&) {
    length = 0;
  }
  if (length != text.size()) throw Error(fmt::format("{}: '{}' is no number", path, excerpt(text)));
  return value;
}

/// A file in memory.
class Mapping {
 public:
  Mapping(const std::string& path, std::uint64_t bytes, int flags) : bytes_(bytes) {
    file_ = open(path.c_str(), O_RDWR | O_CLOEXEC | flags);
    if (file_ < 0) throw Error(fmt::format("{}: cannot be opened: {}", path, std::strerror(errno)));
    memory_ = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
    if (memory_ != MAP_FAILED) return;
    const std::string why = std::strerror(errno);
    close(file_);
    throw Error(fmt::format("{}: its {} bytes cannot be mapped: {}", path, bytes, why));
  }
  ~Mapping() {
    munmap(memory_, bytes_);
    close(file_);
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  int file() const { return file_; }
  std::uint64_t bytes() const { return bytes_; }
  volatile std::uint32_t& word(std::uint64_t offset) const {
    return static_cast<volatile std::uint32_t*>(memory_)[offset / 4];
  }

 private:
  int file_ = -1;
  void* memory_ = nullptr;
  std::uint64_t bytes_;
};

std::uint64_t register_bytes(const std::string& folder) {
  const std::string path = folder + "/maps/map0/size";
  const std::uint64_t bytes =
      number_in(path, "is the core in the device tree, and uio_pdrv_genirq loaded?");
  if (bytes < kRegisterBytes || bytes > kMostBytes) {
    throw Error(fmt::format("{}: {} bytes; the registers take {}", path, bytes, kRegisterBytes));
  }
  return bytes;
}

class UioAccess final : public CoreAccess {
 public:
  UioAccess(const std::string& number, const UioFolders& folders)
      : name_("uio:" + number),
        registers_(folders.devices + "/uio" + number, register_bytes(folders.uio + "/uio" + number),
                   O_SYNC),
        buffer_folder_(folders.buffers + "/udmabuf" + number),
        address_(of_buffer("phys_addr")),
        buffer_(folders.devices + "/udmabuf" + number, buffer_bytes(), O_SYNC) {}

  std::uint32_t read32(std::uint32_t offset) override {
    const std::uint32_t value = registers_.word(offset);
    std::atomic_thread_fence(std::memory_order_seq_cst);  // what is read of the buffer comes after
    return value;
  }
  void write32(std::uint32_t offset, std::uint32_t value) override {
    std::atomic_thread_fence(std::memory_order_seq_cst);  // what is in the buffer comes before
    registers_.word(offset) = value;
  }
  std::uint64_t address() const override { return address_; }
  std::uint64_t bytes() const override { return buffer_.bytes(); }
  Cures cures() const override { return {"give u-dma-buf more", "see to it in the device tree"}; }
  void put(std::uint64_t offset, const Words& words) override {
    for (std::size_t w = 0; w < words.size(); ++w) buffer_.word(offset + 4 * w) = words[w];
  }
  Words get(std::uint64_t offset) override {
    Words words{};
    for (std::size_t w = 0; w < words.size(); ++w) words[w] = buffer_.word(offset + 4 * w);
    return words;
  }

  void expect_interrupt() override {
    while (wait_interrupt(Milliseconds(0))) continue;
    const std::int32_t enable = 1;
    if (write(registers_.file(), &enable, sizeof(enable)) == sizeof(enable)) return;
    throw Error(
        fmt::format("{}: takes no interrupts: {}; does its node in the device tree name one?",
                    name_, std::strerror(errno)));
  }
  bool wait_interrupt(Milliseconds patience) override {
    if (patient_poll(registers_.file(), POLLIN, patience) <= 0) return false;
    std::int32_t count = 0;
    return read(registers_.file(), &count, sizeof(count)) == sizeof(count);
  }

 private:
  std::uint64_t of_buffer(const std::string& file) const {
    return number_in(buffer_folder_ + "/" + file,
                     "is the buffer in the device tree, and u-dma-buf loaded?");
  }
  std::uint64_t buffer_bytes() const {
    const std::uint64_t bytes = of_buffer("size");
    if (bytes > 0 && bytes <= kMostBytes) return bytes;
    throw Error(fmt::format("{}/size: {} bytes; a buffer has 1 to 2^32", buffer_folder_, bytes));
  }

  std::string name_;
  Mapping registers_;
  std::string buffer_folder_;
  std::uint64_t address_;
  Mapping buffer_;
};

}  // namespace

std::unique_ptr<CoreAccess> uio_access(const std::string& number, const UioFolders& folders) {
  return std::make_unique<UioAccess>(number, folders);
}

}  // namespace hwffd
