#include "device/stream_device.hpp"

#include <algorithm>

#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/interleave.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kPacket = 1024;  // vertices; a tag has 16 bits

Blending blending_words(const Oracle::Coefficients& axis, const WordCodec& codec) {
  if (axis == Oracle::uniform_bspline()) return watertight_bspline(codec);
  std::array<std::array<double, 4>, 4> rows{};
  for (int function = 0; function < 4; ++function) {
    for (int power = 0; power < 4; ++power) rows[function][power] = axis(function, power);
  }
  return user_blending(rows);
}

void append(std::vector<Beat>& beats, const std::vector<Beat>& more) {
  beats.insert(beats.end(), more.begin(), more.end());
}

/// Vertices in packets of kPacket, each made by `packet_of`.
template <class Vertex, class PacketOf>
void append_in_packets(std::vector<Beat>& beats, const std::vector<Vertex>& vertices,
                       PacketOf packet_of) {
  for (std::size_t first = 0; first < vertices.size(); first += kPacket) {
    const std::size_t last = std::min(first + kPacket, vertices.size());
    append(beats,
           packet_of(std::vector<Vertex>(vertices.begin() + static_cast<std::ptrdiff_t>(first),
                                         vertices.begin() + static_cast<std::ptrdiff_t>(last))));
  }
}

class ModelStream final : public CommandStream {
 public:
  explicit ModelStream(const Configuration& row) : model_(row) {}

  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                        const Progress& progress) override {
    std::vector<Beat> out;
    out.reserve(results);
    const std::size_t step = commands.size() / 100 + 1;
    for (std::size_t b = 0; b < commands.size(); ++b) {
      model_.accept(commands[b]);
      if ((b + 1) % step != 0 && b + 1 != commands.size()) continue;
      append(out, model_.take_results());
      progress(static_cast<double>(b + 1) / static_cast<double>(commands.size()));
    }
    return out;
  }

 private:
  model::StreamModel model_;
};

}  // namespace

std::unique_ptr<CommandStream> model_stream(const Configuration& row) {
  return std::make_unique<ModelStream>(row);
}

StreamDevice::StreamDevice(const std::string& kind, const Configuration& row,
                           std::unique_ptr<CommandStream> stream)
    : name_(kind + " " + row.name), format_(row.format), stream_(std::move(stream)) {}

Points StreamDevice::run(const Lattice& lattice, const std::vector<Embedded>& vertices,
                         const Device::Blending& blending) {
  const WordCodec codec(format_);
  const Normalization normalization = Normalization::of(lattice, codec);
  std::vector<Beat> packets = lattice_packet(lattice_words(lattice, codec, normalization));
  const std::vector<VertexBeat> beats = vertex_beats(vertices, codec);
  append_in_packets(packets, beats, [](const auto& some) { return vertices_packet(some); });
  return results_of(packets, vertices.size(), blending, codec, normalization);
}

Points StreamDevice::run(const std::vector<SupportedVertex>& vertices,
                         const Device::Blending& blending) {
  const WordCodec codec(format_);
  Points points(64 * static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    points.middleRows<64>(64 * static_cast<Eigen::Index>(v)) = vertices[v].support;
  }
  const Normalization normalization = Normalization::of(points, codec);
  std::vector<Beat> packets;
  append_in_packets(packets, interleave(vertices, codec, normalization),
                    [](const auto& some) { return interleaved_packet(some); });
  return results_of(packets, vertices.size(), blending, codec, normalization);
}

Points StreamDevice::results_of(const std::vector<Beat>& packets, std::size_t results,
                                const Device::Blending& blending, const WordCodec& codec,
                                const Normalization& normalization) {
  std::vector<Beat> commands =
      coefficients_packet(std::array<hwffd::Blending, 3>{blending_words(blending[0], codec),
                                                         blending_words(blending[1], codec),
                                                         blending_words(blending[2], codec)},
                          codec);
  append(commands, packets);
  const std::vector<Beat> beats = stream_->run(commands, results, [&](double done) { show(done); });
  Points positions(static_cast<Eigen::Index>(beats.size()), 3);
  for (std::size_t v = 0; v < beats.size(); ++v) {
    Point point;
    for (int c = 0; c < 3; ++c) point[c] = codec.decode_point(beats[v].words[c]);
    positions.row(static_cast<Eigen::Index>(v)) = normalization.to_world(point);
    if ((beats[v].words[3] & kStatusSaturated) != 0) ++counts_.saturated;
  }
  counts_.clocks = stream_->clocks();
  return positions;
}

}  // namespace hwffd
