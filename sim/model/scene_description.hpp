// A scene as plain values: the content of a .scene file, before MuJoCo sees any of it. Private to pal_sim.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/arm/kinematics.hpp"
#include "sim/arm/machine.hpp"
#include "sim/arm/tool.hpp"
#include "sim/scene.hpp"

namespace pal::sim {

/// A setting of a kind of thing: how many figures it has, and their ranges.
struct Setting {
  std::string_view name;
  std::size_t least = 1;  // figures
  std::size_t most = 1;
  std::array<double, 3> usual{};  // where the file says nothing
  double low = -1e9;              // of each figure
  double high = 1e9;
  std::string_view unit;
  bool needed = false;
};

/// A kind of thing that a scene can hold, with all its settings.
struct ThingKind {
  std::string_view name;
  std::string_view what;
  std::vector<Setting> settings;
};

/// All kinds, in the order of the documentation.
const std::vector<ThingKind>& thing_kinds();

/// One thing of a scene. Lengths in mm, angles in degrees, positions in frame 0.
struct Thing {
  std::string kind;
  std::string name;  // what people call it: "plate", "post 2", or the name in the file
  int line = 0;
  std::map<std::string, std::vector<double>, std::less<>>
      figures;  // each setting of the kind, given or usual
  bool given(std::string_view setting) const;
  double one(std::string_view setting) const { return figures.find(setting)->second[0]; }
  const std::vector<double>& all(std::string_view setting) const { return figures.find(setting)->second; }

  std::vector<std::string> said;  // the settings that the file gives
};

/// A location that VAL has been taught.
struct DescribedLocation {
  std::string name;
  std::array<double, 4> tip{};  // as a start
};

/// A distance sensor that is fixed in the cell and looks straight down.
struct DescribedSensor {
  std::string name;
  std::array<double, 3> at{};  // mm
};

struct SceneDescription {
  std::string about;
  ToolKind tool = ToolKind::pad;
  std::optional<std::array<double, 4>> start;  // x, y, z in mm, turn in degrees
  int start_line = 0;
  Configuration configuration{.righty = true, .above = true, .flip = true};
  bool table = true;
  MachineOptions machine;
  std::vector<Thing> things;
  std::vector<DescribedLocation> locations;
  std::vector<DescribedSensor> sensors;
};

/// The top of the table and the floor in frame 0, mm.
inline constexpr double table_top = -181.8;
inline constexpr double floor_height = -671.8;

/// Reads a .scene file. Throws SceneError with file and line.
SceneDescription read_description(const Scene& scene);

/// The same from text; `file` names it in errors.
SceneDescription parse_description(std::string_view text, const std::string& file);

}  // namespace pal::sim
