// Text, lines and pictures put together, by cairo. Private to pal_sim.
#pragma once

#include <cairo/cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "sim/picture/picture.hpp"

namespace pal::sim {

struct Colour {
  double red = 0, green = 0, blue = 0, opacity = 1;
};

struct Box {
  double x = 0, y = 0, width = 0, height = 0;
};

/// Pixels from the left and from the top.
class Canvas {
 public:
  /// Throws std::runtime_error if there is no memory for it.
  Canvas(int width, int height);

  void fill(const Box& box, const Colour& colour);
  void frame(const Box& box, const Colour& colour, double width);
  void place(const Image& image, double x, double y);
  void line(const std::vector<std::pair<double, double>>& points, const Colour& colour, double width);

  enum class Align { left, right, centre };
  /// `y` is the baseline.
  void text(double x, double y, const std::string& text, double size, const Colour& colour, bool bold = false,
            Align align = Align::left);
  /// The same, in a smaller size where `width` would not hold it.
  void text_within(double width, double x, double y, const std::string& text, double size,
                   const Colour& colour, bool bold = false);

  Image image() const;

 private:
  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };
  void use(const Colour& colour, double width = 1);

  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace pal::sim
