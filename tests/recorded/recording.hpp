#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/model/configuration.hpp"
#include "hwffd/stream/beat.hpp"
#include "hwffd/stream/events.hpp"
#include "hwffd/stream/packets.hpp"
#include "hwffd/tb/evaluator_stimulus.hpp"

/// Command streams kept in files, and the hash of what each row of the table makes of them. They
/// say what the core has always answered, so they change only where an answer was wrong: a change
/// of a hash names its reason in CHANGELOG.md.
namespace hwffd::test {

/// Events that recorded streams know: those of the packets that every core has, and the last, which
/// cores of some organizations have, that functions do not sum to one.
constexpr int kRecordedEvents = event::kSaturated + 2;
using RecordedEvents = std::array<std::uint64_t, kRecordedEvents>;

/// Those of a core. Throws hwffd::Error if it has counted any other.
RecordedEvents recorded_events(const std::array<std::uint64_t, kStreamEvents>& events);

/// What comes of a recorded stream.
struct Recording {
  std::string row;
  std::size_t results = 0;
  std::uint64_t hash = 0;   ///< of the results in their order, see `hash_of`
  RecordedEvents events{};  ///< of the input, in that order; none at the read port
};

/// FNV-1a, 64 bits, over the little-endian words of each beat and one byte for its tlast.
std::uint64_t hash_of(const std::vector<Beat>& beats);

/// The recorded stream of a format: of commands, or of interleaved vertices for the read port. In
/// its file a beat is 17 bytes: words 0 to 3, each with its lowest byte first, then 1 for tlast,
/// else 0. Throws hwffd::Error with the file.
std::vector<Beat> read_recorded_stream(const std::string& kind, const std::string& format);
void write_recorded_stream(const std::string& kind, const std::string& format,
                           const std::vector<Beat>& beats);

/// The table of recordings of a kind.
std::string table_path(const std::string& kind);

/// Streams for simulators: a beat a line, `L_WWWWWWWW_WWWWWWWW_WWWWWWWW_WWWWWWWW` in hexadecimal:
/// tlast, then words 3 to 0, which Verilog's $readmemh reads as 129 bits. Throws hwffd::Error with
/// file and line.
std::vector<Beat> read_stream(const std::string& path);
void write_stream(const std::string& path, const std::vector<Beat>& beats);

/// A line a row: name, results, hash, events. Throws hwffd::Error with file and line.
std::vector<Recording> read_table(const std::string& path);
void write_table(const std::string& path, const std::vector<Recording>& recordings);

/// The rows of tier `test` whose format has a recorded stream.
std::vector<Configuration> recorded_rows();

/// What a read port takes: functions of both banks, and vertices.
struct ReadPortRecording {
  std::array<std::array<AxisWords, 3>, 2> banks;
  tb::EvaluatorStimulus stimulus;
};

/// A stream of two packets of coefficients and one of interleaved vertices, as a read port takes
/// them: each vertex at its position, then differentiated along s, t and u; banks take turns.
/// Throws hwffd::Error for another stream.
ReadPortRecording read_port_recording(const std::vector<Beat>& beats);

}  // namespace hwffd::test
