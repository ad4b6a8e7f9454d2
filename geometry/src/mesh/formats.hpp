#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mesh/format/document.hpp"
#include "mesh/mesh_writers.hpp"

namespace hwffd {

/// What a program knows of a kind of mesh file.
struct MeshFormat {
  using Read = std::unique_ptr<Document> (*)(const std::filesystem::path&, std::string);
  using Write = Files (*)(const Output&);

  const char* extension;
  Read read;    ///< null: Assimp reads it
  Write write;  ///< null: it is not written
};

/// The formats of the program that this is linked into: all of them, or those of plain_formats.cpp
/// for a target with the property HWFFD_PLAIN_FORMATS (geometry/CMakeLists.txt).
const std::vector<MeshFormat>& mesh_formats();

/// Reads a mesh by one of these readers, and checks what whoever moves it relies on.
/// @param path  of the file; companions (mtllib, buffers) are looked for beside it
/// @throws Error, without the file's name, for what is no such file
std::unique_ptr<Document> read_document(MeshFormat::Read read, const std::filesystem::path& path,
                                        std::string bytes);

/// That of a file by its extension; null where the program has none of it.
const MeshFormat* format_of(const std::filesystem::path& path);

}  // namespace hwffd
