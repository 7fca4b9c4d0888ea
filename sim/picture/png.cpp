// Pictures as PNG files.
#include <png.h>

#include <stdexcept>

#include "sim/picture/picture.hpp"

namespace pal::sim {

std::string encode_png(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  std::string bytes;
  // Once for the size, once for the bytes.
  for (int pass = 0; pass < 2; ++pass) {
    if (!png_image_write_to_memory(&header, pass == 0 ? nullptr : bytes.data(), &size, 0, image.pixels.data(),
                                   0, nullptr))
      throw std::runtime_error(std::string("the picture cannot be written as PNG: ") + header.message);
    bytes.resize(size);
  }
  return bytes;
}

}  // namespace pal::sim
