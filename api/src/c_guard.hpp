#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <new>
#include <string>

#include "hwffd/device/deformable_lattice.hpp"
#include "hwffd/error.hpp"
#include "hwffd/hwffd.h"

struct hwffd_lattice : hwffd::DeformableLattice {
  using hwffd::DeformableLattice::DeformableLattice;
  explicit hwffd_lattice(hwffd::DeformableLattice lattice)
      : hwffd::DeformableLattice(std::move(lattice)) {}
};

namespace hwffd::c {

/// Keeps what hwffd_error() says in this thread; where memory is short too short for that, nothing.
void keep_error(const char* text) noexcept;

/// Runs a body; an exception becomes a status and hwffd_error().
template <typename Body>
int guarded(Body body) {
  try {
    body();
    return HWFFD_OK;
  } catch (const Error& error) {
    keep_error(error.what());
    return error.exit_status();
  } catch (const std::bad_alloc&) {
    keep_error("there is not enough memory; give fewer points");
    return HWFFD_ERROR;
  } catch (const std::exception& error) {
    keep_error(error.what());
    return HWFFD_ERROR;
  }
}

/// A new Handle of what make() gives, or null and hwffd_error().
template <typename Handle, typename Make>
Handle* new_handle(Make make) {
  std::unique_ptr<Handle> handle;
  guarded([&] { handle.reset(new Handle{make()}); });
  return handle.release();
}

/// @throws UsageError for a null pointer to anything
template <typename T>
void need(const T* pointer, const char* name, std::size_t count = 1) {
  if (pointer == nullptr && count > 0) throw UsageError(std::string(name) + " is NULL; give it");
}

}  // namespace hwffd::c
