// What stands above and below the panels of a chart.
#pragma once

#include <vector>

#include "analyzer/chart/layer.hpp"
#include "analyzer/chart/numbering.hpp"
#include "analyzer/chart/svg_writer.hpp"

namespace pal::analyzer::chart {

/// All return where the next thing may begin.
Length draw_caption(const std::vector<Layer>& layers, Length top, SvgWriter& out);
Length draw_panel_heading(const std::string& text, Length top, SvgWriter& out);
Length draw_explanation(const std::vector<Layer>& layers, Length top, SvgWriter& out);
Length draw_statement_key(const Numbering& numbering, Length right, Length top, SvgWriter& out);
/// The signs that were drawn before, and no others.
Length draw_sign_key(const std::vector<Layer>& layers, Length top, SvgWriter& out);

/// The caption as lines of text, for the caption itself and for the picture's title.
std::vector<std::string> caption_lines(const std::vector<Layer>& layers);

}  // namespace pal::analyzer::chart
