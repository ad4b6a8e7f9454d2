// A library that says that it has all Verilated cores, but is not of this version.
#include "stream_core_exports.hpp"

const char* hwffd_rtl_version() { return "0.0.0"; }
int hwffd_rtl_has(const char*) { return 1; }
hwffd::cores::StreamCore* hwffd_rtl_make(const char*, std::uint64_t) { return nullptr; }
hwffd::cores::StreamCore* hwffd_rtl_make_scatter(std::uint64_t) { return nullptr; }
