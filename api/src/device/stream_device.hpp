#pragma once

#include <memory>

#include "hwffd/device/device.hpp"
#include "hwffd/model/configuration.hpp"
#include "hwffd/stream/beat.hpp"

namespace hwffd {

/// Something that takes the command stream of `hwffd_stream` and gives its results.
class CommandStream {
 public:
  virtual ~CommandStream() = default;
  /// @param results  how many beats come back
  /// @throws Error if they do not
  virtual std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                                const Progress& progress) = 0;
  /// Clocks so far; 0 where there are none.
  virtual std::uint64_t clocks() const { return 0; }
};

/// The bit-true model of a row of the table.
std::unique_ptr<CommandStream> model_stream(const Configuration& row);
/// Its Verilated RTL, just out of reset.
std::unique_ptr<CommandStream> rtl_stream(const Configuration& row);

/// A device behind a command stream: coefficients, then the lattice, then the vertices.
class StreamDevice final : public Device {
 public:
  StreamDevice(const std::string& kind, const Configuration& row,
               std::unique_ptr<CommandStream> stream);

  std::string name() const override { return name_; }

 protected:
  Points run(const Lattice& lattice, const std::vector<Embedded>& vertices,
             const Blending& blending) override;
  Points run(const std::vector<SupportedVertex>& vertices, const Blending& blending) override;

 private:
  /// Sends the packets behind the one of the coefficients and reads so many results.
  Points results_of(const std::vector<Beat>& packets, std::size_t results, const Blending& blending,
                    const WordCodec& codec, const Normalization& normalization);

  std::string name_;
  std::string format_;
  std::unique_ptr<CommandStream> stream_;
};

}  // namespace hwffd
