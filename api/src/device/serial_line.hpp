#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hwffd {

/// A serial line without flow control: 8 data bits, no parity, 1 stop bit. It is this program's
/// alone while the object lives.
class SerialLine {
 public:
  using Milliseconds = std::chrono::milliseconds;

  /// @param name  what messages call it
  /// @throws Error for a path that is no such line, or that another program uses
  SerialLine(const std::string& name, const std::string& path);
  ~SerialLine();
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;

  /// Sends all of it.
  /// @throws Error where the line is closed, or takes no byte for so long
  void write(const std::vector<std::uint8_t>& bytes, Milliseconds patience);
  /// What comes next, `most` bytes at most; none if nothing comes for so long.
  /// @throws Error where the line is closed
  std::vector<std::uint8_t> read(std::size_t most, Milliseconds patience);

 private:
  /// Whether an event comes for which poll() waits, or the end of the line.
  bool wait(short events, Milliseconds patience) const;
  [[noreturn]] void closed() const;

  std::string name_;
  int file_;
};

}  // namespace hwffd
