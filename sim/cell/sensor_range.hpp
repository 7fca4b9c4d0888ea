// What the cell's sensors can show.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace pal::sim {

/// The least and the greatest that its device can show, in the unit of its SensorSpec. Nothing: it is a fixed
/// sensor, or unknown.
std::optional<std::pair<double, double>> sensor_range(const std::string& sensor);

}  // namespace pal::sim
