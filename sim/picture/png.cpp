#include <png.h>

#include <cstdio>

#include "sim/picture/picture.hpp"

namespace pal::sim {

std::optional<std::string> write_png(const Image& image, const std::filesystem::path& file) {
  const std::filesystem::path temporary = file.string() + ".tmp";
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  std::error_code error;
  if (!png_image_write_to_file(&header, temporary.c_str(), 0, image.pixels.data(), 0, nullptr)) {
    std::filesystem::remove(temporary, error);
    return file.string() + " cannot be written: " + header.message;
  }
  std::filesystem::rename(temporary, file, error);
  if (!error) return std::nullopt;
  const std::string reason = error.message();
  std::filesystem::remove(temporary, error);
  return file.string() + " cannot be written: " + reason;
}

}  // namespace pal::sim
