#include "hwffd/registration/sampling.hpp"

#include <algorithm>

#include "clones.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kAtOnce = 64;  // places whose corners are in the fastest memory

/// What of a volume a kernel needs.
struct Grid3 {
  const float* values;
  const std::uint8_t* mask;
  std::int32_t counts[3];
};

struct Chunk {
  std::int32_t offset[kAtOnce];  ///< of the lower corner
  float local[3][kAtOnce];       ///< between it and the upper one
  float within[3][kAtOnce];      ///< 1 between the outermost centres, else 0
  float counts[kAtOnce];         ///< 1 in the volume, else 0
  float corner[8][kAtOnce];      ///< bit a of the number: upper along axis a
};

/// The lower corner and the rest, along one axis.
HWFFD_CLONES void locate(std::size_t n, const double* __restrict x, std::int32_t count,
                         std::int32_t stride, std::int32_t* __restrict offset,
                         float* __restrict local, float* __restrict within,
                         float* __restrict counts) {
  const double last = count - 1;
  const double end = count - 0.5;
  const std::int32_t most = std::max(count - 2, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const double at = x[i];
    const double low = at > 0.0 ? at : 0.0;
    const double clamped = low < last ? low : last;
    const auto truncated = static_cast<std::int32_t>(clamped);
    const std::int32_t cell = truncated < most ? truncated : most;
    offset[i] += cell * stride;
    local[i] = static_cast<float>(clamped - static_cast<double>(cell));
    within[i] = clamped == at ? 1.0F : 0.0F;
    const float here = at >= -0.5 ? 1.0F : 0.0F;
    const float there = at < end ? here : 0.0F;
    counts[i] *= there;
  }
}

HWFFD_CLONES void interpolate(std::size_t n, const Chunk& chunk, float* __restrict values) {
  const float* __restrict const x = chunk.local[0];
  const float* __restrict const y = chunk.local[1];
  const float* __restrict const z = chunk.local[2];
  for (std::size_t i = 0; i < n; ++i) {
    const auto& c = chunk.corner;
    const float a = c[0][i] + x[i] * (c[1][i] - c[0][i]);
    const float b = c[2][i] + x[i] * (c[3][i] - c[2][i]);
    const float d = c[4][i] + x[i] * (c[5][i] - c[4][i]);
    const float e = c[6][i] + x[i] * (c[7][i] - c[6][i]);
    const float low = a + y[i] * (b - a);
    const float high = d + y[i] * (e - d);
    values[i] = chunk.counts[i] * (low + z[i] * (high - low));
  }
}

HWFFD_CLONES void differentiate(std::size_t n, const Chunk& chunk, double* __restrict gx,
                                double* __restrict gy, double* __restrict gz) {
  const float* __restrict const x = chunk.local[0];
  const float* __restrict const y = chunk.local[1];
  const float* __restrict const z = chunk.local[2];
  for (std::size_t i = 0; i < n; ++i) {
    const auto& c = chunk.corner;
    const float xa = c[1][i] - c[0][i];
    const float xb = c[3][i] - c[2][i];
    const float xd = c[5][i] - c[4][i];
    const float xe = c[7][i] - c[6][i];
    const float x_low = xa + y[i] * (xb - xa);
    const float x_high = xd + y[i] * (xe - xd);
    const float a = c[0][i] + x[i] * xa;
    const float b = c[2][i] + x[i] * xb;
    const float d = c[4][i] + x[i] * xd;
    const float e = c[6][i] + x[i] * xe;
    const float y_low = b - a;
    const float y_high = e - d;
    const float z_low = a + y[i] * y_low;
    const float z_high = d + y[i] * y_high;
    const float counts = chunk.counts[i];
    gx[i] = static_cast<double>(counts * chunk.within[0][i] * (x_low + z[i] * (x_high - x_low)));
    gy[i] = static_cast<double>(counts * chunk.within[1][i] * (y_low + z[i] * (y_high - y_low)));
    gz[i] = static_cast<double>(counts * chunk.within[2][i] * (z_high - z_low));
  }
}

/// The nearest voxel, half a voxel upwards, of `count`; the place is in the volume.
std::int32_t nearest(double at, std::int32_t count) {
  const double upper = at + 0.5;  // which may round to the count
  return std::min(static_cast<std::int32_t>(upper), count - 1);
}

}  // namespace

LinearSampler::LinearSampler(const Volume& volume) : volume_(volume) {}

template <bool kGradients>
std::size_t LinearSampler::run(std::size_t n, const double* x, const double* y, const double* z,
                               float* values, std::uint8_t* inside, double* gx, double* gy,
                               double* gz) const {
  const Index3& counts = volume_.counts();
  const std::int32_t row = counts[0];
  const std::int32_t slice = counts[0] * counts[1];
  const std::size_t along_x = counts[0] > 1 ? 1 : 0;
  const std::size_t along_y = counts[1] > 1 ? static_cast<std::size_t>(row) : 0;
  const std::size_t along_z = counts[2] > 1 ? static_cast<std::size_t>(slice) : 0;
  const std::uint8_t* const mask = volume_.mask();
  Chunk chunk;
  std::size_t result = 0;
  for (std::size_t first = 0; first < n; first += kAtOnce) {
    const std::size_t some = std::min(kAtOnce, n - first);
    std::fill_n(chunk.offset, some, 0);
    std::fill_n(chunk.counts, some, 1.0F);
    locate(some, x + first, counts[0], 1, chunk.offset, chunk.local[0], chunk.within[0],
           chunk.counts);
    locate(some, y + first, counts[1], row, chunk.offset, chunk.local[1], chunk.within[1],
           chunk.counts);
    locate(some, z + first, counts[2], slice, chunk.offset, chunk.local[2], chunk.within[2],
           chunk.counts);
    if (mask != nullptr) {
      for (std::size_t i = 0; i < some; ++i) {
        if (chunk.counts[i] == 0.0F) continue;
        const std::int32_t at = nearest(x[first + i], counts[0]) +
                                row * nearest(y[first + i], counts[1]) +
                                slice * nearest(z[first + i], counts[2]);
        if (mask[at] == 0) chunk.counts[i] = 0.0F;
      }
    }
    for (std::size_t i = 0; i < some; ++i) {
      const float* const p = volume_.values() + chunk.offset[i];
      const float* const q = p + along_z;
      chunk.corner[0][i] = p[0];
      chunk.corner[1][i] = p[along_x];
      chunk.corner[2][i] = p[along_y];
      chunk.corner[3][i] = p[along_y + along_x];
      chunk.corner[4][i] = q[0];
      chunk.corner[5][i] = q[along_x];
      chunk.corner[6][i] = q[along_y];
      chunk.corner[7][i] = q[along_y + along_x];
    }
    for (std::size_t i = 0; i < some; ++i) {
      const std::uint8_t in = chunk.counts[i] != 0.0F ? 1 : 0;
      inside[first + i] = in;
      result += in;
    }
    interpolate(some, chunk, values + first);
    if constexpr (kGradients) differentiate(some, chunk, gx + first, gy + first, gz + first);
  }
  return result;
}

std::size_t LinearSampler::values(std::size_t n, const double* x, const double* y, const double* z,
                                  float* values, std::uint8_t* inside) const {
  return run<false>(n, x, y, z, values, inside, nullptr, nullptr, nullptr);
}

std::size_t LinearSampler::gradients(std::size_t n, const double* x, const double* y,
                                     const double* z, float* values, std::uint8_t* inside,
                                     double* gx, double* gy, double* gz) const {
  return run<true>(n, x, y, z, values, inside, gx, gy, gz);
}

}  // namespace hwffd
