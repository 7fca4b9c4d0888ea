// What the pictures of a study share: the page, its colours, and the ticks of an axis.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/chart/svg_writer.hpp"
#include "study/table.hpp"

namespace pal::study {

using analyzer::chart::Length;

/// Between the page's edge and what is drawn; the sizes of letters, as the style sheet has them.
constexpr Length margin = 200, label_font = 100, small_font = 85, title_font = 150;

/// The whole file: a page of this size with what was drawn on it. Lengths are tenths of a pixel.
std::string page(Length width, Length height, const std::string& drawn);

/// Which labels of an axis are written, so that each has `room` of `step` a label: every one, or every
/// second, ….
std::size_t label_stride(const std::vector<std::string>& labels, Length step);

/// The labels of a figure's values.
std::vector<std::string> labels_of(const Figure& figure);

}  // namespace pal::study
