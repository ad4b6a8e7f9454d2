#include "device_name.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "hwffd/error.hpp"

namespace hwffd::gl {

DeviceChoice parse_device(const std::string& name) {
  DeviceChoice choice;
  std::string* const fields[] = {&choice.device, &choice.org, &choice.format};
  std::size_t begin = 0;
  for (std::string* field : fields) {
    const std::size_t end = name.find(':', begin);
    *field = name.substr(begin, end - begin);
    if (field->empty()) break;
    if (end == std::string::npos) return choice;
    begin = end + 1;
  }
  throw UsageError(fmt::format("device '{}': write it as rtl or as rtl:parallel:fx18", name));
}

DeviceChoice device_of_environment() {
  const char* name = std::getenv("HWFFD_DEVICE");
  if (name == nullptr || *name == '\0') return parse_device("model");
  try {
    return parse_device(name);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("HWFFD_DEVICE: {}", error.what()));
  }
}

}  // namespace hwffd::gl
