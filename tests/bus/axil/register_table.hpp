#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace hwffd::test {

/// One row of rtl/bus/registers.csv.
struct RegisterField {
  std::uint32_t offset = 0;
  std::string reg;
  std::string name;
  unsigned low = 0;
  unsigned width = 0;
  std::string access;
  std::uint32_t reset = 0;
  /// Links by their kind.
  std::map<std::string, std::vector<std::string>> links;
  std::string path;  ///< REGISTER.field
  /// The port's name without its ending, as docs/registers.md section 3 says, and the field's
  /// lowest bit in it.
  std::string port;
  unsigned port_low = 0;

  std::uint32_t mask() const {
    return static_cast<std::uint32_t>(((std::uint64_t{1} << width) - 1) << low);
  }
  /// Set by the hardware, cleared by a 1.
  bool sticky() const { return access == "w1c" || access == "event"; }
  bool writable() const { return sticky() || access == "rw" || access == "w1" || access == "w1s"; }
  /// Targets of `kind:target` in the link.
  const std::vector<std::string>& linked(const std::string& kind) const;
};

/// Reads the table. Shares no code with the script that makes the RTL. Throws std::runtime_error.
std::vector<RegisterField> read_register_table(const std::string& path);

/// The table of this tree, read once.
const std::vector<RegisterField>& register_table();
/// The field of that path. Throws std::out_of_range.
const RegisterField& register_field(const std::string& path);
/// The offset of the register of that name. Throws std::out_of_range.
std::uint32_t register_offset(const std::string& reg);

}  // namespace hwffd::test
