#include "device/serial_stream.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "device/packets_of.hpp"
#include "device/row_question.hpp"
#include "hwffd/error.hpp"

namespace hwffd {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Milliseconds = SerialLine::Milliseconds;

constexpr std::size_t kMostResults = 64;         // of a frame: the line has no flow control
constexpr std::uint32_t kEndsPacket = 1U << 31;  // of a result's word 3, on the line
constexpr Milliseconds kPause{200};              // longer than the longest of the boards
constexpr std::size_t kMostLeftOver = 1U << 16;  // bytes that a run before may have left

/// A packet, split where it asks for more results than a frame may.
struct Frame {
  std::vector<Beat> beats;
  std::size_t results = 0;
  bool ends = true;  ///< the packet that it is of
};

void add_frames(std::vector<Frame>& frames, const Packet& packet) {
  const VertexShare share = vertex_share(*packet.beats);
  if (share.beats == 0) {
    frames.push_back({{packet.beats, packet.beats + packet.count}});
    return;
  }
  const std::size_t most = kMostResults / share.results;
  const Beat* next = packet.beats + 1;
  for (std::size_t rest = packet.results / share.results; rest > 0;) {
    const std::size_t count = std::min(rest, most);
    Frame frame{{*packet.beats}, count * share.results, count == rest};
    frame.beats.front().words[1] = static_cast<std::uint32_t>(count);
    frame.beats.insert(frame.beats.end(), next, next + count * share.beats);
    frames.push_back(std::move(frame));
    next += count * share.beats;
    rest -= count;
  }
}

std::vector<Frame> frames_of(const std::vector<Beat>& commands) {
  std::vector<Frame> frames;
  for (const Packet& packet : packets_of(commands)) add_frames(frames, packet);
  return frames;
}

Bytes bytes_of(const std::vector<Beat>& beats) {
  Bytes bytes{static_cast<std::uint8_t>(beats.size()),
              static_cast<std::uint8_t>(beats.size() >> 8)};
  for (const Beat& beat : beats) {
    for (const std::uint32_t word : beat.words) {
      for (int shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<std::uint8_t>(word >> shift));
      }
    }
  }
  return bytes;
}

std::vector<Beat> beats_of(const Bytes& bytes) {
  std::vector<Beat> beats(bytes.size() / kBeatBytes);
  for (std::size_t at = 0; at < beats.size() * kBeatBytes; ++at) {
    beats[at / kBeatBytes].words[at % kBeatBytes / 4] |= static_cast<std::uint32_t>(bytes[at])
                                                         << (8 * (at % 4));
  }
  for (Beat& beat : beats) {
    beat.last = (beat.words[3] & kEndsPacket) != 0;
    beat.words[3] &= ~kEndsPacket;
  }
  return beats;
}

class SerialStream final : public CommandStream {
 public:
  SerialStream(const std::string& path, const Configuration& row, Milliseconds patience)
      : name_("serial:" + path), line_(name_, path), patience_(patience) {
    reset();
    identify(row);
  }

  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                        const Progress& progress, std::size_t /*steps*/) override {
    std::vector<Beat> out;
    out.reserve(results);
    const std::vector<Frame> frames = frames_of(commands);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      line_.write(bytes_of(frames[f].beats), patience_);
      append(out, answer(frames[f], out.size(), results));
      progress(static_cast<double>(f + 1) / static_cast<double>(frames.size()));
    }
    return out;
  }

  /// A pause, which ends what a frame may have left open; what comes meanwhile is dropped.
  void reset() override {
    std::size_t bytes = 0;
    while (const std::size_t more = line_.read(kBeatBytes * kMostResults, kPause).size()) {
      bytes += more;
      if (bytes > kMostLeftOver) {
        throw Error(
            fmt::format("{}: sends bytes that nobody asked for; is it a board with hwffd?", name_));
      }
    }
  }

 private:
  std::vector<Beat> answer(const Frame& frame, std::size_t before, std::size_t results) {
    Bytes bytes;
    while (bytes.size() < frame.results * kBeatBytes) {
      const Bytes more = line_.read(frame.results * kBeatBytes - bytes.size(), patience_);
      if (more.empty()) {
        throw Error(fmt::format(
            "{}: {} of {} results came, then none for {} s; is the board there, and loaded?", name_,
            before + bytes.size() / kBeatBytes, results,
            std::chrono::duration<double>(patience_).count()));
      }
      bytes.insert(bytes.end(), more.begin(), more.end());
    }
    std::vector<Beat> beats = beats_of(bytes);
    for (std::size_t b = 0; b < beats.size(); ++b) {
      const bool ends = b + 1 == beats.size();
      if (beats[b].last != ends) {
        throw Error(fmt::format("{}: result {} is out of step; start again", name_, before + b));
      }
      beats[b].last = ends && frame.ends;
    }
    return beats;
  }

  /// @throws Error unless what answers has the bits of that row
  void identify(const Configuration& row) {
    if (answers_as(*this, row)) return;
    throw Error(fmt::format(
        "{}: its results are not those of {}; give the organization and format of its bitstream",
        name_, row.name));
  }

  std::string name_;
  SerialLine line_;
  Milliseconds patience_;
};

}  // namespace

std::unique_ptr<CommandStream> serial_stream(const std::string& path, const Configuration& row,
                                             Milliseconds patience) {
  return std::make_unique<SerialStream>(path, row, patience);
}

}  // namespace hwffd
