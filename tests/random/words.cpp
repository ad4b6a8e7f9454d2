// hwffd-random-words: a stream of any packets for a core of any parameters, as its bench reads it
// (ffd_bench_random.v), and what the model makes of it.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "any_packets.hpp"
#include "hwffd/error.hpp"
#include "hwffd/model/stream_model.hpp"
#include "program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::test;

/// How the bench moves beats of a segment of the stream, in the order of its parameters.
struct Pace {
  unsigned source = 0;  ///< 0 always, 1 three of four clocks, 2 one of eight, 3 bursts
  unsigned sink = 0;    ///< the same; 3: not before nothing moves any more
};

/// What a segment is for.
enum class Purpose {
  kAny,
  kMemory  ///< its only wait is that for memory
};

/// Packets that begin in an idle core.
struct Segment {
  std::vector<std::vector<Beat>> packets;
  Pace pace;
  Purpose purpose = Purpose::kAny;
};

struct Options {
  std::string org, format, schedule = "overlapped", evaluator = "pipelined", folder;
  std::string other;  ///< an organization whose results have the same bits, and its N
  int n = 1;
  int other_n = 1;
  int fma = 0;
  int segments = 3;
  int interval = 64;  ///< clocks of a vertex, about: slow cores have fewer
  std::uint64_t seed = 1;
  PageCore core;
};

Pace any_pace(tb::Random& random) {
  return {static_cast<unsigned>(random.pick({0, 0, 1, 1, 2, 3})),
          static_cast<unsigned>(random.pick({0, 1, 1, 2, 3, 3}))};
}

Segment of_packets(std::vector<std::vector<Beat>> packets, const Pace& pace) {
  Segment segment;
  segment.packets = std::move(packets);
  segment.pace = pace;
  return segment;
}

/// Segments of every kind, in a random order after what loads the core.
std::vector<Segment> stream(const WordCodec& codec, const Options& options) {
  tb::Random random(options.seed);
  AnyPackets packets(codec, random, options.core);
  std::vector<Segment> segments;
  const std::size_t most = options.interval > 16 ? 3 : 6;
  if (random.chance(0.7))
    segments.push_back(of_packets({packets.vertices(0, most)}, any_pace(random)));
  const auto load = [&] {
    std::vector<std::vector<Beat>> some{packets.functions()};
    for (int more = std::min(options.core.pages, 2); more > 0; --more) {
      if (auto lattice = packets.lattice(); !lattice.empty()) some.push_back(std::move(lattice));
    }
    if (packets.has(model::kSpansFeature)) some.push_back(packets.spans());
    return of_packets(std::move(some), any_pace(random));
  };
  segments.push_back(load());
  const bool slow = options.interval > 64;
  for (int p = 0; p < (slow ? 1 : options.segments); ++p) {
    switch (slow ? 1 + random.below(4) : random.below(5)) {
      case 0: {  // more small packets than the core holds
        Segment segment = of_packets({}, {0, 3});
        for (int more = options.interval > 16 ? 44 : 60; more > 0; --more) {
          if (packets.has(model::kInterleavedFeature) && !packets.has(model::kResidentFeature) &&
              more > 12)
            continue;
          segment.packets.push_back(packets.vertices(packets.page(), 1));
        }
        segments.push_back(std::move(segment));
        break;
      }
      case 1: {
        const int page = packets.page();
        Segment segment = of_packets({packets.vertices(page, 1), packets.overwriting(page)}, {});
        segment.purpose = Purpose::kMemory;
        segments.push_back(load());
        segments.push_back(std::move(segment));
        break;
      }
      default: {
        Segment segment = of_packets({}, any_pace(random));
        for (std::uint64_t more = random.between(3, 7); more > 0; --more)
          segment.packets.push_back(packets.any(most));
        segments.push_back(std::move(segment));
      }
    }
  }
  return segments;
}

/// Whether the last result of a packet comes with `m_axis_tuser`.
bool marked(const std::vector<Beat>& packet, const Options& options) {
  constexpr std::uint32_t kInterrupt = 1U << 21;
  const std::uint32_t word = packet[0].words[0];
  const std::uint32_t opcode = word & 0xFF;
  return (options.core.features & model::kMarksFeature) != 0 && (word & kInterrupt) != 0 &&
         (opcode == 7 || opcode == 8);
}

/// A result a line; behind each segment a line with the events and vertices in it.
std::vector<std::string> answers(const std::vector<Segment>& segments, const Configuration& row,
                                 const Options& options) {
  const PageCore& core = options.core;
  model::StreamModel model(row, core.features, core.axis, core.pages, core.spans);
  std::vector<std::string> lines;
  model::StreamEvents before{};
  std::uint64_t vertices = 0;
  for (const Segment& segment : segments) {
    for (const auto& packet : segment.packets) {
      for (const Beat& result : model.run(packet)) {
        const auto& w = result.words;
        lines.push_back(fmt::format("{:d} {:d} {:08x} {:08x} {:08x} {:08x}",
                                    result.last && marked(packet, options), result.last, w[3], w[2],
                                    w[1], w[0]));
      }
    }
    std::string line = segment.purpose == Purpose::kMemory ? "memory" : "any";
    for (std::size_t e = 0; e < before.size(); ++e)
      line += fmt::format(" {}", model.events()[e] - before[e]);
    lines.push_back(line + fmt::format(" {}", model.vertices() - vertices));
    before = model.events();
    vertices = model.vertices();
  }
  return lines;
}

void write(const std::filesystem::path& path, const std::vector<std::string>& lines) {
  std::ofstream out(path);
  for (const std::string& line : lines) out << line << '\n';
  if (!out.flush()) throw Error(path.string() + ": cannot be written");
}

std::vector<std::string> beat_lines(const std::vector<Segment>& segments) {
  std::vector<std::string> lines;
  for (const Segment& segment : segments) {
    bool first = true;
    for (const auto& packet : segment.packets) {
      for (const Beat& beat : packet) {
        const auto& w = beat.words;
        lines.push_back(
            fmt::format("{:02x}_{:x}_{:08x}_{:08x}_{:08x}_{:08x}",
                        (first ? 1U : 0U) | segment.pace.sink << 1 | segment.pace.source << 3,
                        beat.last ? 1 : 0, w[3], w[2], w[1], w[0]));
        first = false;
      }
    }
  }
  return lines;
}

Configuration row_of(const Options& options, const std::string& org, int n) {
  return {"random",
          org.c_str(),
          n,
          options.format.c_str(),
          options.schedule.c_str(),
          options.evaluator.c_str(),
          1,
          1,
          options.fma,
          0,
          "all",
          "all"};
}

void run(const Options& options) {
  const WordCodec codec(options.format);
  const auto segments = stream(codec, options);
  const std::filesystem::path folder(options.folder);
  std::filesystem::create_directories(folder);
  write(folder / "beats.hex", beat_lines(segments));
  write(folder / "model.txt", answers(segments, row_of(options, options.org, options.n), options));
  if (options.other.empty()) return;
  write(folder / "other.txt",
        answers(segments, row_of(options, options.other, options.other_n), options));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return run_program("hwffd-random-words", [&] {
    CLI::App app("Writes any packets for a core, and what the model makes of them.");
    app.add_option("--org", options.org, "organization")->required();
    app.add_option("--n", options.n, "control points in a clock");
    app.add_option("--other", options.other, "an organization whose bits are the same");
    app.add_option("--other-n", options.other_n, "its N");
    app.add_option("--format", options.format, "number format")->required();
    app.add_option("--schedule", options.schedule);
    app.add_option("--evaluator", options.evaluator);
    app.add_option("--fma", options.fma, "FMA_LATENCY");
    app.add_option("--features", options.core.features)->required();
    app.add_option("--axis", options.core.axis);
    app.add_option("--pages", options.core.pages);
    app.add_option("--spans", options.core.spans);
    app.add_option("--interval", options.interval, "clocks of a vertex, about");
    app.add_option("--parts", options.segments, "of the stream, about");
    app.add_option("--seed", options.seed);
    app.add_option("--folder", options.folder, "for beats.hex, model.txt and other.txt")
        ->required();
    parse_command_line(app, argc, argv);
    run(options);
    return 0;
  });
}
