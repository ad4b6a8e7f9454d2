#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/grid.hpp"

namespace hwffd {

/// Called with the fraction done, the last time with 1.
using Progress = std::function<void(double)>;

/// What evaluates eq. (1): the simulated hardware, its bit-true model, or double precision. All
/// speak world coordinates; what a number format wants is the device's own business.
class Device {
 public:
  /// Blending coefficients of s, t and u (Oracle::Coefficients).
  using Blending = std::array<Oracle::Coefficients, 3>;

  /// What a device has done since it was made.
  struct Counts {
    std::uint64_t vertices = 0;
    std::uint64_t saturated = 0;  ///< results beyond what fixed point holds
    std::uint64_t clocks = 0;     ///< of the simulated hardware; 0 elsewhere
  };

  /// Points with their derivatives along the three axes of their cells.
  struct Tangents {
    Points positions;                        ///< n x 3
    std::vector<Eigen::Matrix3d> jacobians;  ///< column a: dq/ds, dq/dt, dq/du, s of a cell 0 to 1
  };

  virtual ~Device() = default;

  /// The kind of device, and its row of the table of configurations: "rtl basic-fx18-overlapped".
  virtual std::string name() const = 0;

  /// Positions of vertices in a lattice, n x 3, in their order.
  /// @param vertices  local coordinates in [0, 1]; hardware clamps others
  /// @param blending  the uniform B-spline is loaded in its watertight form (numerics.md section 5)
  /// @throws Error for a cell that the lattice does not have, a coordinate or coefficient that is
  ///   not finite, a result that is not (control points too large for the format), or hardware that
  ///   does not answer what it was asked. After any exception the device is as ready as before.
  Points evaluate(const Lattice& lattice, const std::vector<Embedded>& vertices,
                  const Blending& blending);
  /// The same at places in the cells of a family, by default of the uniform B-spline.
  Points evaluate(const Lattice& lattice, const std::vector<Embedded>& places,
                  const Family& family = {});

  /// Positions of the vertices of a regular grid, s fastest, then t, then u: those of its places,
  /// bit for bit. A core with grids makes the vertices itself, of a packet of four beats
  /// (interface.md).
  /// @throws Error for a grid that has no vertex or leaves the lattice, and as above
  Points evaluate_grid(const Lattice& lattice, const Grid& grid, const Blending& blending);
  /// In the cells of a family, those of another than the uniform B-spline place by place.
  Points evaluate_grid(const Lattice& lattice, const Grid& grid, const Family& family = {});

  /// The same with derivatives; positions are those of evaluate(), bit for bit.
  Tangents tangents(const Lattice& lattice, const std::vector<Embedded>& vertices,
                    const Blending& blending);
  /// At places in the cells of a family.
  Tangents tangents(const Lattice& lattice, const std::vector<Embedded>& places,
                    const Family& family = {});

  /// Positions of vertices that bring their control points, n x 3, in their order (paper, fig. 3).
  /// @throws Error for a number that is not finite, and as evaluate() of a lattice
  Points evaluate(const std::vector<SupportedVertex>& vertices, const Blending& blending);

  /// The transpose of evaluate(): of the gradient of a number with respect to the positions, n x 3,
  /// that with respect to the control points, m x 3, of a lattice of so many points an axis. It is
  /// the same, bit for bit, for vertices in any order and any number of threads.
  ///
  /// `reference` adds in double (pull_back_in). `model` adds whole numbers, as the core
  /// `hwffd_scatter` does (numerics.md section 11), and only rows of `affine` and its relatives
  /// with words of 12 to 18 bits have it. Of simulated hardware only the device of
  /// make_pull_back_device("rtl") has it, with the bits of that model.
  /// @param vertices  local coordinates in [0, 1]; hardware clamps others
  /// @throws Error from a device that has it not, for another number of gradients, a gradient that
  ///   is not finite, a sum that is not, and as evaluate()
  Points pull_back(const Index3& dims, const std::vector<Embedded>& vertices,
                   const Points& gradient, const Blending& blending);
  /// The same at places in the cells of a family, by default of the uniform B-spline.
  Points pull_back(const Index3& dims, const std::vector<Embedded>& places, const Points& gradient,
                   const Family& family = {});
  /// At the vertices of a regular grid, s fastest, then t, then u, as evaluate_grid() has them:
  /// with the bits of those vertices, but on a model with DeviceChoice::rows.
  /// @throws Error as evaluate_grid() and pull_back()
  Points pull_back_grid(const Index3& dims, const Grid& grid, const Points& gradient,
                        const Blending& blending);
  /// In the cells of a family, those of another than the uniform B-spline place by place.
  Points pull_back_grid(const Index3& dims, const Grid& grid, const Points& gradient,
                        const Family& family = {});

  /// Whether several threads may evaluate at once.
  virtual bool concurrent() const { return false; }

  /// It is called by the thread that evaluates. What it throws ends the evaluation.
  void on_progress(Progress progress) { progress_ = std::move(progress); }
  const Counts& counts() const { return counts_; }

 protected:
  virtual Points run(const Lattice& lattice, const std::vector<Embedded>& vertices,
                     const Blending& blending) = 0;
  virtual Points run(const std::vector<SupportedVertex>& vertices, const Blending& blending) = 0;
  /// Unless a device knows better, of the places one by one.
  virtual Points run_grid(const Lattice& lattice, const Grid& grid, const Blending& blending);
  virtual Tangents run_tangents(const Lattice& lattice, const std::vector<Embedded>& vertices,
                                const Blending& blending) = 0;
  /// Unless a device knows better, an Error.
  virtual Points run_pull_back(const Index3& dims, const std::vector<Embedded>& vertices,
                               const Points& gradient, const Blending& blending);
  /// Unless a device knows better, of the places one by one.
  virtual Points run_pull_back_grid(const Index3& dims, const Grid& grid, const Points& gradient,
                                    const Blending& blending);

  /// Whether somebody wants to know how far a call is.
  bool shows() const { return progress_ != nullptr; }
  void show(double done) const {
    Watch::look();
    if (progress_) progress_(done);
  }
  Counts counts_;

 private:
  /// @throws Error for a result that is not finite
  Points finite(Points positions) const;
  void count(std::size_t vertices);
  /// What was pulled back of so many vertices.
  /// @throws Error for a sum that is not finite
  Points counted(Points pulled, std::size_t vertices);

  Progress progress_;
  std::mutex counting_;
};

/// The places of a grid in the order of its results.
/// @throws Error for a grid that has no vertex or leaves a lattice of so many cells
std::vector<Embedded> places_of(const Grid& grid, const Index3& cells);

/// @throws Error, which names the vertex, for a cell that a lattice of that many does not have
void check_cell(const Index3& cell, const Index3& cells, std::size_t vertex);

/// Which device is wanted, in words.
struct DeviceChoice {
  /// "reference", "model", "rtl", or a board: "serial:" and the path of its line, "uio:" and the
  /// number of its file /dev/uioN, or "socket:" and the path of the socket at which a process
  /// serves a core.
  std::string device = "reference";
  /// Of all but the reference: an organization, basic, cg1, tree4, factored/3, ..., or the name of
  /// one of device_rows(), such as basic-fp32-overlapped-fmac. Empty for basic, or for what the
  /// board has as it comes.
  std::string org = "";
  /// Of the same: fp32, bfp32, or fx and a number of bits, such as fx18; empty for fp32, or what a
  /// row named by `org` has.
  std::string format = "";
  /// Of a model: lattices that its core keeps behind opcodes 5 to 7, 1 to 256; 0: a core without
  /// pages, as those of `rtl` are.
  int pages = 0;
  /// Of a model: most points an axis of such a lattice, 7 to 64. A larger one goes by pages.
  int axis_points = kAxisPoints;
  /// Of a model that pulls back: grids go by rows, as in a core `hwffd_scatter` with ROWS 1
  /// (numerics.md section 11). That is faster, and other bits.
  bool rows = false;
};

/// The names that DeviceChoice::device takes, boards aside.
const std::vector<std::string>& device_kinds();

/// Those of boards, with words in capitals for what names one of them: "serial:PATH",
/// "uio:N", "socket:PATH".
const std::vector<std::string>& board_kinds();

/// The rows of the table, overlapped, that a kind of device has in this build: all for a model,
/// the verilated ones with streams for the RTL, none for the reference, for a serial board the one
/// of its bitstream as it comes, and none for UIO, whose core says what it is.
/// @throws UsageError for an unknown kind
std::vector<std::string> device_rows(const std::string& kind);

/// A device that pulls gradients back, of a kind: the reference, the model of `affine` in fx17, or
/// the simulated core `hwffd_scatter` with the same bits. That evaluates nothing, and counts as
/// saturated each page of sums, of up to 16,384 vertices, to which one that saturated went.
/// @param rows  grids go by rows: DeviceChoice::rows, and a core with ROWS 1, which takes lattices
///   of up to 32 points an axis. The reference, which has but one result, does not look at it.
/// @throws UsageError for an unknown kind, and for `rtl` where no simulated hardware is there
/// @throws Error for a board
std::unique_ptr<Device> make_pull_back_device(const std::string& kind, bool rows = false);

/// @throws UsageError for an unknown device, and for an organization, format or row that it does
///   not have; it lists the devices, organizations or formats that there are
/// @throws Error for a board that does not answer, or has another row than that
std::unique_ptr<Device> make_device(const DeviceChoice& choice);

}  // namespace hwffd
