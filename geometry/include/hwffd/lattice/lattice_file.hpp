#pragma once

#include <filesystem>
#include <string>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// A lattice file is JSON (docs/lattice.md section 3): `hwffd_lattice` 1, `dims` [n_s, n_t, n_u],
/// and either `points`, n_s*n_t*n_u triples with u running fastest, or `shape` ("box", "cylinder",
/// "sphere") with its `origin`, its three `edges` and, but for a box, `inner`.

/// @throws Error if the file cannot be read, or what parse_lattice throws, with the file's name
Lattice read_lattice(const std::filesystem::path& path);

/// @throws Error, one line that names the entry and the cure, for text that is not JSON, an entry
///   that is missing, unknown or of the wrong kind, and what lattices and shapes refuse
Lattice parse_lattice(const std::string& text);

/// The file with `points`, in which every double comes back bit for bit.
std::string lattice_text(const Lattice& lattice);

/// Writes lattice_text() whole or not at all, see write_files().
/// @throws Error if the file cannot be written
void write_lattice(const std::filesystem::path& path, const Lattice& lattice);

}  // namespace hwffd
