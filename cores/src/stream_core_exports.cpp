#include "stream_core_exports.hpp"

#include "hwffd/cores/scatter_core_factory.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/model/configuration.hpp"

const char* hwffd_rtl_version() { return HWFFD_PROJECT_VERSION; }

int hwffd_rtl_has(const char* row) {
  try {
    return hwffd::cores::has_stream_core(hwffd::find_configuration(row)) ? 1 : 0;
  } catch (...) {
    return 0;
  }
}

hwffd::cores::StreamCore* hwffd_rtl_make(const char* row, std::uint64_t seed) {
  try {
    return hwffd::cores::make_stream_core(hwffd::find_configuration(row), seed).release();
  } catch (...) {
    return nullptr;
  }
}

hwffd::cores::StreamCore* hwffd_rtl_make_scatter(int rows, std::uint64_t seed) {
  try {
    return hwffd::cores::make_scatter_core(rows != 0, seed).release();
  } catch (...) {
    return nullptr;
  }
}
