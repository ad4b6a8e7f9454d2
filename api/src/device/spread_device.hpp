#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "device/stream_device.hpp"

namespace hwffd {

/// Models of one row, one for each thread that evaluates: the vertices of a call are spread over
/// them (on_threads.hpp). Bits are those of one model, which do not depend on other vertices.
class SpreadDevice final : public Device {
 public:
  using Make = std::function<std::unique_ptr<StreamDevice>()>;

  /// @param row  of the models
  /// @param make  one more model; called when a thread needs one
  /// @param rows  whether gradients of grids are pulled back by rows
  SpreadDevice(const Configuration& row, Make make, bool rows);

  std::string name() const override { return name_; }
  bool concurrent() const override { return !shows(); }

 protected:
  Tangents run_tangents(const Lattice& lattice, const std::vector<Embedded>& vertices,
                        const Blending& blending) override;
  Points run(const std::vector<SupportedVertex>& vertices, const Blending& blending) override;
  Points run(const Lattice& lattice, const std::vector<Embedded>& vertices,
             const Blending& blending) override;
  /// Row by row where the model can (model_grid.hpp).
  Points run_grid(const Lattice& lattice, const Grid& grid, const Blending& blending) override;
  Points run_pull_back(const Index3& dims, const std::vector<Embedded>& vertices,
                       const Points& gradient, const Blending& blending) override;
  Points run_pull_back_grid(const Index3& dims, const Grid& grid, const Points& gradient,
                            const Blending& blending) override;

 private:
  using Part = std::function<void(StreamDevice& model, const std::vector<Embedded>& vertices,
                                  std::size_t first)>;

  /// Calls part with ranges of the vertices and a model that nobody else uses.
  void spread(const std::vector<Embedded>& vertices, const Part& part);
  std::unique_ptr<StreamDevice> take();
  /// Counts what the model did, and keeps it for the next.
  void give_back(std::unique_ptr<StreamDevice> model);
  /// Counts what a call saturated.
  void count_saturated(std::uint64_t vertices);
  /// The functions of a call that pulls back.
  /// @throws Error of a row that has no transpose
  std::array<AxisWords, 3> pull_back_functions(const Blending& blending) const;

  Configuration row_;
  Make make_;
  bool rows_;
  std::string name_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<StreamDevice>> idle_;
};

}  // namespace hwffd
