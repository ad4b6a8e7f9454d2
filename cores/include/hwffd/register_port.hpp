#pragma once

#include <cstdint>

namespace hwffd {

/// The way to the registers: memory that is mapped, or a simulated bus.
class RegisterPort {
 public:
  virtual ~RegisterPort() = default;

  /// @param offset  of the register, in bytes (registers.h)
  /// Both throw RegisterError, or what the system makes of an error response.
  virtual std::uint32_t read32(std::uint32_t offset) = 0;
  virtual void write32(std::uint32_t offset, std::uint32_t value) = 0;
};

}  // namespace hwffd
