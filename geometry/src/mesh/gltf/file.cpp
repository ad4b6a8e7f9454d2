#include "mesh/gltf/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "mesh/gltf/uri.hpp"
#include "mesh/read_scene.hpp"
#include "read_file.hpp"

namespace hwffd::gltf {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kDeepest = 1000;  // of JSON; who copies or writes it recurses
constexpr std::size_t kHeader = 12;
constexpr std::size_t kChunkHeader = 8;
constexpr std::uint32_t kJsonType = 0x4E4F534A;
constexpr std::uint32_t kBinaryType = 0x004E4942;

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    word |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return word;
}

/// Extensions whose geometry is compressed: it cannot be read without their decoders, nor edited
/// where a plain copy stands beside it.
bool is_compression(const std::string& name) {
  return name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression" ||
         name == "KHR_meshopt_compression";
}

/// Extensions that may be required of who reads geometry: quantization is read, the others do not
/// change what positions mean.
bool is_known(const std::string& name) {
  constexpr std::array<const char*, 9> kKnown{
      "KHR_mesh_quantization", "KHR_texture_transform", "KHR_texture_basisu",
      "EXT_texture_webp",      "EXT_texture_avif",      "MSFT_texture_dds",
      "KHR_lights_punctual",   "KHR_xmp_json_ld",       "KHR_animation_pointer"};
  return name.rfind("KHR_materials_", 0) == 0 ||
         std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end();
}

/// The file that a URI names; writers that encode nothing may mean the very characters.
fs::path file_of(const fs::path& folder, const std::string& uri) {
  std::error_code ignored;
  const fs::path decoded = folder / percent_decoded(uri);
  const fs::path raw = folder / uri;
  const bool is_raw = !fs::exists(decoded, ignored) && fs::exists(raw, ignored);
  return is_raw ? raw : decoded;
}

}  // namespace

File::File(const fs::path& path, const std::string& bytes)
    : folder_(fs::absolute(path).parent_path()), json_(Json::object()), root_(json_, "the file") {
  split(bytes);
  parse();
  check_extensions();
  read_buffers();
}

/// GLB (glTF 2.0, section 4.4): a header of 12 bytes, then chunks of length, type and data: first
/// the JSON, filled up with blanks, then at most one binary chunk, then those of extensions.
void File::split(const std::string& bytes) {
  is_container_ = bytes.compare(0, kMagic.size(), kMagic) == 0;
  if (!is_container_) {
    text_ = bytes;
    return;
  }
  if (bytes.size() < kHeader + kChunkHeader) throw not_a_mesh("the file ends in its header");
  const std::uint32_t version = word_at(bytes, 4);
  if (version != 2) throw not_a_mesh(fmt::format("GLB version {}, not 2", version));
  length_ = word_at(bytes, 8);
  const auto body = [&](std::size_t at) {
    const std::size_t size = word_at(bytes, at);
    if (size > bytes.size() - at - kChunkHeader) throw not_a_mesh("the file ends in a chunk");
    return bytes.substr(at + kChunkHeader, size);
  };
  std::size_t at = kHeader;
  if (word_at(bytes, at + 4) != kJsonType) throw not_a_mesh("its first chunk is not JSON");
  text_ = body(at);
  at += kChunkHeader + text_.size();
  has_chunk_ = bytes.size() - at >= kChunkHeader && word_at(bytes, at + 4) == kBinaryType;
  if (has_chunk_) {
    chunk_ = body(at);
    at += kChunkHeader + chunk_.size();
  }
  rest_ = bytes.substr(at);
}

void File::parse() {
  const std::size_t end = text_.find_last_not_of(std::string(" \t\r\n\0", 5)) + 1;
  fill_ = text_.substr(end);
  text_.resize(end);
  // The library takes a zero byte for the end, whatever follows it.
  if (text_.find('\0') != text_.npos) throw not_a_mesh("a zero byte in its JSON");
  try {
    json_ = Json::parse(text_);
  } catch (const Json::parse_error& error) {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(
                                         error.byte > 0 ? error.byte - 1 : 0, text_.size()));
    const auto line = std::find(std::make_reverse_iterator(end), text_.rend(), '\n').base();
    throw not_a_mesh(fmt::format("no JSON in line {}, column {}",
                                 1 + std::count(text_.begin(), end, '\n'), 1 + (end - line)));
  } catch (const Json::exception&) {
    throw not_a_mesh("a number too large for double precision");
  }
  if (JsonText(text_).depth() > kDeepest) {
    throw not_a_mesh(fmt::format("its JSON is nested over {} deep", kDeepest));
  }
  if (!json_.is_object()) throw not_a_mesh("its JSON is no object");
  root_ = JsonItem(json_, "the file");
  const std::string version = root_.object("asset").text("version", "none");
  if (version.rfind("2.", 0) != 0)
    throw not_a_mesh(fmt::format("glTF version {}", excerpt(version)));
}

void File::check_extensions() const {
  std::vector<std::string> names = root_.texts("extensionsRequired");
  for (const std::string& name : names) {
    if (is_known(name) || is_compression(name)) continue;
    throw Error(
        fmt::format("requires the extension {}, which is not known here; write the file without it",
                    excerpt(name)));
  }
  // A file may say that it only uses a compression, and hold a plain copy beside it, which would
  // then differ from what it compresses.
  const std::vector<std::string> used = root_.texts("extensionsUsed");
  names.insert(names.end(), used.begin(), used.end());
  for (const JsonItem& mesh : root_.list("meshes", "mesh")) {
    for (const JsonItem& primitive : mesh.list("primitives", "primitive")) {
      if (primitive.object("extensions").has("KHR_draco_mesh_compression")) {
        names.emplace_back("KHR_draco_mesh_compression");
      }
    }
  }
  for (const std::string& name : names) {
    if (!is_compression(name)) continue;
    throw Error(fmt::format("its geometry is compressed by {}; write the file without it", name));
  }
}

void File::read_buffers() {
  for (const JsonItem& item : root_.list("buffers", "buffer")) {
    Buffer buffer{Buffer::Home::kChunk, item.text("uri", ""), chunk_};
    if (!item.has("uri")) {
      if (!has_chunk_ || !buffers_.empty()) item.fail("has no uri");
    } else if (buffer.uri.rfind("data:", 0) == 0) {
      std::optional<std::string> bytes = data_of(buffer.uri);
      if (!bytes) item.fail("its data URI is not base64");
      buffer.home = Buffer::Home::kData;
      buffer.bytes = data_.emplace_back(std::move(*bytes));
    } else {
      buffer.home = Buffer::Home::kFile;
      buffer.bytes = read_file(buffer.uri, item);
    }
    const std::size_t length = item.whole("byteLength");
    if (buffer.bytes.size() < length) {
      item.fail(fmt::format("has {} bytes, {} by its byteLength", buffer.bytes.size(), length));
    }
    buffers_.push_back(std::move(buffer));
  }
}

std::string_view File::read_file(const std::string& uri, const JsonItem& item) {
  const auto known = files_.find(uri);
  if (known != files_.end()) return known->second;
  const fs::path file = file_of(folder_, uri);
  std::error_code ignored;
  // A pipe or a device might never end.
  if (is_absolute_uri(uri) || !fs::is_regular_file(file, ignored)) {
    throw Error(fmt::format("{}: there is no file '{}' beside it; put it there", item.name(),
                            excerpt(percent_decoded(uri))));
  }
  return files_[uri] = hwffd::read_file(file);
}

std::vector<fs::path> File::companions() const {
  std::vector<fs::path> files;
  const JsonText json(text_);
  for (const JsonText::Span span : json.texts("uri", "extras")) {
    const std::string uri = json.unquoted(span);
    if (!is_absolute_uri(uri)) files.push_back(file_of(folder_, uri));
  }
  return files;
}

}  // namespace hwffd::gltf
