#pragma once

#include <filesystem>
#include <string>

#include "picture/image.hpp"

namespace hwffd::picture {

/// The file of a picture: PNG, 8 bits a colour, no alpha. Equal pictures give equal bytes.
/// @throws Error if the picture has no pixels
std::string png_bytes(const Image& image);

/// Writes png_bytes() whole or not at all, see write_files().
/// @throws Error if the file cannot be written
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace hwffd::picture
