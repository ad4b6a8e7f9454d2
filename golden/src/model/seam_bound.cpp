#include "hwffd/model/seam_bound.hpp"

#include <cmath>

#include "hwffd/model/organizations.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {
namespace {

bool is_float(const Configuration& row) { return WordCodec(row.format).is_float(); }

}  // namespace

double seam_unit(const Configuration& row) {
  return std::ldexp(1.0, is_float(row) ? -24 : -1 - WordCodec(row.format).weight_fraction());
}

double seam_bound(const Configuration& row) {
  const Organization& organization = organization_of(row);
  return is_float(row) ? organization.seam_float : organization.seam_fixed;
}

}  // namespace hwffd
