#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/gltf/json_item.hpp"
#include "mesh/gltf/json_text.hpp"
#include "mesh/mesh_writers.hpp"

namespace hwffd::gltf {

/// A buffer of a glTF file, whole.
struct Buffer {
  enum class Home {
    kChunk,  ///< of the GLB file itself
    kData,   ///< a data URI
    kFile,   ///< a file beside it
  };
  Home home;
  std::string uri;         ///< what the JSON says
  std::string_view bytes;  ///< at least as many as its byteLength says
};

/// The JSON, the buffers and what else a .gltf or .glb file (glTF 2.0) consists of.
class File {
 public:
  /// Whether the text is JSON or a GLB container its first bytes say.
  /// @param path  of the file; buffers are looked for beside it
  /// @throws Error, here and below without the file's name, for what is no glTF 2.0, a buffer that
  ///   is not there or too short, a required extension that is not known, and compressed geometry
  File(const std::filesystem::path& path, const std::string& bytes);

  const nlohmann::json& json() const { return json_; }
  /// Its JSON as it stands there.
  const std::string& text() const { return text_; }
  const std::vector<Buffer>& buffers() const { return buffers_; }
  /// The file's items by the name of their list, such as "nodes".
  const JsonItem& root() const { return root_; }
  /// The files beside it that it consists of or refers to.
  std::vector<std::filesystem::path> companions() const;

  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// The file with other buffers.
  /// @param json  changes of text(); what a buffer's URI and byteLength become is added here
  /// @param buffers  those that have other bytes, by number
  /// @param path  of the output: its extension says whether it is a GLB container. A buffer that
  ///   was a file is written beside it, under the output's name; the first of a GLB goes into the
  ///   container. Other relative URIs are made to be true from the output's folder.
  Files packed(JsonText json, const std::map<std::size_t, std::string>& buffers,
               const std::filesystem::path& path) const;

 private:
  void split(const std::string& bytes);
  void parse();
  void check_extensions() const;
  void read_buffers();
  std::string_view read_file(const std::string& uri, const JsonItem& item);
  void relocate(JsonText& json, const std::filesystem::path& output) const;
  std::string container(std::string text, std::string_view chunk) const;

  std::filesystem::path folder_;
  bool is_container_ = false;
  std::uint32_t length_ = 0;  ///< that a container's header says
  std::string text_;          ///< JSON, without the blanks or zeros behind it
  std::string fill_;          ///< those
  bool has_chunk_ = false;    ///< the binary one
  std::string chunk_;
  std::string rest_;  ///< behind the binary chunk
  nlohmann::json json_;
  JsonItem root_;
  std::vector<Buffer> buffers_;
  std::list<std::string> data_;               ///< of data URIs
  std::map<std::string, std::string> files_;  ///< bytes of files, by URI
};

}  // namespace hwffd::gltf
