#include "sim/cell/sensors.hpp"

#include <algorithm>
#include <array>

#include "sim/cell/sensor_range.hpp"

namespace pal::sim {
namespace {

struct Quantity {
  const char* name;
  const char* unit;
  const char* description;
  const char* device;
  const char* message;
  std::size_t field;
  double low, high;  // that the device can show
};

constexpr double fixed_sensor_noise = 0.1;  // mm

constexpr std::array quantities{
    Quantity{"force-x", "N", "on the force-torque sensor, along its x", "force-torque", "wrench", 0, -65, 65},
    Quantity{"force-y", "N", "likewise along y", "force-torque", "wrench", 1, -65, 65},
    Quantity{"force-z", "N", "likewise along z; pressing is negative", "force-torque", "wrench", 2, -65, 65},
    Quantity{"torque-x", "N*m", "on the force-torque sensor, about its x", "force-torque", "wrench", 3, -5,
             5},
    Quantity{"torque-y", "N*m", "likewise about y", "force-torque", "wrench", 4, -5, 5},
    Quantity{"torque-z", "N*m", "likewise about z", "force-torque", "wrench", 5, -5, 5},
    Quantity{"gripper-width", "mm", "between the fingers", "gripper", "state", 0, 0, 80},
    Quantity{"gripper-force", "N", "with which each finger presses", "gripper", "state", 1, 0, 100},
    Quantity{"gripper-holding", "", "1: both fingers press on a part; 0: they do not", "gripper", "state", 2,
             0, 1},
    Quantity{"range-nearest", "mm", "from the range finder to the nearest point of a profile", "range-finder",
             "profile", 0, 100, 1000},
};

const Quantity* find(const std::string& sensor) {
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const Quantity& each) { return each.name == sensor; });
  return found == quantities.end() ? nullptr : &*found;
}

bool is_there(const Quantity& quantity, ToolKind tool) {
  const std::string device = quantity.device;
  if (device == "gripper") return tool == ToolKind::gripper;
  return device != "range-finder" || tool == ToolKind::range_finder;
}

std::optional<double> nearest(const std::vector<double>& profile) {
  const std::size_t count = profile.size() / 3;  // y, z and valid of each, then when the scan began
  std::optional<double> result;
  for (std::size_t i = 0; i < count; ++i)
    if (profile[2 * count + i] != 0)
      result = std::min(result.value_or(profile[count + i]), profile[count + i]);
  return result;
}

}  // namespace

std::vector<SensorSpec> sensors_of(const Workcell& workcell) {
  std::vector<SensorSpec> result;
  for (const Quantity& each : quantities)
    if (is_there(each, workcell.tool_kind())) result.push_back({each.name, each.unit, each.description});
  for (const auto& [name, place] : workcell.fixed_sensors())
    result.push_back({name, "mm", "from this fixed sensor down to what it meets"});
  return result;
}

std::optional<std::pair<double, double>> sensor_range(const std::string& sensor) {
  const Quantity* known = find(sensor);
  if (known == nullptr) return std::nullopt;
  return std::pair(known->low, known->high);
}

std::optional<Source> source_of(const std::string& sensor) {
  const Quantity* quantity = find(sensor);
  if (quantity == nullptr) return std::nullopt;
  return Source{quantity->device, quantity->message};
}

std::optional<double> quantity(const std::string& sensor, const std::vector<double>& fields) {
  const Quantity* known = find(sensor);
  if (known == nullptr) return std::nullopt;
  if (known->message == std::string("profile")) return nearest(fields);
  return fields[known->field];
}

std::optional<double> read_fixed_sensor(const Workcell& workcell, const std::string& sensor, Random& noise) {
  const auto& sensors = workcell.fixed_sensors();
  const auto found = sensors.find(sensor);
  if (found == sensors.end()) return std::nullopt;
  const auto distance = workcell.cast(found->second, -Eigen::Vector3d::UnitZ());
  if (!distance) return std::nullopt;
  return 1000 * *distance + fixed_sensor_noise * noise.normal();
}

}  // namespace pal::sim
