// Highway compiles what is between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each kind
// of processor, by including this file again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lattice/contraction.cpp"
#include <hwy/foreach_target.h>
// The order matters.
#include <hwy/highway.h>

#include <algorithm>

#include "lattice/contraction.hpp"

HWY_BEFORE_NAMESPACE();
namespace hwffd::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// a[0]*b(0) + a[1]*b(1) + a[2]*b(2) + a[3]*b(3), from the left.
template <class V, class Value>
HWY_INLINE V sum_of_four(const V* a, const Value& b) {
  V sum = hn::Mul(a[0], b(0));
  for (std::size_t i = 1; i < 4; ++i) sum = hn::MulAdd(a[i], b(i), sum);
  return sum;
}

/// The four functions of one axis at x; c(power, function) is a coefficient.
template <class V, class Value>
HWY_INLINE V polynomial(V x, const Value& c) {
  V value = c(3);
  for (std::size_t power = 3; power-- > 0;) value = hn::MulAdd(value, x, c(power));
  return value;
}

/// As many vertices as there are lanes, from `first`, all of one cell, one a lane.
template <class Real, class D>
HWY_INLINE void contract_lanes(const Contraction<Real>& job, D d, std::size_t first) {
  using V = hn::Vec<D>;
  const std::size_t along_s = job.strides[0];
  const std::size_t along_t = job.strides[1];
  const Real* const corner = job.points + 4 * std::size_t{job.origins[first]};
  V weights[3][4];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const V x = hn::LoadU(d, job.local[axis] + first);
    for (std::size_t l = 0; l < 4; ++l) {
      const Real* const c = job.functions + 16 * axis + l;
      weights[axis][l] = polynomial(x, [&](std::size_t p) { return hn::Set(d, c[4 * p]); });
    }
  }
  V sums[4][3];  // over l and m, of each n
  for (std::size_t m = 0; m < 4; ++m) {
    for (std::size_t at = 0; at < 12; ++at) {
      const Real* const p = corner + 4 * (m * along_t + at / 3) + at % 3;
      const V sum = sum_of_four(
          weights[0], [&, step = 4 * along_s](std::size_t l) { return hn::Set(d, p[l * step]); });
      V& total = sums[at / 3][at % 3];
      total = m == 0 ? hn::Mul(weights[1][0], sum) : hn::MulAdd(weights[1][m], sum, total);
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const V q = sum_of_four(weights[2], [&](std::size_t k) { return sums[k][c]; });
    hn::StoreU(q, d, job.results[c] + first);
  }
}

/// Fewer than that, n of them: the other lanes have copies of the last.
template <class Real, class D>
HWY_INLINE void contract_some_lanes(const Contraction<Real>& job, D d, std::size_t first,
                                    std::size_t n) {
  constexpr std::size_t kMost = hn::MaxLanes(D());
  Real local[3][kMost];
  Real results[3][kMost];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < kMost; ++i) {
      local[axis][i] = job.local[axis][first + HWY_MIN(i, n - 1)];
    }
  }
  contract_lanes(Contraction<Real>{job.points,
                                   job.strides,
                                   job.functions,
                                   job.origins + first,
                                   {local[0], local[1], local[2]},
                                   {results[0], results[1], results[2]},
                                   n},
                 d, 0);
  for (std::size_t c = 0; c < 3; ++c) std::copy_n(results[c], n, job.results[c] + first);
}

/// One vertex; coordinates of four points of a row, or some of them, in the lanes.
template <class Real>
HWY_INLINE void contract_row(const Contraction<Real>& job, std::size_t vertex) {
  const hn::CappedTag<Real, 4> four;
  const hn::CappedTag<Real, 16> d;
  using V = hn::Vec<decltype(d)>;
  using V4 = hn::Vec<decltype(four)>;
  const std::size_t along_s = job.strides[0];
  const std::size_t along_t = job.strides[1];
  const Real* const corner = job.points + 4 * std::size_t{job.origins[vertex]};
  HWY_ALIGN Real weights[12];
  HWY_ALIGN Real sums[16];  // over l and m, of each n
  HWY_ALIGN Real position[4];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const V4 x = hn::Set(four, job.local[axis][vertex]);
    for (std::size_t l = 0; l < 4; l += hn::Lanes(four)) {
      const Real* const c = job.functions + 16 * axis + l;
      hn::Store(polynomial(x, [&](std::size_t p) { return hn::LoadU(four, c + 4 * p); }), four,
                weights + 4 * axis + l);
    }
  }
  V along[2][4];
  for (std::size_t i = 0; i < 8; ++i) along[i / 4][i % 4] = hn::Set(d, weights[i]);
  for (std::size_t part = 0; part < 16; part += hn::Lanes(d)) {
    hn::Store(sum_of_four(along[1],
                          [&](std::size_t m) {
                            const Real* const p = corner + 4 * m * along_t + part;
                            return sum_of_four(along[0], [&](std::size_t l) {
                              return hn::LoadU(d, p + 4 * l * along_s);
                            });
                          }),
              d, sums + part);
  }
  for (std::size_t part = 0; part < 4; part += hn::Lanes(four)) {
    V4 along_u[4];
    for (std::size_t k = 0; k < 4; ++k) along_u[k] = hn::Set(four, weights[8 + k]);
    hn::Store(
        sum_of_four(along_u, [&](std::size_t k) { return hn::Load(four, sums + 4 * k + part); }),
        four, position + part);
  }
  for (std::size_t c = 0; c < 3; ++c) job.results[c][vertex] = position[c];
}

/// Vertices first .. end - 1. Apart from contract_lanes, so that what all share stays in registers.
template <class Real>
HWY_NOINLINE void contract_rows(const Contraction<Real>& job, std::size_t first, std::size_t end) {
  for (std::size_t vertex = first; vertex < end; ++vertex) contract_row(job, vertex);
}

/// Vertices of one cell that follow each other go one a lane, if they fill half of the lanes.
template <class Real>
void contract_all(const Contraction<Real>& job) {
  const hn::ScalableTag<Real> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t waiting = 0;  // the first that is not done; those from there to `first` go by rows
  for (std::size_t first = 0; first < job.count;) {
    const std::size_t most = HWY_MIN(lanes, job.count - first);
    std::size_t n = 1;
    while (n < most && job.origins[first + n] == job.origins[first]) ++n;
    if (2 * n >= lanes) {
      contract_rows(job, waiting, first);
      if (n == lanes) {
        contract_lanes(job, d, first);
      } else {
        contract_some_lanes(job, d, first, n);
      }
      waiting = first + n;
    }
    first += n;
  }
  contract_rows(job, waiting, job.count);
}

void contract_floats(const Contraction<float>& job) { contract_all(job); }
void contract_doubles(const Contraction<double>& job) { contract_all(job); }

}  // namespace hwffd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hwffd {

HWY_EXPORT(contract_floats);
HWY_EXPORT(contract_doubles);

void contract(const Contraction<float>& job) { HWY_DYNAMIC_DISPATCH(contract_floats)(job); }
void contract(const Contraction<double>& job) { HWY_DYNAMIC_DISPATCH(contract_doubles)(job); }

}  // namespace hwffd
#endif
