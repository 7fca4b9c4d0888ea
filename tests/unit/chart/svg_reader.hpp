// Reads a chart's SVG as a viewer would, well enough to check it: tags balanced, texts with their places.
#pragma once

#include <string>
#include <vector>

#include "analyzer/chart/svg_writer.hpp"

namespace pal::analyzer::chart {

struct SvgText {
  std::string content;  // entities resolved
  Box box;              // where it stands, by the widths of the font that the style sheet names first
};

struct SvgElement {
  std::string tag;
  std::string style;  // attribute class
  std::string title;
};

struct SvgContent {
  std::string problem;  // not well formed: why; empty: it is
  Length width = 0;
  Length height = 0;
  std::vector<SvgText> texts;
  std::vector<SvgElement> elements;
};

SvgContent read_svg(const std::string& svg);

}  // namespace pal::analyzer::chart
