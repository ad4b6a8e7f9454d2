#pragma once

#include <optional>
#include <vector>

#include "hwffd/lattice/bezier_volume.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd {

enum class EmbeddingStatus {
  kInside,       ///< eq. (1) gives the point back
  kOutside,      ///< proved: no cell has the point
  kNotConverged  ///< neither found nor excluded
};

/// Where a point lies in a lattice, and how well that is known.
struct Embedding {
  Embedded at;
  EmbeddingStatus status = EmbeddingStatus::kOutside;
  double residual = 0.0;  ///< distance from the point to eq. (1) at `at`, in object space
  int iterations = 0;     ///< Newton steps, in all cells tried; 0 for boxes
};

/// Whether points do not lie in one plane, to within 1e-9 of their extent.
bool span_volume(const Points& points);

/// Embeds points in a lattice of any shape (paper, section 2), with uniform cubic B-splines or
/// another family of blending functions.
///
/// Boxes are recognized (in families that are regular()) and embedded by their affine map
/// (Box::embed). In any other lattice eq. (2)
/// is solved by Newton-Raphson in double, from s = t = u = 0.5, in the cells whose control points
/// in Bernstein form surround the point. Where that finds nothing, these cells are bisected: parts
/// whose hull excludes the point go, Newton starts again in the middle of the others, until the
/// point is found or no part is left.
///
/// A point counts as inside if it is within 1e-12 of size() of a point of the cells; far from the
/// origin, within the rounding of coordinates that large (4.4e-16 of them). A point that
/// several cells share is put into one of them, in a folded lattice into one of its places
/// (check_folds() tells). Outside, a box gives coordinates beyond its cells that eq. (1) takes
/// back to the point; other lattices give the point of a cell nearby that lies close, with the
/// distance as residual.
class Embedder {
 public:
  /// @throws Error if the points do not span_volume()
  explicit Embedder(Lattice lattice, const Family& family = {});

  const Lattice& lattice() const { return lattice_; }
  const Family& family() const { return family_; }
  /// Whether the lattice is a box.
  bool affine() const { return box_.has_value(); }
  /// The largest extent along x, y or z of the cells, as their Bernstein coefficients bound them.
  double size() const { return size_; }

  /// A point that is not finite or beyond kLargestCoordinate is outside, its residual infinite.
  Embedding embed(const Point& point) const;
  /// embed() for every row of points, n x 3, on all threads (on_threads.hpp).
  std::vector<Embedding> embed(const Points& points) const;

  /// Eq. (1) at an embedding: the point back.
  Point point(const Embedded& at) const;

 private:
  /// One cell; its points are relative to centre_, so that a lattice far away loses no digits.
  struct Cell {
    Index3 index;
    Support support;
    BezierVolume hull;
    Point low, high, middle;
  };

  /// Embeds `count` rows of points from `first` on, of a box.
  void embed_in_box(const Points& points, std::size_t first, std::size_t count,
                    Embedding* to) const;
  std::vector<const Cell*> candidates(const Point& point) const;
  Embedding embed_by_newton(const Point& point) const;
  Embedding outside(const Point& point) const;

  Lattice lattice_;
  Family family_;
  std::optional<Box> box_;
  std::optional<LatticeEvaluator<double>> evaluator_;  ///< of a box, relative to centre_
  Oracle oracle_;
  Point centre_;
  double size_ = 0.0;
  double tolerance_ = 0.0;
  std::vector<Cell> cells_;
};

/// Counts over many points.
struct EmbeddingSummary {
  std::size_t points = 0;
  std::size_t inside = 0;
  std::size_t outside = 0;
  std::size_t not_converged = 0;
  double worst_residual = 0.0;   ///< of the points inside
  double mean_iterations = 0.0;  ///< of the points inside
};

EmbeddingSummary summarize(const std::vector<Embedding>& embeddings);
/// Of the points of both.
EmbeddingSummary joined(const EmbeddingSummary& a, const EmbeddingSummary& b);

}  // namespace hwffd
