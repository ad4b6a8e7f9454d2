#include "glu/error.hpp"

#include <map>

namespace hwffd::glu {

const char* error_string(GLenum code) {
  static const std::map<GLenum, const char*> texts{
      {GLU_FFD_INVALID_ENUM, "unknown property, callback, type or primitive"},
      {GLU_FFD_INVALID_VALUE, "value of a property, count or array out of range"},
      {GLU_FFD_INVALID_ORDER, "order below 1 or above 4"},
      {GLU_FFD_TOO_FEW_KNOTS, "fewer knots than twice the order"},
      {GLU_FFD_EMPTY_KNOT_RANGE, "empty range of knots"},
      {GLU_FFD_DECREASING_KNOTS, "decreasing knots"},
      {GLU_FFD_KNOT_MULTIPLICITY, "knot repeated more often than the order"},
      {GLU_FFD_NESTED_VOLUME, "gluBeginVolume within a volume"},
      {GLU_FFD_MISSING_BEGIN, "not within gluBeginVolume and gluEndVolume"},
      {GLU_FFD_INVALID_STRIDE, "stride negative, or too small for a vertex"},
      {GLU_FFD_NULL_CONTROL, "no coordinates, no control points, no normals or no elements"},
      {GLU_FFD_INVALID_INDEX,
       "vertex of a cell that the control points do not have, or element beyond the vertices"},
      {GLU_FFD_TOO_MANY_CELLS, "more than 13 cells along an axis"},
      {GLU_FFD_MISSING_DATA,
       "volume without positions, or with an attribute twice or of another count"},
      {GLU_FFD_DEVICE_FAILED, "no such device, or it does not take these numbers"}};
  const auto it = texts.find(code);
  return it == texts.end() ? nullptr : it->second;
}

}  // namespace hwffd::glu
