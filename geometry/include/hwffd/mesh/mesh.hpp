#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hwffd/points.hpp"

struct aiScene;

namespace hwffd {

class Document;
class FollowingNormals;
class FollowingTangents;
struct Content;
struct ContentScene;
struct ReadScene;

/// A polygon mesh, or a cloud of points, whose vertices can be moved. It keeps the whole scene of
/// the file (faces, texture coordinates, colours, materials, groups) and shows each distinct
/// position once: vertices that a file repeats along smoothing groups or texture seams are welded
/// by exact equality, over all parts of the scene. Welding is for those who move vertices: files
/// are written with the vertices that were read, in their order.
///
/// A mesh that is saved in the format that it was read from is that file, edited: positions and
/// normals are replaced where they changed, and every other byte is as it was. This holds for obj,
/// ply, off, stl, gltf and glb (these two are one); edits() tells.
///
/// Coordinates are those of the scene with its node transforms applied. A 3ds file is taken as
/// written, y up, without the turn that Assimp puts on its root, and a dae file in its own unit and
/// with its own axis up.
/// In other formats node transforms end as identity and an instanced part becomes one part an
/// instance; animations, bones, morph targets, cameras and lights are dropped, since they do not
/// follow the deformation.
class Mesh {
 public:
  /// Vertex indices of one triangle, counterclockwise seen from outside.
  using Triangle = std::array<std::uint32_t, 3>;

  /// Reads a mesh file in any format that Assimp knows. Of a 3ds file without keyframes the names
  /// of objects are lost. Files are read in a child process, with limits of memory and time that
  /// grow with the file: a reader that crashes or does not end is an Error as any other.
  /// @throws Error: file missing or unreadable, not a mesh, no vertices, a coordinate that is not
  ///   finite, or a face that refers to a vertex that is not there.
  static Mesh load(const std::filesystem::path& path);

  /// A closed model of 3,072 vertices (a tube along a trefoil knot, about 6 units wide) that needs
  /// no file.
  static Mesh procedural();

  /// Whether save() knows the format that the extension names.
  static bool can_save(const std::filesystem::path& path);
  /// @throws UsageError, which lists the formats, if it does not
  static void check_format(const std::filesystem::path& path);

  /// What build() makes a mesh of: triangles of one material.
  struct Part {
    std::string name;             ///< of part and material
    std::array<float, 3> colour;  ///< diffuse: red, green, blue, 0 to 1
    Points positions;             ///< n x 3
    std::vector<Triangle> triangles;
  };

  /// A mesh made in memory. Normals are smooth over each part (area-weighted means over the faces
  /// at a vertex): where an edge is to be hard, parts repeat its points.
  /// @throws Error if there is no part, or one without triangles, with a coordinate that is not a
  ///   finite binary32 number or a triangle that refers to a point that is not there
  static Mesh build(std::string name, const std::vector<Part>& parts);

  Mesh(Mesh&& other) noexcept;
  Mesh& operator=(Mesh&& other) noexcept;
  ~Mesh();

  /// The file's name without its folder, or "procedural".
  const std::string& name() const { return name_; }

  /// Number of welded vertices: rows of positions().
  std::size_t vertex_count() const { return static_cast<std::size_t>(positions_.rows()); }

  /// Number of vertices before welding. Of obj, ply, off, glb and gltf those in the file, whether a
  /// face uses them or not; else distinct combinations of position, normal, texture coordinates and
  /// colour in each part.
  std::size_t vertex_count_read() const { return weld_.size(); }

  /// What the file held and this mesh does not: "2 animations", "property quality of vertex".
  const std::vector<std::string>& dropped() const { return dropped_; }

  /// What the file holds that acts on the vertices and does not follow them: "1 skin", "2 morph
  /// targets". Where the file is edited it stays as it was.
  const std::vector<std::string>& unfollowed() const;

  /// Welded positions, vertex_count() x 3. Every value is a binary32 number if is_single(), else a
  /// double in the range of binary32.
  const Points& positions() const { return positions_; }

  /// Whether coordinates are binary32: of files with doubles, and of text with numbers of more
  /// digits than binary32 has, they are not.
  bool is_single() const;

  /// Whether any part has normals that set_positions() turns.
  bool has_normals() const;

  /// Moves the vertices, with all their duplicates. Values are settled(), and rounded to binary32
  /// if is_single(). Normals of faces that moved become area-weighted means over the faces that
  /// shared a normal, so hard edges stay hard; faces are as they were read.
  /// @param positions vertex_count() x 3
  /// @throws Error if the number of rows differs or a value is not a finite binary32 number; the
  ///   mesh is then unchanged.
  void set_positions(const Points& positions);

  /// The same, but a normal n that was read becomes the direction of cofactor(G) n (and a tangent
  /// that of G t), where G is the
  /// derivative of the deformation there: smoothing groups and normals made by hand are kept, and
  /// the result does not depend on the faces. Where G is unknown (not finite, or singular) the
  /// normal comes from the faces as above.
  ///
  /// cofactor(G) = det(G) G^-T also maps the area vectors of faces, so normals and faces agree. In
  /// a fold (det G < 0 in places) both turn inwards. If det G < 0 at every vertex where G is known,
  /// the deformation is a mirror: faces are turned round and normals take the other sign, so that
  /// triangles stay counterclockwise seen from outside.
  /// @param gradients vertex_count() matrices; column a of each is the derivative of the new
  ///   position along axis a of the position that was read
  /// @throws Error also if the number of gradients differs
  void set_positions(const Points& positions, const std::vector<Eigen::Matrix3d>& gradients);

  /// Triangles in welded indices. Polygons are fans from their first corner; points and lines
  /// are left out; a triangle that welding made degenerate stays.
  const std::vector<Triangle>& triangles() const;

  /// Unit normals of the welded vertices, vertex_count() x 3, smooth over all edges, weighted by
  /// area; (0, 1, 0) where the faces give no direction.
  Points smooth_normals() const;

  /// Whether save() under this name edits the file that was read, so that nothing of it is lost.
  bool edits(const std::filesystem::path& path) const;

  /// Writes the mesh; the extension chooses the format (obj, ply, off, stl, glb, gltf, dae). Files
  /// that belong to it (mtl, bin) go beside it; texture files are named so that they are found from
  /// there, not copied. Written whole or not at all, see write_files().
  ///
  /// What follows is of a mesh that is not edits(path).
  ///
  /// Vertices come in the order and number in which they were read, also those without faces,
  /// unless the format has one normal or texture coordinate a vertex and the mesh several.
  /// What is lost is measured: the file is read again and compared. As a rule these are
  ///
  /// - obj: textures inside the file
  /// - ply: parts become one; their names, materials and all but one texture's name
  /// - off: all but positions and faces
  /// - stl: all but triangles and their flat normals
  /// - glb, gltf: polygons are cut into triangles; objects of an obj file are empty nodes
  /// - dae: points; part names get a suffix, blanks in names become letters; materials may change
  ///   order
  /// @return what of this mesh is lost, a few words each; nothing for what cannot be read again,
  ///   such as a device
  /// @throws UsageError for an unknown extension (check_format()), Error for a mesh without faces
  ///   as stl or dae, a file beside it that would replace one that the mesh was read from, or a
  ///   failed write.
  std::vector<std::string> save(const std::filesystem::path& path) const;

  /// The scene as it stands now, for a renderer that wants materials or texture coordinates. It is
  /// made by the first call, which is for one thread alone, and lives as long as the mesh.
  const aiScene& scene() const;

  /// The welded vertex of every vertex of scene(), parts in order.
  const std::vector<std::uint32_t>& welded() const;

  /// The vertex in the file of every vertex of scene(), where the format numbers vertices
  /// (vertex_count_read()); else as welded().
  const std::vector<std::uint32_t>& numbers() const;

 private:
  struct Scene;

  Mesh(std::unique_ptr<aiScene> scene, std::string name);
  Mesh(ReadScene read, const std::filesystem::path& path);
  Mesh(std::unique_ptr<Document> document, const std::filesystem::path& path);
  void weld();
  /// @throws Error for what set_positions() refuses
  Points rounded(const Points& positions) const;
  const Points& rest() const;
  void move(Points positions, bool turned);
  /// What of this mesh another, which was written of it and read again, does not hold.
  std::vector<std::string> lost_in(const Mesh& written) const;
  Scene& edited() const;
  aiScene& mutable_scene() const;
  void update_scene() const;

  std::string name_;
  std::unique_ptr<Document> document_;  ///< none: no file, or one that Assimp reads
  std::unique_ptr<Content> content_;    ///< but for its positions; normals as they stand now
  Points positions_;
  Points rest_;                      ///< as they were read, once they have moved
  std::vector<std::uint32_t> weld_;  ///< vertex of the content -> welded vertex
  mutable std::optional<std::vector<Triangle>> triangles_;  ///< once they are asked for
  std::unique_ptr<FollowingNormals> normals_;
  std::unique_ptr<FollowingTangents> tangents_;
  mutable std::unique_ptr<Scene> scene_;
  bool is_numbered_ = false;  ///< whether the content's vertices are those of the file
  std::vector<std::string> dropped_;
  std::vector<std::filesystem::path> inputs_;  ///< the file that was read, and those beside it
  std::filesystem::path folder_;               ///< that names of textures start from; empty: none
  bool turned_ = false;  ///< whether faces are turned round from how they were read
};

/// Resolves the name of a model. A name with a folder, or of a file that is here, is taken as it
/// is; a bare name such as "cat.3ds" is also looked for in the folders given.
/// @param folders where else to look; the default is where the package glmark2-data keeps models
/// @throws Error if there is no such file; it names the folders and the package.
std::filesystem::path find_model(const std::string& name,
                                 const std::vector<std::filesystem::path>& folders = {
                                     "/usr/share/glmark2/models",
                                     "/usr/local/share/glmark2/models"});

/// Mesh::load of find_model(name); without a name glmark2's cat, or Mesh::procedural() where that
/// is not installed.
Mesh load_model(const std::string& name);

/// Positions after a deformation, in which those that rounding alone has moved, by some units in
/// the last place of the largest coordinate, are those at rest, bit for bit.
/// @param rest  as many rows
Points settled(Points positions, const Points& rest);

}  // namespace hwffd
