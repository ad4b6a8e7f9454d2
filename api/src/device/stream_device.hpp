#pragma once

#include <memory>

#include "hwffd/device/device.hpp"
#include "hwffd/model/configuration.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd {

/// Something that takes the command stream of `hwffd_stream` and gives its results.
class CommandStream {
 public:
  virtual ~CommandStream() = default;
  /// All that comes back.
  /// @param results  how many beats that should be
  /// @throws Error if nothing comes any more before there are as many, and what progress throws
  virtual std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                                const Progress& progress) = 0;
  /// Forgets the packet under way and what is loaded: ready for the first beat of a packet,
  /// whatever became of the last run.
  virtual void reset() = 0;
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
  Tangents run_tangents(const Lattice& lattice, const std::vector<Embedded>& vertices,
                        const Blending& blending) override;

 private:
  /// Sends the commands, which end with the packets of so many vertices, and reads the results.
  std::vector<Beat> answer(const std::vector<Beat>& commands, std::size_t vertices,
                           std::size_t each);
  /// Throws Error unless these are the results of the vertices, in their order.
  void check(const std::vector<Beat>& beats, std::size_t vertices, std::size_t each) const;
  /// Coefficients, the lattice and its vertices.
  std::vector<Beat> answer(const std::array<AxisWords, 3>& axes, const LatticeWords& lattice,
                           const std::vector<VertexBeat>& vertices, Results results);

  std::string name_;
  std::string format_;
  std::unique_ptr<CommandStream> stream_;
};

}  // namespace hwffd
