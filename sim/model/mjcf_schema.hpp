// The elements and attributes of MJCF. Private to pal_sim.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pal::sim {

/// One element of MJCF.
struct MjcfElement {
  std::vector<std::string> attributes;
  std::map<std::string, MjcfElement, std::less<>> children;
  bool once = false;   // at most one in its parent
  std::string nested;  // the name of a child that is of the element's own kind; empty: it has none

  /// The child of this name; null: there is none.
  const MjcfElement* child(std::string_view name) const;
};

/// <mujoco>, with all that it can hold: MuJoCo's own table.
const MjcfElement& mjcf_schema();

}  // namespace pal::sim
