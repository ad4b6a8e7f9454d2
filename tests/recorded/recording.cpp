#include "recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"

namespace hwffd::test {
namespace {

constexpr std::size_t kBankBeats = 1 + 2 * kCoefficientBeats;

/// The lines of a file but for comments and empty ones, with their numbers.
template <class Take>
void for_each_line(const std::string& path, Take take) {
  std::ifstream file(path);
  if (!file) throw Error(path + ": cannot read the recording");
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line[0] == '/' || line[0] == '#') continue;
    if (!take(line)) throw Error(fmt::format("{}:{}: not a line of a recording", path, number));
  }
}

bool read_number(const std::string& text, int base, std::uint64_t& value) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value, base);
  return read.ec == std::errc() && read.ptr == end;
}

std::vector<std::string> fields_of(const std::string& line, char separator) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, separator);) fields.push_back(field);
  return fields;
}

bool read_beat(const std::string& line, Beat& beat) {
  const std::vector<std::string> fields = fields_of(line, '_');
  if (fields.size() != 5 || (fields[0] != "0" && fields[0] != "1")) return false;
  beat.last = fields[0] == "1";
  for (int word = 0; word < 4; ++word) {
    std::uint64_t value = 0;
    if (fields[4 - word].size() != 8 || !read_number(fields[4 - word], 16, value)) return false;
    beat.words[word] = static_cast<std::uint32_t>(value);
  }
  return true;
}

bool read_recording(const std::string& line, Recording& recording) {
  const std::vector<std::string> fields = fields_of(line, ',');
  if (fields.size() != 3 + recording.events.size()) return false;
  recording.row = fields[0];
  std::uint64_t results = 0;
  if (!read_number(fields[1], 10, results) || !read_number(fields[2], 16, recording.hash)) {
    return false;
  }
  recording.results = results;
  for (std::size_t event = 0; event < recording.events.size(); ++event) {
    if (!read_number(fields[3 + event], 10, recording.events[event])) return false;
  }
  return true;
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

}  // namespace

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

std::string stream_path(const std::string& kind, const std::string& format) {
  return fmt::format("{}/{}/{}.txt", HWFFD_RECORDINGS, kind, format);
}

std::string table_path(const std::string& kind) {
  return fmt::format("{}/{}/results.csv", HWFFD_RECORDINGS, kind);
}

std::vector<Beat> read_stream(const std::string& path) {
  std::vector<Beat> beats;
  for_each_line(path, [&](const std::string& line) {
    beats.emplace_back();
    return read_beat(line, beats.back());
  });
  return beats;
}

void write_stream(const std::string& path, const std::vector<Beat>& beats) {
  std::string text = "// tlast, then words 3 to 0\n";
  for (const Beat& beat : beats) {
    text += fmt::format("{:d}_{:08x}_{:08x}_{:08x}_{:08x}\n", beat.last, beat.words[3],
                        beat.words[2], beat.words[1], beat.words[0]);
  }
  write_files({{path, text}});
}

std::vector<Recording> read_table(const std::string& path) {
  std::vector<Recording> recordings;
  for_each_line(path, [&](const std::string& line) {
    recordings.emplace_back();
    return read_recording(line, recordings.back());
  });
  return recordings;
}

void write_table(const std::string& path, const std::vector<Recording>& recordings) {
  std::string text = "# row, results, hash of the results, events by number\n";
  for (const Recording& recording : recordings) {
    text += fmt::format("{},{},{:016x},{}\n", recording.row, recording.results, recording.hash,
                        fmt::join(recording.events, ","));
  }
  write_files({{path, text}});
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
