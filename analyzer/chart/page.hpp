// The whole picture: caption, panels, explanation, keys.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/chart/layer.hpp"

namespace pal::analyzer::chart {

/// Draws the layers, the first at the back. The axis counts from shifted time 0.
std::string page(const std::vector<Layer>& layers);

}  // namespace pal::analyzer::chart
