#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hwffd/device/device.hpp"
#include "hwffd/model/configuration.hpp"
#include "hwffd/stream/resident_pages.hpp"

namespace hwffd {

namespace cores {
class StreamCore;
}

/// Something that takes the command stream of `hwffd_stream` and gives its results.
class CommandStream {
 public:
  static constexpr std::size_t kStepsSeen = 100;  ///< of progress, where somebody wants to know it

  virtual ~CommandStream() = default;
  /// All that comes back.
  /// @param results  how many beats that should be
  /// @param steps  of progress, at least, unless there are as many anyway
  /// @throws Error if nothing comes any more before there are as many, and what progress throws
  virtual std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                                const Progress& progress, std::size_t steps) = 0;
  /// Forgets the packet under way and what is loaded: ready for the first beat of a packet,
  /// whatever became of the last run.
  virtual void reset() = 0;
  /// Clocks so far; 0 where there are none.
  virtual std::uint64_t clocks() const { return 0; }
  /// What the core behind it keeps of lattices.
  virtual PointStore store() const { return {}; }
  /// Whether that core makes the vertices of grids, opcode 8.
  virtual bool has_grids() const { return false; }
};

/// The bit-true model of a row of the table, with that store, and with grids or without.
std::unique_ptr<CommandStream> model_stream(const Configuration& row, const PointStore& store = {},
                                            bool grids = false);
/// Its Verilated RTL, just out of reset.
std::unique_ptr<CommandStream> rtl_stream(const Configuration& row);
/// A Verilated core that adds gradients up, of grids by rows or not, just out of reset.
std::unique_ptr<CommandStream> rtl_scatter_stream(bool rows, const std::string& name);
/// A Verilated core that is there already, and has that store and grids or not.
std::unique_ptr<CommandStream> rtl_stream(std::unique_ptr<cores::StreamCore> core,
                                          const std::string& name, const PointStore& store,
                                          bool grids = false);

/// A device behind a command stream: coefficients, then the lattice, then the vertices. A lattice
/// that is larger than the core keeps goes there by pages, with the vertices of each.
class StreamDevice final : public Device {
 public:
  StreamDevice(const std::string& kind, const Configuration& row,
               std::unique_ptr<CommandStream> stream);

  std::string name() const override { return name_; }
  /// Results beyond what fixed point holds, since this was asked last.
  std::uint64_t take_saturated() { return std::exchange(counts_.saturated, 0); }

  Points run(const Lattice& lattice, const std::vector<Embedded>& vertices,
             const Blending& blending) override;
  Points run(const std::vector<SupportedVertex>& vertices, const Blending& blending) override;
  /// By one packet where the core has grids and keeps the lattice as one.
  Points run_grid(const Lattice& lattice, const Grid& grid, const Blending& blending) override;
  Tangents run_tangents(const Lattice& lattice, const std::vector<Embedded>& vertices,
                        const Blending& blending) override;

 private:
  /// What is known of a vertex's results before they come.
  struct Asked {
    std::uint32_t tag;
    bool ends;  ///< its packet
  };
  using Questions = std::vector<Asked>;

  /// Of a lattice, or a page of one, that is sent at once: at most.
  int axis_points() const;
  /// Whether the core takes a lattice whole, by opcode 2.
  bool takes_whole(const Index3& dims) const;
  static Questions asked_in_order(std::size_t vertices, std::uint32_t tag = 0,
                                  std::size_t packet = kPacketVertices);
  static Questions asked_by_page(const PagedVertices& paged, const std::vector<LatticePage>& pages);

  /// Sends the commands, which end with the packets of these vertices, and reads the results.
  std::vector<Beat> answer(const std::vector<Beat>& commands, const Questions& asked,
                           std::size_t each);
  /// Throws Error unless these are the results of the vertices, in their order.
  void check(const std::vector<Beat>& beats, const Questions& asked, std::size_t each) const;
  /// Coefficients, the lattice and its vertices.
  std::vector<Beat> answer(const std::array<AxisWords, 3>& axes, const LatticeWords& lattice,
                           const std::vector<VertexBeat>& vertices, Results results);

  std::string name_;
  Configuration row_;
  std::unique_ptr<CommandStream> stream_;
  PointStore store_;
  std::optional<ResidentPages> pages_;  // in a core that has any
};

}  // namespace hwffd
