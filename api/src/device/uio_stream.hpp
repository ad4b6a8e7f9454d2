#pragma once

#include <memory>
#include <string>

#include "device/core_access.hpp"
#include "device/stream_device.hpp"

namespace hwffd {

/// A core behind registers and DMA, and which row of the table it is.
struct UioCore {
  const Configuration* row;
  std::unique_ptr<CommandStream> stream;
};

/// Packets by the ring of descriptors, the end of a run by the interrupt (docs/registers.md section
/// 4). The core says its organization and format; among rows that are alike there, its bits decide.
/// @param name      what messages call it
/// @param wanted    the row that it should be; null: any
/// @param patience  for the interrupt
/// @throws Error for no core, another version or row, a buffer that is too small, windows that are
///   locked elsewhere, and a run that does not end
UioCore uio_core(const std::string& name, std::unique_ptr<CoreAccess> access,
                 const Configuration* wanted,
                 CoreAccess::Milliseconds patience = CoreAccess::Milliseconds(5000));

}  // namespace hwffd
