#include <fmt/format.h>

#include <cstring>
#include <string_view>

#include "hwffd/error.hpp"
#include "mesh/read_scene.hpp"

namespace hwffd {
namespace {

constexpr unsigned kDeepest = 1000;  // of nodes; what walks over them recurses

/// Writes values one after another; Unpacker reads them. What they visit is written once, below,
/// for both.
class Packer {
 public:
  static constexpr bool kReads = false;

  void raw(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }
  template <typename T>
  void value(T& value) {
    raw(&value, sizeof(T));
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  static constexpr bool kReads = true;

  explicit Unpacker(const std::string& bytes) : rest_(bytes) {}

  void raw(void* data, std::size_t size) {
    expect(size, 1);
    if (size != 0) std::memcpy(data, rest_.data(), size);
    rest_.remove_prefix(size);
  }
  template <typename T>
  void value(T& value) {
    raw(&value, sizeof(T));
  }
  /// There must be so many items still, of at least so many bytes.
  void expect(std::size_t items, std::size_t size) const {
    if (items > rest_.size() / size) throw Error("the bytes of its scene are broken");
  }

 private:
  std::string_view rest_;
};

/// An array, which may be missing.
template <typename Archive, typename T>
void visit_array(Archive& archive, T*& data, std::size_t count) {
  std::uint8_t is_there = data != nullptr;
  archive.value(is_there);
  if (is_there == 0) return;
  if constexpr (Archive::kReads) {
    archive.expect(count, sizeof(T));
    data = new T[count];
  }
  archive.raw(data, count * sizeof(T));
}

/// A text or a list of numbers.
template <typename Archive, typename List>
auto visit(Archive& archive, List& list) -> decltype(list.resize(0)) {
  auto size = static_cast<std::uint64_t>(list.size());
  archive.value(size);
  if constexpr (Archive::kReads) {
    archive.expect(size, sizeof(list[0]));
    list.resize(size);
  }
  archive.raw(list.data(), size * sizeof(list[0]));
}

template <typename Archive>
void visit(Archive& archive, aiString& text) {
  std::string copy(text.data, text.length);
  visit(archive, copy);
  if constexpr (Archive::kReads) text = copy;
}

template <typename Archive>
void visit(Archive& archive, std::vector<std::string>& texts) {
  auto size = static_cast<std::uint32_t>(texts.size());
  archive.value(size);
  if constexpr (Archive::kReads) {
    archive.expect(size, 1);
    texts.resize(size);
  }
  for (std::string& text : texts) visit(archive, text);
}

/// On reading makes the items of a list of owned pointers.
template <typename Archive, typename T>
void allocate(Archive& archive, T**& items, unsigned& count, std::uint32_t number) {
  if constexpr (Archive::kReads) {
    archive.expect(number, 1);
    items = new T* [number] {};
    for (; count < number; ++count) items[count] = new T();
  }
}

/// A list of owned pointers.
template <typename Archive, typename T>
void visit(Archive& archive, T**& items, unsigned& count) {
  std::uint32_t number = count;
  archive.value(number);
  allocate(archive, items, count, number);
  for (std::uint32_t i = 0; i < number; ++i) visit(archive, *items[i]);
}

template <typename Archive>
void visit(Archive& archive, aiMesh& part) {
  visit(archive, part.mName);
  archive.value(part.mPrimitiveTypes);
  archive.value(part.mMaterialIndex);
  archive.value(part.mNumVertices);
  visit_array(archive, part.mVertices, part.mNumVertices);
  visit_array(archive, part.mNormals, part.mNumVertices);
  for (unsigned t = 0; t < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++t) {
    visit_array(archive, part.mTextureCoords[t], part.mNumVertices);
    archive.value(part.mNumUVComponents[t]);
  }
  for (aiColor4D*& colours : part.mColors) visit_array(archive, colours, part.mNumVertices);
  std::uint32_t faces = part.mNumFaces;
  archive.value(faces);
  if constexpr (Archive::kReads) {
    archive.expect(faces, sizeof(std::uint32_t));
    part.mFaces = new aiFace[faces];
  }
  for (part.mNumFaces = 0; part.mNumFaces < faces; ++part.mNumFaces) {
    aiFace& face = part.mFaces[part.mNumFaces];
    archive.value(face.mNumIndices);
    visit_array(archive, face.mIndices, face.mNumIndices);
  }
}

template <typename Archive>
void visit(Archive& archive, aiMaterialProperty& property) {
  visit(archive, property.mKey);
  archive.value(property.mSemantic);
  archive.value(property.mIndex);
  archive.value(property.mType);
  archive.value(property.mDataLength);
  visit_array(archive, property.mData, property.mDataLength);
}

template <typename Archive>
void visit(Archive& archive, aiMaterial& material) {
  if constexpr (Archive::kReads) {
    delete[] material.mProperties;
    material.mProperties = nullptr;
  }
  visit(archive, material.mProperties, material.mNumProperties);
  if constexpr (Archive::kReads) material.mNumAllocated = material.mNumProperties;
}

template <typename Archive>
void visit(Archive& archive, aiTexture& texture) {
  visit(archive, texture.mFilename);
  archive.value(texture.achFormatHint);
  archive.value(texture.mWidth);
  archive.value(texture.mHeight);
  // A compressed picture has mWidth bytes and no height.
  const std::size_t bytes = texture.mHeight == 0
                                ? std::size_t{texture.mWidth}
                                : std::size_t{texture.mWidth} * texture.mHeight * sizeof(aiTexel);
  if constexpr (Archive::kReads) {
    archive.expect(bytes, 1);
    texture.pcData = new aiTexel[bytes / sizeof(aiTexel) + 1];
  }
  archive.raw(texture.pcData, bytes);
}

template <typename Archive>
void visit(Archive& archive, aiNode& node, unsigned depth = 0) {
  if (depth > kDeepest) throw Error(fmt::format("nodes are nested over {} deep", kDeepest));
  visit(archive, node.mName);
  archive.value(node.mNumMeshes);
  visit_array(archive, node.mMeshes, node.mNumMeshes);
  std::uint32_t children = node.mNumChildren;
  archive.value(children);
  allocate(archive, node.mChildren, node.mNumChildren, children);
  for (std::uint32_t c = 0; c < children; ++c) {
    node.mChildren[c]->mParent = &node;
    visit(archive, *node.mChildren[c], depth + 1);
  }
}

template <typename Archive>
void visit(Archive& archive, ReadScene& read) {
  aiScene& scene = *read.scene;
  if constexpr (Archive::kReads) scene.mRootNode = new aiNode();
  visit(archive, *scene.mRootNode);
  visit(archive, scene.mMeshes, scene.mNumMeshes);
  visit(archive, scene.mMaterials, scene.mNumMaterials);
  visit(archive, scene.mTextures, scene.mNumTextures);
  visit(archive, read.numbers);
  archive.value(read.space);
  visit(archive, read.dropped);
}

}  // namespace

std::string pack(const ReadScene& read) {
  Packer packer;
  visit(packer, const_cast<ReadScene&>(read));  // a Packer changes nothing
  return packer.take();
}

ReadScene unpack(const std::string& bytes) {
  ReadScene read;
  read.scene = std::make_unique<aiScene>();
  Unpacker unpacker(bytes);
  visit(unpacker, read);
  return read;
}

}  // namespace hwffd
