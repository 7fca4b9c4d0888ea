// Tests and waits: does the cell have the sensor that they read?
#include <fmt/format.h>

#include "operations/check.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/nearest.hpp"

namespace pal::operations {

void check_sensors(const Program& program, const Sensors& sensors, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  std::string list;
  for (const auto& [name, sensor] : sensors) {
    names.push_back(name);
    list += (list.empty() ? "it has " : ", ") + name;
  }
  for (const Operation& operation : program.operations) {
    for (const Icon& icon : operation.icons) {
      if (icon.sensor.empty() || sensors.contains(icon.sensor)) continue;
      const auto near = nearest(icon.sensor, names);
      diagnostics.report(Code::PAL1017, icon.subject, fmt::format("the cell has no sensor '{}'", icon.sensor),
                         near           ? fmt::format("did you mean '{}'?", *near)
                         : list.empty() ? std::string("it has none")
                                        : list);
    }
  }
}

}  // namespace pal::operations
