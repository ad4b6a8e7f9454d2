#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/points.hpp"
#include "mesh/format/content.hpp"
#include "mesh/mesh_writers.hpp"

namespace hwffd {

/// How a mesh stands now, for the file that it was read from.
struct Edit {
  const Points& positions;                 ///< of welded vertices
  const std::vector<std::uint32_t>& weld;  ///< vertex of the file -> welded vertex
  /// As in the content that was read, and behind its rows those of corners that shared a row and do
  /// no more. A value that did not change has the bits that were read.
  const Values<3>& normals;
  /// Extra row of normals (the first has number 0) -> the row that it shared.
  const std::vector<std::uint32_t>& normal_origins;
  const Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor>& tangents;
  bool turned;  ///< whether the corners of faces are to be reversed, the first staying first

  Eigen::RowVector3d position(std::size_t vertex) const { return positions.row(weld[vertex]); }
};

/// A mesh file that stays as it is but for what moves: it knows where in its bytes each number
/// stands.
class Document {
 public:
  Document() = default;
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;
  virtual ~Document() = default;

  /// What was read, for one taker: the document does not need it.
  Content& content() { return content_; }

  /// The files beside it that were read too: no output may take their place.
  const std::vector<std::filesystem::path>& companions() const { return companions_; }

  /// Whether a file of this name has the format (and kind of container) that was read.
  virtual bool is_of(const std::filesystem::path& path) const = 0;

  /// The files with the mesh as it stands now: all other bytes are those that were read. Names that
  /// refer to other files still find them from the folder of `path`.
  /// @throws Error, without the file's name, for what the file's types cannot hold
  virtual Files edited(const Edit& edit, const std::filesystem::path& path) const = 0;

 protected:
  Content content_;
  std::vector<std::filesystem::path> companions_;
};

/// The readers, one a format, each in its own file.
std::unique_ptr<Document> read_obj(const std::filesystem::path& path, std::string bytes);
std::unique_ptr<Document> read_off(const std::filesystem::path& path, std::string bytes);
std::unique_ptr<Document> read_stl(const std::filesystem::path& path, std::string bytes);
std::unique_ptr<Document> read_ply(const std::filesystem::path& path, std::string bytes);
std::unique_ptr<Document> read_gltf(const std::filesystem::path& path, std::string bytes);

}  // namespace hwffd
