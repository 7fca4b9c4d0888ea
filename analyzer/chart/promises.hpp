// Promises of the environment that a run broke: each has a number, which its marks show and a list explains.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/chart/layer.hpp"
#include "analyzer/chart/svg_writer.hpp"

namespace pal::analyzer::chart {

struct BrokenPromise {
  std::string text;           // in words, as the trace has it
  std::int64_t first_ns = 0;  // when it was first broken, on the chart's axis
  std::size_t times = 0;
};

/// Each promise once, in order of the layers, then of time.
std::vector<BrokenPromise> broken_promises(const std::vector<Layer>& layers);

/// The sign of a promise with its number, around `middle`.
void draw_promise_sign(Point middle, std::size_t number, const std::string& style, const std::string& title,
                       SvgWriter& out);

/// The list under the panels. Returns where the next thing may begin.
Length draw_promise_list(const std::vector<Layer>& layers, Length top, SvgWriter& out);

}  // namespace pal::analyzer::chart
