// Points that stay attached to a lattice, for C.

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>

#include "c_guard.hpp"
#include "c_views.hpp"
#include "hwffd/lattice/carried_normals.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/lattice/weights.hpp"

using namespace hwffd;
using namespace hwffd::c;

struct hwffd_attached {
  Attachment attachment;
};

namespace {

void need_both(const hwffd_attached* attached, const hwffd_lattice* lattice) {
  need(attached, "attached");
  need(lattice, "lattice");
}

std::size_t count_of(const hwffd_attached* attached) {
  return static_cast<std::size_t>(attached->attachment.size());
}

/// The vectors of a view, one for each attached point.
Points vectors(const hwffd_view* view, const char* name, const hwffd_attached* attached) {
  Points read = read_view(view, name);
  if (read.rows() != attached->attachment.size()) {
    throw UsageError(fmt::format("{}: {} vectors; give {}, one for each attached point", name,
                                 read.rows(), attached->attachment.size()));
  }
  check_coordinates(name, read);
  return read;
}

}  // namespace

extern "C" {

hwffd_attached* hwffd_attach(const hwffd_lattice* lattice, const hwffd_view* points) {
  return new_handle<hwffd_attached>([&] {
    need(lattice, "lattice");
    return lattice->attach(read_view(points, "points"));
  });
}

void hwffd_attached_free(hwffd_attached* attached) { delete attached; }

int hwffd_attached_counts(const hwffd_attached* attached, hwffd_counts* counts) {
  return guarded([&] {
    need(attached, "attached");
    need(counts, "counts");
    const EmbeddingSummary& summary = attached->attachment.summary();
    *counts = {summary.points, summary.inside, summary.outside, summary.worst_residual};
  });
}

int hwffd_attached_deform(const hwffd_attached* attached, hwffd_lattice* lattice,
                          const hwffd_view* out) {
  return guarded([&] {
    need_both(attached, lattice);
    check_room(out, "out", count_of(attached));
    write_view(lattice->carry(attached->attachment), out, "out");
  });
}

int hwffd_attached_gradients(const hwffd_attached* attached, const hwffd_lattice* lattice,
                             double* out) {
  return guarded([&] {
    need_both(attached, lattice);
    need(out, "out", count_of(attached));
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    for (const Eigen::Matrix3d& gradient : lattice->gradients(attached->attachment)) {
      Eigen::Map<RowMajor>{out} = gradient;
      out += 9;
    }
  });
}

int hwffd_attached_determinants(const hwffd_attached* attached, const hwffd_lattice* lattice,
                                double* out) {
  return guarded([&] {
    need_both(attached, lattice);
    need(out, "out", count_of(attached));
    for (const Eigen::Matrix3d& gradient : lattice->gradients(attached->attachment)) {
      *out++ = gradient.determinant();
    }
  });
}

int hwffd_attached_normals(const hwffd_attached* attached, const hwffd_lattice* lattice,
                           const hwffd_view* normals, const hwffd_view* out) {
  return guarded([&] {
    need_both(attached, lattice);
    const Points at_rest = vectors(normals, "normals", attached);
    check_room(out, "out", count_of(attached));
    write_view(carried_normals(lattice->gradients(attached->attachment), at_rest), out, "out");
  });
}

size_t hwffd_attached_weight_count(const hwffd_attached* attached) {
  return attached == nullptr ? 0 : weight_count(attached->attachment);
}

int hwffd_attached_weights(const hwffd_attached* attached, int64_t* starts, int32_t* columns,
                           double* values) {
  return guarded([&] {
    need(attached, "attached");
    need(starts, "starts");
    need(columns, "columns", weight_count(attached->attachment));
    need(values, "values", weight_count(attached->attachment));
    const SparseRows rows = weights_of(attached->attachment);
    std::copy(rows.starts.begin(), rows.starts.end(), starts);
    std::copy(rows.columns.begin(), rows.columns.end(), columns);
    std::copy(rows.values.begin(), rows.values.end(), values);
  });
}

int hwffd_attached_unmoved(const hwffd_attached* attached, const hwffd_view* out) {
  return guarded([&] {
    need(attached, "attached");
    write_view(unmoved_part(attached->attachment), out, "out");
  });
}

int hwffd_attached_pull_back(const hwffd_attached* attached, const hwffd_view* gradient,
                             double* out) {
  return guarded([&] {
    need(attached, "attached");
    need(out, "out");
    const Points pulled = pull_back(attached->attachment, vectors(gradient, "gradient", attached));
    std::copy(pulled.data(), pulled.data() + pulled.size(), out);
  });
}

}  // extern "C"
