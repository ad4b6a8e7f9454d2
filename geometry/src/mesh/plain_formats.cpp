#include "mesh/formats.hpp"

namespace hwffd {

const std::vector<MeshFormat>& mesh_formats() {
  static const std::vector<MeshFormat> kFormats{{".obj", read_obj, write_obj},
                                                {".ply", read_ply, write_ply},
                                                {".off", read_off, write_off},
                                                {".stl", read_stl, nullptr}};
  return kFormats;
}

}  // namespace hwffd
