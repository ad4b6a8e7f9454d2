#pragma once

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <map>
#include <string>

namespace hwffd {

/// Where Assimp's exporters write to: memory. They do not check their writes, so the files are
/// collected here and then written by write_files(), which does.
class MemoryIo : public Assimp::IOSystem {
 public:
  /// The files written so far: name -> bytes.
  const std::map<std::string, std::string>& files() const { return files_; }

  bool Exists(const char* name) const override { return files_.count(name) != 0; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::map<std::string, std::string> files_;
};

}  // namespace hwffd
