#include "hwffd/registration/pyramid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

std::array<bool, 3> axes_to_halve(const Index3& counts) {
  std::array<bool, 3> result{};
  for (std::size_t a = 0; a < 3; ++a) result[a] = (counts[a] + 1) / 2 >= kFewestHalved;
  return result;
}

bool any(const std::array<bool, 3>& axes) { return axes[0] || axes[1] || axes[2]; }

Index3 halved_counts(Index3 counts, const std::array<bool, 3>& axes) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (axes[a]) counts[a] = (counts[a] + 1) / 2;
  }
  return counts;
}

/// Numbers as [outer][n][inner], smoothed and halved along n; read(at) is one of them.
template <class Read>
std::vector<float> halved_along(const Read& read, std::size_t outer, std::size_t n,
                                std::size_t inner) {
  const std::size_t half = (n + 1) / 2;
  std::vector<float> result(outer * half * inner);
  for (std::size_t o = 0; o < outer; ++o) {
    for (std::size_t m = 0; m < half; ++m) {
      // Rows two before the centre to two behind it, the outermost ones again beyond the ends.
      std::size_t rows[5];
      for (std::size_t r = 0; r < 5; ++r) {
        const std::size_t at = std::max<std::size_t>(2 * m + r, 2) - 2;
        rows[r] = (o * n + std::min(at, n - 1)) * inner;
      }
      float* const out = result.data() + (o * half + m) * inner;
      for (std::size_t i = 0; i < inner; ++i) {
        const float ends = read(rows[0] + i) + read(rows[4] + i);
        const float sides = read(rows[1] + i) + read(rows[3] + i);
        out[i] = (ends + 4.0F * sides + 6.0F * read(rows[2] + i)) * 0.0625F;
      }
    }
  }
  return result;
}

/// The same along all axes wanted.
template <class Read>
std::vector<float> halved_numbers(const Read& read, Index3 counts,
                                  const std::array<bool, 3>& axes) {
  std::vector<float> result;
  bool first = true;
  for (std::size_t a = 0; a < 3; ++a) {
    if (!axes[a]) continue;
    std::size_t inner = 1;
    std::size_t outer = 1;
    for (std::size_t b = 0; b < a; ++b) inner *= static_cast<std::size_t>(counts[b]);
    for (std::size_t b = a + 1; b < 3; ++b) outer *= static_cast<std::size_t>(counts[b]);
    const auto n = static_cast<std::size_t>(counts[a]);
    if (first) {
      result = halved_along(read, outer, n, inner);
    } else {
      const float* const numbers = result.data();
      result = halved_along([=](std::size_t at) { return numbers[at]; }, outer, n, inner);
    }
    first = false;
    counts[a] = (counts[a] + 1) / 2;
  }
  return result;
}

/// Numbers as [outer][n][inner], smoothed in place along n by (1 2 1)/4.
void smooth_along(std::vector<float>& numbers, std::size_t outer, std::size_t n,
                  std::size_t inner) {
  std::vector<float> before(inner);  // the row before, as it was
  for (std::size_t o = 0; o < outer; ++o) {
    float* row = numbers.data() + o * n * inner;
    std::copy(row, row + inner, before.begin());
    for (std::size_t m = 0; m < n; ++m, row += inner) {
      const float* const next = m + 1 < n ? row + inner : row;
      for (std::size_t i = 0; i < inner; ++i) {
        const float now = row[i];
        row[i] = (before[i] + 2.0F * now + next[i]) * 0.25F;
        before[i] = now;
      }
    }
  }
}

/// The same along all axes.
std::vector<float> smooth_numbers(std::vector<float> numbers, const Index3& counts) {
  std::size_t inner = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto n = static_cast<std::size_t>(counts[a]);
    smooth_along(numbers, numbers.size() / n / inner, n, inner);
    inner *= n;
  }
  return numbers;
}

std::vector<std::uint8_t> halved_mask(const Volume& volume, const Index3& counts,
                                      const std::array<bool, 3>& axes) {
  std::vector<std::uint8_t> result;
  if (volume.mask() == nullptr) return result;
  const auto step = [&](std::size_t a) { return axes[a] ? std::size_t{2} : std::size_t{1}; };
  const auto along_i = static_cast<std::size_t>(volume.counts()[0]);
  const auto along_j = static_cast<std::size_t>(volume.counts()[1]);
  for (int k = 0; k < counts[2]; ++k) {
    for (int j = 0; j < counts[1]; ++j) {
      const std::size_t row = (static_cast<std::size_t>(k) * step(2) * along_j +
                               static_cast<std::size_t>(j) * step(1)) *
                              along_i;
      for (int i = 0; i < counts[0]; ++i) {
        result.push_back(volume.mask()[row + static_cast<std::size_t>(i) * step(0)]);
      }
    }
  }
  return result;
}

}  // namespace

Volume halved(const Volume& volume, const std::array<bool, 3>& axes) {
  const float* const values = volume.values();
  const std::uint8_t* const mask = volume.mask();
  const Index3 counts = halved_counts(volume.counts(), axes);
  std::vector<std::uint8_t> mask_of_half = halved_mask(volume, counts, axes);
  std::vector<float> smoothed;
  if (!any(axes)) {
    smoothed.assign(values, values + volume.size());
  } else if (mask == nullptr) {
    smoothed = halved_numbers([=](std::size_t at) { return values[at]; }, volume.counts(), axes);
  } else {
    const auto counting = [=](std::size_t at) { return mask[at] != 0 ? 1.0F : 0.0F; };
    smoothed = halved_numbers([=](std::size_t at) { return mask[at] != 0 ? values[at] : 0.0F; },
                              volume.counts(), axes);
    const std::vector<float> weights = halved_numbers(counting, volume.counts(), axes);
    bool empty = true;
    for (std::size_t at = 0; at < smoothed.size(); ++at) {
      if (weights[at] > 0.0F) smoothed[at] /= weights[at];
      empty = empty && mask_of_half[at] == 0;
    }
    if (empty) {
      throw Error("mask of the " + volume.name() +
                  ": nothing of it is left at half the resolution; give fewer levels");
    }
  }
  AffineMap to_point = volume.to_point();
  for (std::size_t a = 0; a < 3; ++a) {
    for (auto& row : to_point.linear) row[a] *= axes[a] ? 2 : 1;
  }
  return {volume.name(), counts, std::move(smoothed), to_point, std::move(mask_of_half)};
}

Volume smoothed(const Volume& volume) {
  const float* const values = volume.values();
  const std::uint8_t* const mask = volume.mask();
  const Index3& counts = volume.counts();
  std::vector<float> smooth(values, values + volume.size());
  if (mask == nullptr) {
    return {volume.name(), counts, smooth_numbers(std::move(smooth), counts), volume.to_point()};
  }
  std::vector<float> weights(volume.size());
  for (std::size_t at = 0; at < weights.size(); ++at) {
    weights[at] = mask[at] != 0 ? 1.0F : 0.0F;
    if (mask[at] == 0) smooth[at] = 0.0F;
  }
  smooth = smooth_numbers(std::move(smooth), counts);
  weights = smooth_numbers(std::move(weights), counts);
  for (std::size_t at = 0; at < weights.size(); ++at) {
    if (weights[at] > 0.0F) smooth[at] /= weights[at];
  }
  return {volume.name(), counts, std::move(smooth), volume.to_point(),
          std::vector<std::uint8_t>(mask, mask + volume.size())};
}

Volume filled(const Volume& volume) {
  const std::uint8_t* const mask = volume.mask();
  if (mask == nullptr) return volume;
  const Volume smooth = smoothed(volume);
  std::vector<float> values(smooth.values(), smooth.values() + volume.size());
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (mask[at] != 0) values[at] = volume.values()[at];
  }
  return {volume.name(), volume.counts(), std::move(values), volume.to_point(),
          std::vector<std::uint8_t>(mask, mask + volume.size())};
}

int most_levels(const Index3& counts) {
  int levels = 1;
  Index3 now = counts;
  for (auto axes = axes_to_halve(now); any(axes); axes = axes_to_halve(now)) {
    now = halved_counts(now, axes);
    ++levels;
  }
  return levels;
}

std::vector<PyramidLevel> pyramid(const Volume& volume, int levels) {
  const int most = most_levels(volume.counts());
  if (levels < 1 || levels > most) {
    throw Error(fmt::format(
        "levels {}: the {} of {} x {} x {} voxels has 1 to {}; give one of these", levels,
        volume.name(), volume.counts()[0], volume.counts()[1], volume.counts()[2], most));
  }
  std::vector<PyramidLevel> result{{volume, {0, 0, 0}}};
  while (static_cast<int>(result.size()) < levels) {
    const PyramidLevel& last = result.back();
    const auto axes = axes_to_halve(last.volume.counts());
    std::array<int, 3> halvings = last.halvings;
    for (std::size_t a = 0; a < 3; ++a) halvings[a] += axes[a] ? 1 : 0;
    result.push_back({halved(last.volume, axes), halvings});
  }
  std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace hwffd
