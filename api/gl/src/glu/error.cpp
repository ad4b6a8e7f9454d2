#include "glu/error.hpp"

namespace hwffd::glu {

const char* error_string(GLenum code) {
  switch (code) {
    case GLU_FFD_INVALID_ENUM:
      return "unknown property, callback, type or primitive";
    case GLU_FFD_INVALID_VALUE:
      return "value of a property, count or array out of range";
    case GLU_FFD_INVALID_ORDER:
      return "order below 1 or above 4";
    case GLU_FFD_TOO_FEW_KNOTS:
      return "fewer knots than twice the order";
    case GLU_FFD_EMPTY_KNOT_RANGE:
      return "empty range of knots";
    case GLU_FFD_DECREASING_KNOTS:
      return "decreasing knots";
    case GLU_FFD_KNOT_MULTIPLICITY:
      return "knot repeated more often than the order";
    case GLU_FFD_NESTED_VOLUME:
      return "gluBeginVolume within a volume";
    case GLU_FFD_MISSING_BEGIN:
      return "not within gluBeginVolume and gluEndVolume";
    case GLU_FFD_INVALID_STRIDE:
      return "stride negative, or too small for a vertex";
    case GLU_FFD_NULL_CONTROL:
      return "no coordinates, no control points, no normals or no elements";
    case GLU_FFD_INVALID_INDEX:
      return "vertex of a cell that the control points do not have, or element beyond the vertices";
    case GLU_FFD_TOO_MANY_CELLS:
      return "more than 13 cells along an axis";
    case GLU_FFD_MISSING_DATA:
      return "volume without positions, or with an attribute twice or of another count";
    case GLU_FFD_DEVICE_FAILED:
      return "no such device, or it does not take these numbers";
    default:
      return nullptr;
  }
}

}  // namespace hwffd::glu
