// From a scene's description to MuJoCo's own format. Private to pal_sim.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/model/scene_description.hpp"

namespace pal::sim {

/// Heights of a height field, rows along y from its least to its greatest, each along x.
struct Heights {
  std::string name;  // of the height field in the MJCF
  int rows = 0;
  int columns = 0;
  double span = 0;            // mm between the least and the greatest height
  std::vector<float> values;  // 0 to 1, of that span
};

struct Mjcf {
  std::string text;
  std::vector<Heights> heights;  // to be filled in after loading
};

/// `file` names the scene in errors. Throws SceneError where a thing's figures do not go together.
Mjcf to_mjcf(const SceneDescription& description, const std::string& file);

/// Heights of waves (two rows) and of a surface with a seam (cells of 0.5 mm across it).
Heights wave_heights(const Thing& thing);
Heights surface_heights(const Thing& thing);
/// The seam of such a surface: points on it, mm from the middle of the field and above its least height.
std::vector<std::array<double, 3>> seam_of(const Thing& thing, const Heights& fine);
/// The same surface with a point in each eighth row and column, to touch: MuJoCo takes few contacts at a
/// time.
Heights coarser(const Heights& fine);

/// The assets and the body of one thing, MJCF. Appends the height field that it needs, if any.
struct Shape {
  std::string assets;
  std::string body;
};
Shape shape_of(const Thing& thing, bool table, const std::string& file, std::vector<Heights>& heights);

/// Materials that things use.
std::string thing_materials();

}  // namespace pal::sim
