#pragma once

#include <memory>
#include <string>

#include "device/serial_line.hpp"
#include "device/stream_device.hpp"

namespace hwffd {

/// The row of the board whose core speaks all of interface.md up to opcode 4, the ULX3S
/// (synth/boards/boards.csv).
constexpr const char* kSerialRow = "cg1-fx18-overlapped";

/// A board behind a serial line, whose frames are those of synth/boards/README.md. Its core is
/// asked for the results of a scene in every format; which row it is follows from their bits.
/// @param path      of the line
/// @param row       that it should be
/// @param patience  for the next byte
/// @throws Error where nothing answers, or what answers is not that row
std::unique_ptr<CommandStream> serial_stream(
    const std::string& path, const Configuration& row,
    SerialLine::Milliseconds patience = SerialLine::Milliseconds(5000));

}  // namespace hwffd
