// The kinds of thing that a scene may place: plates, parts, posts.
#include "sim/model/scene_description.hpp"

namespace pal::sim {
namespace {

constexpr double reach = 2000;  // mm: nothing that the arm could meet is farther

// Where a thing stands: the middle of its underside. Without a height it stands on the table.
constexpr Setting at{"at", 2, 3, {0, 0, table_top}, -reach, reach, "mm", true};
constexpr Setting turn{"turn", 1, 1, {0}, -360, 360, "degrees"};

constexpr Setting size(double x, double y, double z) {
  return {"size", 3, 3, {x, y, z}, 1, reach, "mm"};
}
constexpr Setting length(std::string_view name, double usual, double low, double high) {
  return {name, 1, 1, {usual}, low, high, "mm"};
}
constexpr Setting count(std::string_view name, double usual, double high) {
  return {name, 1, 1, {usual}, 1, high, "pieces"};
}

}  // namespace

const std::vector<ThingKind>& thing_kinds() {
  static const std::vector<ThingKind> kinds{
      {"plate",
       "a steel plate; with a stiffness it gives way on a spring, with a tilt it leans about its top's "
       "middle",
       {at,
        size(240, 240, 15),
        turn,
        {"tilt", 2, 2, {0, 0}, -45, 45, "degrees"},
        {"stiffness", 1, 1, {0}, 0.1, 1000, "N/mm"}}},
      {"sponge",
       "soft: gives way on a spring that swallows motion",
       {at, size(160, 160, 40), turn, {"stiffness", 1, 1, {1}, 0.1, 1000, "N/mm"}}},
      {"waves",
       "a surface to rub: waves along x, size is up to their crests",
       {at, size(240, 120, 25), turn, length("height", 4, 0.1, 100), length("length", 80, 5, 1000)}},
      {"block", "a steel block with square edges", {at, size(80, 80, 40), turn}},
      {"bar",
       "a round bar lying along x, at its middle",
       {at, length("length", 400, 10, reach), length("diameter", 30, 2, 300), turn}},
      {"post", "a round post", {at, length("height", 300, 1, reach), length("diameter", 30, 2, 300)}},
      {"pyramid",
       "square steps, each smaller by the same width",
       {at, size(120, 120, 60), turn, count("steps", 4, 20)}},
      {"surface",
       "an undulating surface with a seam along x; the tool meets it in facets of 4 by 10 mm",
       {at,
        size(300, 160, 40),
        turn,
        length("height", 8, 0, 100),
        length("length", 200, 20, 1000),
        {"slope", 1, 1, {15}, 0, 45, "degrees"},
        length("step", 0, 0, 50),
        length("swing", 10, 0, 60)}},
      {"pallet",
       "a tray with a square place for each part, counted along x, then y; at its middle",
       {at, count("rows", 3, 10), count("columns", 3, 10), length("pitch", 80, 20, 200), turn}},
      {"part",
       "a loose part that can be grasped",
       {at, size(50, 50, 50), turn, {"mass", 1, 1, {200}, 1, 5000, "g"}}}};
  return kinds;
}

}  // namespace pal::sim
