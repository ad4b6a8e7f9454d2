// The factory of cores for the shared library: the Verilated ones are in a library of their own,
// which is loaded when a core is first asked for.

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "hwffd/cores/scatter_core_factory.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "stream_core_exports.hpp"

namespace hwffd::cores {
namespace {

/// Beside this library, or where the system looks.
void* open_library() {
  Dl_info own{};
  if (dladdr(reinterpret_cast<void*>(&has_stream_core), &own) != 0) {
    const auto library_path =
        std::filesystem::path(own.dli_fname).parent_path() / HWFFD_RTL_LIBRARY;
    void* library = dlopen(library_path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library != nullptr) return library;
  }
  return dlopen(HWFFD_RTL_LIBRARY, RTLD_NOW | RTLD_LOCAL);
}

/// Its functions; null pointers where it is not there, or of another version.
struct Library {
  Library() {
    void* library = open_library();
    if (library == nullptr) return;
    const auto version = reinterpret_cast<const char* (*)()>(dlsym(library, "hwffd_rtl_version"));
    if (version == nullptr || std::strcmp(version(), HWFFD_PROJECT_VERSION) != 0) return;
    has = reinterpret_cast<decltype(has)>(dlsym(library, "hwffd_rtl_has"));
    make = reinterpret_cast<decltype(make)>(dlsym(library, "hwffd_rtl_make"));
    make_scatter =
        reinterpret_cast<decltype(make_scatter)>(dlsym(library, "hwffd_rtl_make_scatter"));
  }
  decltype(&hwffd_rtl_has) has = nullptr;
  decltype(&hwffd_rtl_make) make = nullptr;
  decltype(&hwffd_rtl_make_scatter) make_scatter = nullptr;
};

const Library& library() {
  static const Library loaded;
  return loaded;
}

}  // namespace

bool has_stream_core(const Configuration& configuration) {
  return library().has != nullptr && library().has(configuration.name) != 0;
}

bool stream_cores_can_trace() { return false; }

std::unique_ptr<StreamCore> make_stream_core(const Configuration& configuration, std::uint64_t seed,
                                             const std::string& trace) {
  if (!trace.empty() || !has_stream_core(configuration)) {
    throw std::invalid_argument(fmt::format("no core of row {}", configuration.name));
  }
  return std::unique_ptr<StreamCore>(library().make(configuration.name, seed));
}

bool has_scatter_core() { return library().make_scatter != nullptr; }

std::unique_ptr<StreamCore> make_scatter_core(bool rows, std::uint64_t seed) {
  if (!has_scatter_core()) throw std::invalid_argument("no core that adds gradients up");
  return std::unique_ptr<StreamCore>(library().make_scatter(rows ? 1 : 0, seed));
}

}  // namespace hwffd::cores
