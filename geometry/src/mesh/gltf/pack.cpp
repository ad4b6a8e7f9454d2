#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "hwffd/error.hpp"
#include "hwffd/mesh/extension.hpp"
#include "mesh/gltf/file.hpp"
#include "mesh/gltf/uri.hpp"
#include "mesh/utf8.hpp"

namespace hwffd::gltf {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

void append_word(std::string& bytes, std::size_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
}

void append_chunk(std::string& bytes, const char* type, const std::string& data) {
  append_word(bytes, data.size());
  bytes.append(type, 4);
  bytes += data;
}

std::size_t filled_up(std::size_t size) { return (size + 3) / 4 * 4; }

}  // namespace

/// Names that applications keep for themselves (extras) are theirs.
void File::relocate(JsonText& json, const fs::path& output) const {
  std::set<std::size_t> buffers;
  for (const JsonText::Span buffer : json.items(json.members(json.root())["buffers"])) {
    buffers.insert(json.members(buffer)["uri"].begin);
  }
  for (const JsonText::Span span : json.texts("uri", "extras")) {
    if (buffers.count(span.begin) != 0) continue;
    const std::string uri = json.unquoted(span);
    const std::string relocated = relocated_uri(uri, folder_, output);
    if (relocated != uri) json.replace(span, Json(relocated).dump());
  }
}

Files File::packed(JsonText json, const std::map<std::size_t, std::string>& edited,
                   const fs::path& path) const {
  const bool to_container = extension_of(path) == ".glb";
  if (!to_container && !rest_.empty()) {
    throw Error("it has chunks that only a GLB file can hold; write a .glb");
  }
  Files files;
  std::string_view chunk = chunk_;
  std::map<std::string, std::string> names;  // URI of an unchanged file -> name of its copy
  const std::vector<JsonText::Span> items = json.items(json.members(json.root())["buffers"]);
  for (std::size_t b = 0; b < buffers_.size(); ++b) {
    const Buffer& buffer = buffers_[b];
    const auto change = edited.find(b);
    const bool is_edited = change != edited.end();
    const std::string_view bytes = is_edited ? std::string_view(change->second) : buffer.bytes;
    JsonText::Members members = json.members(items[b]);
    const bool was_chunk = buffer.home == Buffer::Home::kChunk;
    if (to_container && (was_chunk || (b == 0 && !is_container_))) {
      chunk = bytes;
      if (!was_chunk) {
        Json object = json_["buffers"][b];
        object.erase("uri");
        object["byteLength"] = bytes.size();
        json.replace(items[b], object.dump());
      } else if (bytes.size() > buffer.bytes.size()) {
        json.replace(members.at("byteLength"), std::to_string(bytes.size()));
      }
      continue;
    }
    if (bytes.size() > buffer.bytes.size()) {
      json.replace(members.at("byteLength"), std::to_string(bytes.size()));
    }
    if (buffer.home == Buffer::Home::kData) {
      if (is_edited) json.replace(members.at("uri"), Json(with_data(buffer.uri, bytes)).dump());
      continue;
    }
    std::string name = path.stem().string() + (b > 0 ? fmt::format("-{}.bin", b) : ".bin");
    if (!is_edited) name = names.emplace(buffer.uri, name).first->second;
    files[name] = bytes;
    const std::string uri = percent_encoded(utf8_of(name));
    if (was_chunk) {
      json.add_member(items[b], "uri", Json(uri).dump());
    } else if (percent_decoded(buffer.uri) != utf8_of(name)) {
      json.replace(members.at("uri"), Json(uri).dump());
    }
  }
  relocate(json, path);
  std::string text = json.edited();
  const std::string name = path.filename().string();
  if (to_container) {
    files[name] = container(std::move(text), chunk);
  } else {
    files[name] = is_container_ ? text + "\n" : text + fill_;
  }
  return files;
}

std::string File::container(std::string text, std::string_view chunk) const {
  if (is_container_ && text == text_) {
    text += fill_;
  } else {
    const std::size_t before = is_container_ ? text_.size() + fill_.size() : 0;
    text.resize(std::max(before, filled_up(text.size())), ' ');
  }
  std::string data(chunk);
  if (data.size() != chunk_.size()) data.resize(filled_up(data.size()));
  std::string body;
  append_chunk(body, "JSON", text);
  if (has_chunk_ || !data.empty()) append_chunk(body, "BIN\0", data);
  body += rest_;
  std::string bytes = "glTF";
  append_word(bytes, 2);
  constexpr std::size_t kFileHeader = 12;
  constexpr std::size_t kChunkFileHeaders = 16;
  // What stands behind the length that the container says it has stays behind it.
  const std::size_t size_read = kFileHeader + kChunkFileHeaders / (has_chunk_ ? 1 : 2) +
                                text_.size() + fill_.size() + chunk_.size() + rest_.size();
  const std::size_t length =
      is_container_ ? length_ + kFileHeader + body.size() - size_read : kFileHeader + body.size();
  append_word(bytes, length);
  return bytes + body;
}

}  // namespace hwffd::gltf
