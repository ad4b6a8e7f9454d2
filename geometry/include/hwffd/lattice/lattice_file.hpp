#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// A lattice file is JSON (docs/lattice.md section 3): `hwffd_lattice` 1, `dims` [n_s, n_t, n_u],
/// and either `points`, n_s*n_t*n_u triples with u running fastest, or `shape` ("box", "cylinder",
/// "sphere") with its `origin`, its three `edges` and, but for a box, `inner`. Both may name their
/// `family`; beside `points` may stand those at `rest`.
struct LatticeFile {
  Lattice lattice;
  std::optional<Lattice> rest;   ///< of the same dims, where the lattice is deformed
  std::optional<Family> family;  ///< where the file names it
};

/// @throws Error if the file cannot be read, or what parse_lattice_file throws, with the file's
/// name
LatticeFile read_lattice_file(const std::filesystem::path& path);
/// With the family that evaluates it: the one wanted, else that of the file, else the usual one.
/// @throws Error as above, and for points an axis that whole_dims() refuses that family
LatticeFile read_lattice_file(const std::filesystem::path& path,
                              const std::optional<Family>& wanted);

/// @throws Error, one line that names the entry and the cure, for text that is not JSON, an entry
///   that is missing, unknown or of the wrong kind, and what lattices and shapes refuse
LatticeFile parse_lattice_file(const std::string& text);
/// Its lattice alone.
Lattice parse_lattice(const std::string& text);

/// The file with `points`, in which every double comes back bit for bit; `rest` where there is one
/// with other points, `family` where there is one that is not the usual one.
std::string lattice_text(const LatticeFile& file);
std::string lattice_text(const Lattice& lattice);

/// Writes lattice_text() whole or not at all, see write_files().
/// @throws Error if the file cannot be written
void write_lattice(const std::filesystem::path& path, const LatticeFile& file);
void write_lattice(const std::filesystem::path& path, const Lattice& lattice);

}  // namespace hwffd
