#include <utility>

#include "hwffd/mesh/extension.hpp"
#include "mesh/format/obj_syntax.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

class ObjDocument : public Document {
 public:
  ObjDocument(const fs::path& path, std::string bytes)
      : bytes_(std::move(bytes)), folder_(fs::absolute(path).parent_path()) {
    read_obj_content(path, bytes_, content_, companions_);
    is_single_ = content_.is_single;
    normals_ = static_cast<std::size_t>(content_.normals.rows.rows());
  }

  bool is_of(const fs::path& path) const override { return extension_of(path) == ".obj"; }

  Files edited(const Edit& edit, const fs::path& path) const override {
    return {
        {path.filename().string(), edit_obj(bytes_, is_single_, normals_, edit, folder_, path)}};
  }

 private:
  std::string bytes_;
  fs::path folder_;
  bool is_single_ = true;
  std::size_t normals_ = 0;  ///< rows that were read, if corners refer to any
};

}  // namespace

std::unique_ptr<Document> read_obj(const fs::path& path, std::string bytes) {
  return std::make_unique<ObjDocument>(path, std::move(bytes));
}

}  // namespace hwffd
