#include "mesh/memory_io.hpp"

#include <algorithm>
#include <cstring>

namespace hwffd {
namespace {

class MemoryStream : public Assimp::IOStream {
 public:
  explicit MemoryStream(std::string& bytes) : bytes_(bytes) {}

  std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
    if (size == 0 || position_ >= bytes_.size()) return 0;
    const std::size_t whole = std::min(count, (bytes_.size() - position_) / size);
    std::memcpy(buffer, bytes_.data() + position_, whole * size);
    position_ += whole * size;
    return whole;
  }

  std::size_t Write(const void* buffer, std::size_t size, std::size_t count) override {
    const std::size_t length = size * count;
    if (position_ + length > bytes_.size()) bytes_.resize(position_ + length);
    if (length != 0) std::memcpy(bytes_.data() + position_, buffer, length);
    position_ += length;
    return count;
  }

  /// As fseek: a position past the end is legal, and writing there fills the gap with zeros.
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    std::size_t target = offset;
    if (origin == aiOrigin_CUR) target += position_;
    if (origin == aiOrigin_END) target = bytes_.size() - std::min(offset, bytes_.size());
    position_ = target;
    return aiReturn_SUCCESS;
  }

  std::size_t Tell() const override { return position_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string& bytes_;
  std::size_t position_ = 0;
};

}  // namespace

Assimp::IOStream* MemoryIo::Open(const char* name, const char* mode) {
  if (mode[0] == 'r' && !Exists(name)) return nullptr;
  std::string& bytes = files_[name];
  if (mode[0] == 'w') bytes.clear();
  return new MemoryStream(bytes);
}

}  // namespace hwffd
