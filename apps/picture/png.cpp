#include "picture/png.hpp"

#include <fmt/format.h>
#include <png.h>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"

namespace hwffd::picture {

std::string png_bytes(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  const auto write = [&](void* memory) {
    if (png_image_write_to_memory(&header, memory, &size, 0, image.pixels.data(), 0, nullptr) !=
        0) {
      return;
    }
    throw Error(fmt::format("picture of {}x{} pixels: {}; give it another size", image.width,
                            image.height, header.message));
  };
  write(nullptr);  // to learn the size
  std::string bytes(size, '\0');
  write(bytes.data());
  return bytes;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  write_files({{path, png_bytes(image)}});
}

}  // namespace hwffd::picture
