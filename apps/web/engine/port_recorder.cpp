#include "port_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "design.hpp"
#include "hwffd/error.hpp"

namespace hwffd::web {
namespace {

constexpr int kClockPeriod = 10;  // ns

const Port& port(const std::string& name) {
  std::string known;
  for (const Port& port : ports()) {
    if (port.name == name) return port;
    known += (known.empty() ? "" : ", ") + port.name;
  }
  throw Error(fmt::format("port '{}': unknown; one of {}", name, known));
}

std::string hexadecimal(const std::uint8_t* bytes, int width) {
  std::string text;
  for (int digit = (width + 3) / 4 - 1; digit >= 0; --digit) {
    text += "0123456789abcdef"[bytes[digit / 2] >> (digit % 2 * 4) & 15];
  }
  return text;
}

/// A value as VCD has it, of the identifier given.
std::string change(const std::uint8_t* bytes, int width, const std::string& identifier) {
  if (width == 1) return fmt::format("{}{}\n", bytes[0] & 1, identifier);
  std::string bits;
  for (int bit = width - 1; bit >= 0; --bit) bits += (bytes[bit / 8] >> (bit % 8) & 1) ? '1' : '0';
  return fmt::format("b{} {}\n", bits, identifier);
}

/// "!", "\"", ...: one printable character, since there are few.
std::string identifier(std::size_t number) {
  return std::string(1, static_cast<char>('!' + number));
}

}  // namespace

void PortRecorder::watch(const std::vector<std::string>& names) {
  std::vector<Watched> watched;
  for (const std::string& name : names) {
    watched.push_back({name, signals_.only(port(name).signal)});
  }
  watched_ = std::move(watched);
  samples_.clear();
}

void PortRecorder::sample(std::uint64_t clock) {
  if (watched_.empty()) return;
  Sample sample;
  if (samples_.size() == kClocks) {  // whose room serves again
    sample = std::move(samples_.front());
    samples_.pop_front();
  }
  sample.clock = clock;
  sample.bytes.clear();
  for (const Watched& watched : watched_) {
    const auto* const bytes = static_cast<const std::uint8_t*>(watched.signal.data);
    sample.bytes.insert(sample.bytes.end(), bytes, bytes + watched.signal.bytes);
  }
  samples_.push_back(std::move(sample));
}

std::map<std::string, std::string> PortRecorder::values() const {
  std::map<std::string, std::string> values;
  std::size_t place = 0;
  for (const Watched& watched : watched_) {
    const std::uint8_t* const bytes = samples_.empty() ? nullptr : &samples_.back().bytes[place];
    values[watched.name] = bytes == nullptr ? "" : hexadecimal(bytes, watched.signal.width);
    place += static_cast<std::size_t>(watched.signal.bytes);
  }
  return values;
}

std::string PortRecorder::vcd() const {
  std::string text = "$timescale 1 ns $end\n$scope module hwffd_stream $end\n";
  text += fmt::format("$var wire 1 {} aclk $end\n", identifier(0));
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    const int width = watched_[i].signal.width;
    const std::string range = width == 1 ? "" : fmt::format(" [{}:0]", width - 1);
    text += fmt::format("$var wire {} {} {}{} $end\n", width, identifier(i + 1), watched_[i].name,
                        range);
  }
  text += "$upscope $end\n$enddefinitions $end\n";
  const Sample* before = nullptr;
  for (const Sample& sample : samples_) {
    text += fmt::format("#{}\n1{}\n", sample.clock * kClockPeriod, identifier(0));
    std::size_t place = 0;
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      const cores::Signal& signal = watched_[i].signal;
      const std::uint8_t* const bytes = &sample.bytes[place];
      const auto size = static_cast<std::size_t>(signal.bytes);
      if (before == nullptr || !std::equal(bytes, bytes + size, &before->bytes[place])) {
        text += change(bytes, signal.width, identifier(i + 1));
      }
      place += size;
    }
    text +=
        fmt::format("#{}\n0{}\n", sample.clock * kClockPeriod + kClockPeriod / 2, identifier(0));
    before = &sample;
  }
  return text;
}

}  // namespace hwffd::web
