#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "c_guard.hpp"
#include "c_views.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/on_threads.hpp"

using namespace hwffd;
using namespace hwffd::c;

namespace hwffd::c {
namespace {

thread_local std::string last_error;

}  // namespace

void keep_error(const char* text) noexcept {
  try {
    last_error = text;
  } catch (const std::bad_alloc&) {
    last_error.clear();
  }
}

}  // namespace hwffd::c

namespace {

Points copied(const double* points, std::size_t n) {
  if (n > kMostPoints) {
    throw UsageError(fmt::format("n: {} points; give at most {}", n, kMostPoints));
  }
  return Eigen::Map<const Points>(points, static_cast<Eigen::Index>(n), 3);
}

void copy_out(const Points& points, double* out) {
  std::copy(points.data(), points.data() + points.size(), out);
}

Lattice checked_lattice(const int dims[3], const double* points) {
  need(dims, "dims");
  need(points, "points");
  const Index3 counts{dims[0], dims[1], dims[2]};
  Lattice::check_dims(counts);
  return Lattice(counts, copied(points, static_cast<std::size_t>(dims[0]) * dims[1] * dims[2]));
}

std::vector<Embedded> places_of(const hwffd_embedding* embeddings, std::size_t n) {
  std::vector<Embedded> places(n);
  for (std::size_t i = 0; i < n; ++i) {
    const hwffd_embedding& e = embeddings[i];
    places[i].cell = {e.cell[0], e.cell[1], e.cell[2]};
    places[i].local = Eigen::Map<const Eigen::Vector3d>(e.local);
  }
  return places;
}

int status_of(EmbeddingStatus status) {
  switch (status) {
    case EmbeddingStatus::kInside:
      return HWFFD_INSIDE;
    case EmbeddingStatus::kOutside:
      return HWFFD_OUTSIDE;
    case EmbeddingStatus::kNotConverged:
      break;
  }
  return HWFFD_NOT_CONVERGED;
}

}  // namespace

extern "C" {

const char* hwffd_version(void) { return HWFFD_VERSION; }

void hwffd_set_threads(size_t count) { set_thread_count(count); }

const char* hwffd_error(void) { return last_error.c_str(); }

hwffd_lattice* hwffd_lattice_new(const int dims[3], const double* points) {
  return new_handle<hwffd_lattice>([&] { return checked_lattice(dims, points); });
}

hwffd_lattice* hwffd_lattice_read(const char* path) {
  return new_handle<hwffd_lattice>([&] {
    need(path, "path");
    return DeformableLattice::read(path);
  });
}

hwffd_lattice* hwffd_lattice_around(const char* shape, const int dims[3], const double* points,
                                    size_t n) {
  return new_handle<hwffd_lattice>([&] {
    need(shape, "shape");
    need(points, "points", n);
    const Index3 counts = dims == nullptr ? usual_dims(shape) : Index3{dims[0], dims[1], dims[2]};
    return lattice_around(shape, copied(points, n), counts);
  });
}

void hwffd_lattice_free(hwffd_lattice* lattice) { delete lattice; }

int hwffd_lattice_dims(const hwffd_lattice* lattice, int dims[3]) {
  return guarded([&] {
    need(lattice, "lattice");
    need(dims, "dims");
    const Index3& counts = lattice->rest().dims();
    std::copy(counts.begin(), counts.end(), dims);
  });
}

int hwffd_lattice_family(hwffd_lattice* lattice, const char* family) {
  return guarded([&] {
    need(lattice, "lattice");
    need(family, "family");
    lattice->set_family(Family::parse(family));
  });
}

int hwffd_lattice_points(const hwffd_lattice* lattice, double* points) {
  return guarded([&] {
    need(lattice, "lattice");
    need(points, "points");
    copy_out(lattice->deformed().points(), points);
  });
}

int hwffd_lattice_move(hwffd_lattice* lattice, const double* points) {
  return guarded([&] {
    need(lattice, "lattice");
    need(points, "points");
    lattice->move(copied(points, static_cast<std::size_t>(lattice->rest().points().rows())));
  });
}

int hwffd_lattice_deform(hwffd_lattice* lattice, const char* deformation) {
  return guarded([&] {
    need(lattice, "lattice");
    need(deformation, "deformation");
    lattice->deform(deformation);
  });
}

int hwffd_lattice_device(hwffd_lattice* lattice, const char* device, const char* organization,
                         const char* format) {
  return guarded([&] {
    need(lattice, "lattice");
    need(device, "device");
    DeviceChoice choice;
    choice.device = device;
    if (organization != nullptr) choice.org = organization;
    if (format != nullptr) choice.format = format;
    lattice->set_device(choice);
  });
}

int hwffd_lattice_outside(hwffd_lattice* lattice, const char* outside) {
  return guarded([&] {
    need(lattice, "lattice");
    need(outside, "outside");
    lattice->set_outside(outside);
  });
}

int hwffd_embed(const hwffd_lattice* lattice, const double* points, size_t n,
                hwffd_embedding* out) {
  return guarded([&] {
    need(lattice, "lattice");
    need(points, "points", n);
    need(out, "out", n);
    const std::vector<Embedding> embeddings = lattice->embed(copied(points, n));
    for (size_t i = 0; i < n; ++i) {
      const Embedding& e = embeddings[i];
      out[i] = {{e.at.cell[0], e.at.cell[1], e.at.cell[2]},
                status_of(e.status),
                {e.at.local[0], e.at.local[1], e.at.local[2]},
                e.residual};
    }
  });
}

int hwffd_evaluate(hwffd_lattice* lattice, const hwffd_embedding* embeddings, size_t n,
                   double* out) {
  return guarded([&] {
    need(lattice, "lattice");
    need(embeddings, "embeddings", n);
    need(out, "out", n);
    copy_out(lattice->evaluate(places_of(embeddings, n)), out);
  });
}

int hwffd_pull_back(hwffd_lattice* lattice, const char* device, const hwffd_embedding* embeddings,
                    size_t n, const double* gradient, double* out) {
  return guarded([&] {
    need(lattice, "lattice");
    need(embeddings, "embeddings", n);
    need(gradient, "gradient", n);
    need(out, "out");
    copy_out(lattice->pull_back(places_of(embeddings, n), copied(gradient, n),
                                device == nullptr ? "" : device),
             out);
  });
}

int hwffd_deform(hwffd_lattice* lattice, const double* points, size_t n, double* out) {
  return guarded([&] {
    need(lattice, "lattice");
    need(points, "points", n);
    need(out, "out", n);
    copy_out(lattice->carry(copied(points, n)), out);
  });
}

int hwffd_deform_view(hwffd_lattice* lattice, const hwffd_view* points, const hwffd_view* out) {
  return guarded([&] {
    need(lattice, "lattice");
    const Points at_rest = read_view(points, "points");
    check_room(out, "out", static_cast<std::size_t>(at_rest.rows()));
    write_view(lattice->carry(at_rest), out, "out");
  });
}

size_t hwffd_outside(const hwffd_lattice* lattice) {
  return lattice == nullptr ? 0 : lattice->summary().outside;
}

}  // extern "C"
