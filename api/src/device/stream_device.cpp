#include "device/stream_device.hpp"

#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/interleave.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd {
namespace {

Blending blending_words(const Oracle::Coefficients& axis, const WordCodec& codec) {
  if (axis == Oracle::uniform_bspline()) return watertight_bspline(codec);
  std::array<std::array<double, 4>, 4> rows{};
  for (int function = 0; function < 4; ++function) {
    for (int power = 0; power < 4; ++power) rows[function][power] = axis(function, power);
  }
  return user_blending(rows);
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
  append(packets, vertices_packets(vertex_beats(vertices, codec)));
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
  const std::vector<Beat> packets = interleaved_packets(interleave(vertices, codec, normalization));
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
  for (const Beat& beat : beats) {
    if ((beat.words[3] & kStatusSaturated) != 0) ++counts_.saturated;
  }
  counts_.clocks = stream_->clocks();
  return positions_of(beats, codec, normalization);
}

}  // namespace hwffd
