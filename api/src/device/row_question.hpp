#pragma once

#include "device/stream_device.hpp"

namespace hwffd {

/// Whether hardware answers as a row of the table does: positions and derivatives of a small scene,
/// bit for bit as the model has them. Where the positions differ it is not asked for derivatives,
/// which some cores do not have.
/// @throws Error as the stream does
bool answers_as(CommandStream& stream, const Configuration& row);

}  // namespace hwffd
