#include "sim/picture/canvas.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace pal::sim {
namespace {

// cairo's pixels are 32 bit words: nothing, red, green, blue.
std::uint32_t* row(cairo_surface_t* surface, int y) {
  return reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface) +
                                          static_cast<std::ptrdiff_t>(y) *
                                              cairo_image_surface_get_stride(surface));
}

}  // namespace

Canvas::Canvas(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      context_(cairo_create(surface_.get())) {
  if (cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("cairo makes no picture: ") +
                             cairo_status_to_string(cairo_status(context_.get())));
}

void Canvas::use(const Colour& colour, double width) {
  cairo_set_source_rgba(context_.get(), colour.red, colour.green, colour.blue, colour.opacity);
  cairo_set_line_width(context_.get(), width);
}

void Canvas::fill(const Box& box, const Colour& colour) {
  use(colour);
  cairo_rectangle(context_.get(), box.x, box.y, box.width, box.height);
  cairo_fill(context_.get());
}

void Canvas::frame(const Box& box, const Colour& colour, double width) {
  use(colour, width);
  cairo_rectangle(context_.get(), box.x, box.y, box.width, box.height);
  cairo_stroke(context_.get());
}

void Canvas::place(const Image& image, double x, double y) {
  cairo_surface_flush(surface_.get());
  const int left = static_cast<int>(x), top = static_cast<int>(y);
  for (int j = 0; j < image.height; ++j) {
    const unsigned char* from = image.pixels.data() + 3 * static_cast<std::ptrdiff_t>(j) * image.width;
    std::uint32_t* to = row(surface_.get(), top + j) + left;
    for (int i = 0; i < image.width; ++i, from += 3)
      to[i] = (std::uint32_t{from[0]} << 16U) | (std::uint32_t{from[1]} << 8U) | from[2];
  }
  cairo_surface_mark_dirty(surface_.get());
}

void Canvas::line(const std::vector<std::pair<double, double>>& points, const Colour& colour, double width) {
  use(colour, width);
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_new_path(context_.get());  // text leaves a point behind
  for (const auto& [x, y] : points) cairo_line_to(context_.get(), x, y);
  cairo_stroke(context_.get());
}

void Canvas::text(double x, double y, const std::string& text, double size, const Colour& colour, bool bold,
                  Align align) {
  use(colour);
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), size);
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), text.c_str(), &extents);
  const double shift = align == Align::left    ? 0
                       : align == Align::right ? extents.x_advance
                                               : extents.x_advance / 2;
  cairo_move_to(context_.get(), x - shift, y);
  cairo_show_text(context_.get(), text.c_str());
}

void Canvas::text_within(double width, double x, double y, const std::string& text, double size,
                         const Colour& colour, bool bold) {
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), size);
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), text.c_str(), &extents);
  const double fitting = extents.x_advance > width ? size * width / extents.x_advance : size;
  this->text(x, y, text, fitting, colour, bold);
}

Image Canvas::image() const {
  cairo_surface_flush(surface_.get());
  Image image{
      cairo_image_surface_get_width(surface_.get()), cairo_image_surface_get_height(surface_.get()), {}};
  image.pixels.reserve(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    const std::uint32_t* from = row(surface_.get(), y);
    for (int x = 0; x < image.width; ++x)
      for (const unsigned shift : {16U, 8U, 0U})
        image.pixels.push_back(static_cast<unsigned char>((from[x] >> shift) & 255U));
  }
  return image;
}

}  // namespace pal::sim
