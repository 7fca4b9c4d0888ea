// Quantities that can be read of the cell between skills: of its devices, and of sensors that are fixed in
// it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/cell/question.hpp"
#include "sim/random.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

/// A quantity by the name that operations use: "gripper-width".
struct SensorSpec {
  std::string name;
  std::string unit;  // empty: a plain number
  std::string description;
};

/// Of the force-torque sensor, the arm's tool, and the scene's own sensors.
std::vector<SensorSpec> sensors_of(const Workcell& workcell);

/// The message of a device that has the quantity; nothing: it is a fixed sensor, or unknown.
struct Source {
  std::string device, message;
};
std::optional<Source> source_of(const std::string& sensor);

/// The quantity out of the fields of its source's message. Nothing: nearest, of a profile without a point.
std::optional<double> quantity(const std::string& sensor, const std::vector<double>& fields);

/// The reading of a fixed sensor, mm: from its place straight down to what it meets first, the arm excepted.
/// With noise of 0.1 mm (deviation, ours). Nothing: there is no such sensor, or it meets nothing.
std::optional<double> read_fixed_sensor(const Workcell& workcell, const std::string& sensor, Random& noise);

/// A fixed sensor measures this often.
inline constexpr runtime::Time fixed_sensor_period = std::chrono::milliseconds(10);

}  // namespace pal::sim
