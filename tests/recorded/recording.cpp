#include "recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"

namespace hwffd::test {
namespace {

constexpr std::size_t kRecordedBytes = 17;  // of a beat
constexpr std::size_t kBankBeats = 1 + 2 * kCoefficientBeats;

std::string line_of(const Beat& beat) {
  const auto& words = beat.words;
  return fmt::format("{:d}_{:08x}_{:08x}_{:08x}_{:08x}", beat.last, words[3], words[2], words[1],
                     words[0]);
}

std::string line_of(const Recording& recording) {
  const auto& events = recording.events;
  const auto end = events.end() - (events.back() == 0 ? 1 : 0);  // the last where there are any
  return fmt::format("{},{},{:016x},{}", recording.row, recording.results, recording.hash,
                     fmt::join(events.begin(), end, ","));
}

// A line is one where it is what would be written of what was read.

bool read(const std::string& line, Beat& beat) {
  std::istringstream in(line);
  char separator = 0;
  in >> beat.last >> std::hex;
  for (int word = 3; word >= 0; --word) in >> separator >> beat.words[word];
  return line_of(beat) == line;
}

bool read(const std::string& line, Recording& recording) {
  std::istringstream in(line);
  char separator = 0;
  std::getline(in, recording.row, ',');
  in >> recording.results >> separator >> std::hex >> recording.hash >> std::dec;
  for (std::uint64_t& event : recording.events) {
    if (in.peek() == ',') in >> separator >> event;
  }
  return line_of(recording) == line;
}

template <class Item>
std::vector<Item> read_lines(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw Error(path + ": cannot read the recording");
  std::vector<Item> items;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line[0] == '/' || line[0] == '#') continue;
    if (!read(line, items.emplace_back())) {
      throw Error(fmt::format("{}:{}: not a line of a recording", path, number));
    }
  }
  return items;
}

template <class Item>
void write_lines(const std::string& path, std::string text, const std::vector<Item>& items) {
  for (const Item& item : items) text += line_of(item) + "\n";
  write_files({{path, text}});
}

/// Ten bits, two's complement.
int exponent_of(const Beat& header) {
  const int bits = static_cast<int>(header.words[3] & 0x3FF);
  return bits < 0x200 ? bits : bits - 0x400;
}

std::vector<std::vector<Beat>> packets_of(const std::vector<Beat>& beats) {
  std::vector<std::vector<Beat>> packets(1);
  for (const Beat& beat : beats) {
    packets.back().push_back(beat);
    if (beat.last) packets.emplace_back();
  }
  packets.pop_back();
  return packets;
}

/// The bank that a packet of coefficients with derivatives loads (docs/interface.md section 3).
std::array<AxisWords, 3> bank_of(const std::vector<Beat>& packet) {
  const std::uint32_t shifts = packet[0].words[2];
  std::array<AxisWords, 3> bank;
  for (int axis = 0; axis < 3; ++axis) {
    bank[axis].degree = static_cast<int>(shifts >> (2 * axis) & 3);
    bank[axis].shift = static_cast<int>(shifts >> (8 + 2 * axis) & 3);
    bank[axis].derivative.shift = static_cast<int>(shifts >> (16 + 2 * axis) & 3);
    for (int f = 0; f < 4; ++f) {
      bank[axis].word[f] = packet[1 + 4 * axis + f].words;
      bank[axis].derivative.word[f] = packet[1 + kCoefficientBeats + 4 * axis + f].words;
    }
  }
  return bank;
}

tb::EvaluatorStimulus stimulus_of(const std::vector<Beat>& packet) {
  tb::EvaluatorStimulus stimulus;
  for (std::size_t first = 1; first < packet.size(); first += kVertexBeats) {
    tb::SupportWords& support = stimulus.supports.emplace_back();
    support.exponent = exponent_of(packet[0]);
    for (int row = 0; row < kPointBeats; ++row) {
      const auto& words = packet[first + 1 + row].words;
      std::copy(words.begin(), words.end(), support.points.begin() + 4 * row);
    }
    tb::EvaluatorVertex vertex;
    const auto& words = packet[first].words;
    std::copy_n(words.begin(), 3, vertex.local.begin());
    for (int axis = 0; axis < 3; ++axis) {
      vertex.cell[axis] = static_cast<int>(words[3] >> (16 + 4 * axis) & 15);
    }
    vertex.support = static_cast<std::uint8_t>(stimulus.supports.size() - 1);
    vertex.bank = static_cast<int>(stimulus.supports.size() % 2);
    for (vertex.derivative = -1; vertex.derivative < 3; ++vertex.derivative) {
      stimulus.vertices.push_back(vertex);
    }
  }
  return stimulus;
}

std::string stream_path(const std::string& kind, const std::string& format) {
  return fmt::format("{}/{}/{}.bin", HWFFD_RECORDINGS, kind, format);
}

}  // namespace

RecordedEvents recorded_events(const std::array<std::uint64_t, kStreamEvents>& events) {
  constexpr unsigned kSums = stream_event(event::kFunctionsSum);
  RecordedEvents known{};
  std::copy_n(events.begin(), known.size() - 1, known.begin());
  known.back() = events[kSums];
  for (unsigned event = known.size() - 1; event < events.size(); ++event) {
    if (event != kSums && events[event] != 0) {
      throw Error("a recorded stream has an event that recordings do not know");
    }
  }
  return known;
}

std::uint64_t hash_of(const std::vector<Beat>& beats) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  const auto take = [&hash](std::uint32_t byte) { hash = (hash ^ byte) * 0x100000001B3U; };
  for (const Beat& beat : beats) {
    for (const std::uint32_t word : beat.words) {
      for (int byte = 0; byte < 4; ++byte) take(word >> (8 * byte) & 0xFF);
    }
    take(beat.last ? 1 : 0);
  }
  return hash;
}

std::string table_path(const std::string& kind) {
  return fmt::format("{}/{}/results.csv", HWFFD_RECORDINGS, kind);
}

std::vector<Beat> read_stream(const std::string& path) { return read_lines<Beat>(path); }

void write_stream(const std::string& path, const std::vector<Beat>& beats) {
  write_lines(path, "// tlast, then words 3 to 0\n", beats);
}

std::vector<Beat> read_recorded_stream(const std::string& kind, const std::string& format) {
  const std::string path = stream_path(kind, format);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file || bytes.empty() || bytes.size() % kRecordedBytes != 0) {
    throw Error(
        fmt::format("{}: {} bytes, beats of {} wanted", path, bytes.size(), kRecordedBytes));
  }
  std::vector<Beat> beats(bytes.size() / kRecordedBytes);
  auto byte = bytes.begin();
  for (Beat& beat : beats) {
    for (std::uint32_t& word : beat.words) {
      word = 0;
      for (int b = 0; b < 4; ++b) word |= static_cast<std::uint32_t>(*byte++ & 0xFF) << (8 * b);
    }
    beat.last = *byte++ != 0;
  }
  return beats;
}

void write_recorded_stream(const std::string& kind, const std::string& format,
                           const std::vector<Beat>& beats) {
  std::string bytes;
  for (const Beat& beat : beats) {
    for (const std::uint32_t word : beat.words) {
      for (int b = 0; b < 4; ++b) bytes += static_cast<char>(word >> (8 * b) & 0xFF);
    }
    bytes += beat.last ? '\1' : '\0';
  }
  write_files({{stream_path(kind, format), bytes}});
}

std::vector<Recording> read_table(const std::string& path) { return read_lines<Recording>(path); }

void write_table(const std::string& path, const std::vector<Recording>& recordings) {
  write_lines(
      path, "# row, results, hash of the results, events by number, functions that do not sum up\n",
      recordings);
}

std::vector<Configuration> recorded_rows() {
  std::vector<Configuration> rows;
  for (const Configuration& row : configurations()) {
    if (std::string(row.tier) != "all") rows.push_back(row);
  }
  return rows;
}

ReadPortRecording read_port_recording(const std::vector<Beat>& beats) {
  const std::vector<std::vector<Beat>> packets = packets_of(beats);
  if (packets.size() != 3 || packets[0].size() != kBankBeats || packets[1].size() != kBankBeats ||
      packets[2].size() % kVertexBeats != 1) {
    throw Error(
        "a recording of a read port has two banks of coefficients and a packet of vertices");
  }
  return {{bank_of(packets[0]), bank_of(packets[1])}, stimulus_of(packets[2])};
}

}  // namespace hwffd::test
