#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "hwffd/model/stream_model.hpp"
#include "inside.hpp"
#include "running_core.hpp"

namespace hwffd::web {

/// Vertices of a mesh, at most: what takes the fastest core some 20 seconds in a browser.
constexpr std::size_t kMostVertices = 2'000'000;

/// The first word of the core that is not the model's.
struct Mismatch {
  std::size_t vertex;
  int word;  ///< 0 to 2: x, y, z; 3: tag and status
  std::uint32_t rtl, model;
};

/// A mesh that has gone through the core.
struct Deformed {
  Points positions;  ///< out of the core, in world coordinates
  std::uint64_t words = 0;
  std::uint64_t mismatches = 0;
  std::optional<Mismatch> first;
  std::uint64_t clocks = 0;        ///< with the loading of the lattice
  std::uint64_t first_result = 0;  ///< the clock in which it came
  double clocks_per_vertex = 0;    ///< between results
  std::uint64_t saturated = 0;     ///< vertices with a coordinate beyond what the format holds
};

/// What stands behind the live page: a mesh in a box lattice, a simulated core that deforms it, and
/// the bit-true model that says what each of its words must be. It is that of one row of the table
/// at a time; mesh and lattice stay when the row changes.
class Engine {
 public:
  /// Takes another core. Throws std::invalid_argument where this build has none of that name.
  void open(const std::string& name);
  /// A mesh at rest, with a lattice at rest around it.
  /// @throws Error if there are no vertices, too many, or some are not finite
  void set_mesh(const Points& positions);
  /// Points an axis, 4 to 16; the lattice is at rest then.
  void set_dims(const Index3& dims);
  /// Control points as they are now, in the order of `Lattice`.
  void set_points(const Points& points);
  /// The lattice at rest, moved as by the option --deform of `hwffd deform`; empty: at rest.
  void set_shape(const std::string& deformation);
  void set_fault(bool on);

  bool has_mesh() const { return box_.has_value(); }
  /// As it is now. Throws Error where there is no mesh.
  const Lattice& lattice() const;
  const Configuration& row() const { return *row_; }

  /// Sends the mesh through core and model and compares all words.
  Deformed deform();

  /// The inside of the core, to go on clock by clock with the mesh as it was deformed last.
  Inside& inside();
  /// Ports recorded from now on, of other cores too.
  void watch(const std::vector<std::string>& names);

 private:
  void rest();
  void check_mesh() const;

  /// How coordinates become words of the stream.
  struct StreamWords {
    WordCodec codec;
    Normalization normalization;
  };
  /// Sends the vertices from `first` to before `end` behind commands, and adds what comes back.
  /// Returns what was sent of them.
  Traffic deform(std::size_t first, std::size_t end, const StreamWords& words,
                 std::vector<Beat> commands, Deformed& deformed);
  /// What goes through an organization that walks: rows of vertices of the lattice that it has.
  Traffic rows(const WordCodec& codec);

  const Configuration* row_ = nullptr;
  std::unique_ptr<RunningCore> core_;
  std::unique_ptr<Inside> inside_;
  std::unique_ptr<model::StreamModel> model_;
  std::vector<std::string> watched_;
  Points positions_;
  std::optional<Box> box_;
  Index3 dims_{4, 4, 4};
  std::optional<Lattice> lattice_;
  std::vector<Embedded> embedded_;
};

}  // namespace hwffd::web
