// Writes SVG elements. Coordinates are whole numbers, so no locale and no rounding can change a byte.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "analyzer/chart/text_width.hpp"

namespace pal::analyzer::chart {

struct Point {
  Length x = 0;
  Length y = 0;
};

/// [x0, x1] × [y0, y1].
struct Box {
  Length x0 = 0;
  Length y0 = 0;
  Length x1 = 0;
  Length y1 = 0;
};

enum class Anchor { start, middle, end };

/// Appends elements to a text. A `title` is what a viewer shows when the pointer is over the element; empty:
/// none. `style` is one or more names of classes of the style sheet in svg_style.hpp.
class SvgWriter {
 public:
  /// `id`: made unique by a number behind it; empty: none.
  void rect(const Box& box, std::string_view style, std::string_view title = {}, const std::string& id = {});
  void line(Point from, Point to, std::string_view style, std::string_view title = {});
  /// `data` is the value of the attribute d.
  void path(const std::string& data, std::string_view style, std::string_view title = {});
  void text(Point at, Anchor anchor, std::string_view style, std::string_view content,
            std::string_view title = {});
  /// Text that reads upwards, with its middle at `at`.
  void upright(Point at, std::string_view style, std::string_view content, std::string_view title = {});
  void raw(std::string_view text) { out_ += text; }

  const std::string& str() const { return out_; }
  /// Whether a rectangle or a path was drawn whose style begins with these names.
  bool has_drawn(std::string_view style) const;

 private:
  void end(std::string_view element, std::string_view title);

  std::string out_;
  std::set<std::string, std::less<>> styles_;
  std::map<std::string, int> ids_;
};

/// Part of a path: "M x y", "L x y".
std::string move_to(Point to);
std::string line_to(Point to);

}  // namespace pal::analyzer::chart
