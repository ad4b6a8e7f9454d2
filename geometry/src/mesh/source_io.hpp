#pragma once

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>

#include <filesystem>
#include <string>

namespace hwffd {

/// What Assimp's readers see: the bytes of one file, and beside it the files that it refers to.
/// Those are regular files: a pipe or a device might never end.
class SourceIo : public Assimp::DefaultIOSystem {
 public:
  SourceIo(std::string name, const std::string& bytes) : name_(std::move(name)), bytes_(bytes) {}

  bool Exists(const char* name) const override {
    std::error_code ignored;
    return name == name_ || std::filesystem::is_regular_file(name, ignored);
  }

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    if (!Exists(name)) return nullptr;
    if (name != name_) return DefaultIOSystem::Open(name, mode);
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes_.data()),
                                      bytes_.size());
  }

 private:
  std::string name_;
  const std::string& bytes_;
};

}  // namespace hwffd
