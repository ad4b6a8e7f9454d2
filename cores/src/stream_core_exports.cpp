#include "stream_core_exports.hpp"

#include <exception>
#include <string>

#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/model/configuration.hpp"

namespace {

const hwffd::Configuration* find(const char* row) {
  for (const hwffd::Configuration& configuration : hwffd::configurations()) {
    if (configuration.name == std::string(row)) return &configuration;
  }
  return nullptr;
}

}  // namespace

const char* hwffd_rtl_version() { return HWFFD_PROJECT_VERSION; }

int hwffd_rtl_has(const char* row) {
  const hwffd::Configuration* configuration = find(row);
  return configuration != nullptr && hwffd::cores::has_stream_core(*configuration) ? 1 : 0;
}

hwffd::cores::StreamCore* hwffd_rtl_make(const char* row, std::uint64_t seed) {
  try {
    const hwffd::Configuration* configuration = find(row);
    if (configuration == nullptr) return nullptr;
    return hwffd::cores::make_stream_core(*configuration, seed).release();
  } catch (const std::exception&) {
    return nullptr;
  }
}
