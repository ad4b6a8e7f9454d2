// A page has no files: what geometry/ reads from some, it is told here.
#include "hwffd/error.hpp"
#include "hwffd/lattice/lattice_file.hpp"

namespace hwffd {

LatticeFile read_lattice_file(const std::filesystem::path& path) {
  throw Error("deformation to:" + path.string() +
              ": a page reads no file of that name; drop the lattice on it");
}

}  // namespace hwffd
