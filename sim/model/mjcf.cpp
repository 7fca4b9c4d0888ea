#include "sim/model/mjcf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sim/model/embedded.hpp"

namespace pal::sim {
namespace {

// The text between two marks replaced, marks included.
std::string replaced(std::string_view text, std::string_view begin, std::string_view end,
                     std::string_view by) {
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find(end);
  if (from == std::string_view::npos || to == std::string_view::npos)
    throw std::logic_error("the machine's MJCF has lost its mark " + std::string(begin));
  return std::string(text.substr(0, from)) + std::string(by) + std::string(text.substr(to + end.size()));
}

// What stands inside <mujoco> of a whole document.
std::string inside(std::string_view document) {
  const std::size_t begin = document.find('>', document.find("<mujoco")) + 1;
  return std::string(document.substr(begin, document.rfind("</mujoco>") - begin));
}

std::string arm(ToolKind tool) {
  if (tool == ToolKind::pad) return inside(embedded::puma560);
  return inside(replaced(embedded::puma560, "<!-- tool begins -->", "<!-- tool ends -->",
                         tool == ToolKind::gripper ? embedded::gripper : embedded::range_finder));
}

std::string cell(bool table) {
  if (table) return inside(embedded::cell);
  return inside(replaced(embedded::cell, "<!-- table begins -->", "<!-- table ends -->", ""));
}

// Room for constraints and contacts: what the arm needs, a box on a flat surface for each part, and the
// facets of a surface.
std::string room(const SceneDescription& description) {
  const auto parts = std::count_if(description.things.begin(), description.things.end(),
                                   [](const Thing& thing) { return thing.kind == "part"; });
  const auto surfaces = std::count_if(description.things.begin(), description.things.end(),
                                      [](const Thing& thing) { return thing.kind == "surface"; });
  return fmt::format("<size njmax=\"{}\" nconmax=\"{}\"/>\n", 400 + 60 * parts + 400 * surfaces,
                     100 + 20 * parts + 100 * surfaces);
}

}  // namespace

Mjcf to_mjcf(const SceneDescription& description, const std::string& file) {
  Mjcf mjcf;
  std::string assets = thing_materials(), bodies;
  for (const Thing& thing : description.things) {
    const Shape shape = shape_of(thing, description.table, file, mjcf.heights);
    assets += shape.assets;
    bodies += shape.body;
  }
  mjcf.text = "<mujoco model=\"scene\">\n" + arm(description.tool) + cell(description.table) +
              (description.tool == ToolKind::gripper ? std::string(embedded::gripper_drives) : "") +
              room(description) + "<asset>\n" + assets + "</asset>\n<worldbody>\n" + bodies +
              "</worldbody>\n</mujoco>\n";
  return mjcf;
}

}  // namespace pal::sim
