#include "tests/run/skills/endings/cases.hpp"
#include "tests/support/built_skills.hpp"

#include <utility>

namespace pal::test {

namespace {

runtime::ParameterValue named(const std::string& name, const std::string& text) {
  return {.name = name, .text = text};
}

/// Each parameter alone at each end of its range; `kept` are not touched, and stand in all.
std::vector<Parameters> corners(const std::string& skill, const Parameters& kept = {}) {
  std::vector<Parameters> result;
  const auto made = test::make_skill(skill);
  for (const runtime::ParameterSpec& each : made->description().parameters) {
    bool fixed = each.type == runtime::ParameterType::text;
    for (const runtime::ParameterValue& keep : kept) fixed = fixed || keep.name == each.name;
    if (fixed) continue;
    const bool boolean = each.type == runtime::ParameterType::boolean;
    for (const double value : {boolean ? 0.0 : each.low, boolean ? 1.0 : each.high}) {
      if (value == each.default_value) continue;
      Parameters corner = kept;
      corner.push_back({.name = std::string(each.name), .value = value});
      result.push_back(corner);
    }
  }
  return result;
}

class Cases {
 public:
  /// One set of parameters in several scenes.
  void scenes(EndingCase base, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      base.scene = name;
      add(base);
    }
  }
  void corners_of(EndingCase base) {
    for (const Parameters& corner : corners(base.skill, base.parameters)) {
      base.parameters = corner;
      add(base);
    }
  }
  void add(EndingCase one) { cases_.push_back(std::move(one)); }
  std::vector<EndingCase> take() { return std::move(cases_); }

 private:
  std::vector<EndingCase> cases_;
};

// With the pad: touch, press and rub, from free air and from contact.
void pad(Cases& cases) {
  const std::vector<std::string> all{
      "touch", "plate-1",    "plate-5", "plate-20",          "sponge",        "waves",
      "step",  "rub-tilted", "nothing", "bar-under-forearm", "edge-of-reach", "out-of-reach"};
  const std::vector<std::string> met{"touch",  "plate-1", "plate-5", "plate-20",
                                     "sponge", "waves",   "step",    "rub-tilted"};
  for (const std::string skill : {"touch", "press", "rub"}) {
    cases.scenes({.skill = skill, .scene = {}}, all);
    cases.scenes({.skill = skill, .scene = {}, .before = {{"touch"}}, .begins = "after touch"}, met);
    cases.corners_of({.skill = skill, .scene = "touch"});
    cases.corners_of({.skill = skill, .scene = "touch", .before = {{"touch"}}, .begins = "after touch"});
  }
  cases.add({.skill = "press",
             .scene = "touch",
             .before = {{"rub", {{.name = "distance", .value = 2}}}},
             .begins = "after rub"});
  cases.add({.skill = "rub", .scene = "touch", .before = {{"press"}}, .begins = "after press"});
  for (const double stop : {7.0, 20.0})
    for (const char* scene : {"touch", "plate-1"})
      cases.add({.skill = "press",
                 .scene = scene,
                 .parameters = {{.name = "stop-force", .value = stop},
                                {.name = "approach-speed", .value = 40},
                                {.name = "stiffness", .value = 3}}});
  cases.add({.skill = "rub",
             .scene = "step",
             .parameters = {{.name = "stop-force", .value = 300}, {.name = "speed", .value = 1}}});
  // Off what it rubs.
  for (const char* scene : {"touch", "sponge", "plate-5", "step"})
    for (const double direction : {90.0, 180.0})
      cases.add({.skill = "rub",
                 .scene = scene,
                 .parameters = {{.name = "direction", .value = direction},
                                {.name = "distance", .value = 20},
                                {.name = "speed", .value = 0.8}}});
}

void range_finder(Cases& cases) {
  cases.scenes({.skill = "standoff", .scene = {}},
               {"flat", "tilted", "tilted-plates", "pyramid", "block-edges", "seam"});
  cases.corners_of({.skill = "standoff", .scene = "low-plate"});
  cases.scenes({.skill = "align", .scene = {}},
               {"flat", "tilted", "pyramid", "near-limit", "near-singularity"});
  cases.corners_of({.skill = "align", .scene = "tilted"});
  cases.scenes({.skill = "follow-edge", .scene = {}},
               {"seam", "flat", "seam-crease", "seam-step", "seam-wide", "seam-end"});
  cases.corners_of({.skill = "follow-edge", .scene = "seam-wide"});
  cases.corners_of(
      {.skill = "follow-edge", .scene = "seam-wide", .parameters = {{.name = "track", .value = 0.84}}});
  cases.corners_of(
      {.skill = "follow-edge", .scene = "seam-wide", .parameters = {{.name = "literal", .value = 1}}});
}

void moves(Cases& cases) {
  for (const std::string skill : {"move-cartesian", "relative-move"}) {
    cases.scenes({.skill = skill, .scene = {}},
                 {"nothing", "parts", "flat", "near-limit", "near-singularity", "edge-of-reach"});
    cases.corners_of({.skill = skill, .scene = "nothing"});
    cases.corners_of({.skill = skill, .scene = "posts"});
  }
  cases.add({.skill = "relative-move",
             .scene = "touch",
             .before = {{"touch"}},
             .begins = "after touch",
             .parameters = {{.name = "dz", .value = -20}}});
  cases.add({.skill = "relative-move",
             .scene = "touch",
             .before = {{"touch"}},
             .begins = "after touch",
             .parameters = {{.name = "dz", .value = 20}}});
  for (const char* location : {"HOME", "PART", "PLACE", "BEYOND", "NOWHERE"})
    for (const double straight : {0.0, 1.0})
      cases.add({.skill = "move-to-location",
                 .scene = "posts",
                 .parameters = {named("location", location), {.name = "straight", .value = straight}}});
  cases.add(
      {.skill = "move-to-location", .scene = "out-of-reach", .parameters = {named("location", "HOME")}});
  cases.corners_of(
      {.skill = "move-to-location", .scene = "parts", .parameters = {named("location", "PLACE")}});
}

void transfers(Cases& cases) {
  const Parameters at_part1{named("location", "PART1"), {.name = "approach", .value = 100}};
  cases.scenes({.skill = "pick-at-location", .scene = {}}, {"parts", "empty-place", "pallet", "posts"});
  cases.corners_of({.skill = "pick-at-location", .scene = "parts"});
  cases.corners_of({.skill = "pick-at-location", .scene = "empty-place"});
  // Heavier and heavier: 48 N of friction hold 4.9 kg at rest.
  for (const char* mass : {"1000", "3000", "4500", "5000"})
    cases.add({.skill = "pick-at-location",
               .scene = "heavy-part",
               .lines = std::string("part at 460 -200 mass ") + mass,
               .begins = std::string("part of ") + mass + " g"});

  const std::vector<Before> picked{{"pick-at-location"}};
  const std::vector<Before> picked_high{{"pick-at-location", at_part1}};
  cases.add({.skill = "place-at-location", .scene = "parts", .begins = "empty"});
  cases.add({.skill = "place-at-location", .scene = "parts", .before = picked, .begins = "holds"});
  cases.corners_of({.skill = "place-at-location", .scene = "parts", .before = picked, .begins = "holds"});
  cases.corners_of({.skill = "place-at-location",
                    .scene = "pallet",
                    .before = picked_high,
                    .begins = "holds",
                    .parameters = {{.name = "approach", .value = 100}}});
  for (const char* mass : {"1000", "3000", "4500", "4800"})
    for (const double speed : {50.0, 100.0})
      cases.add({.skill = "place-at-location",
                 .scene = "heavy-part",
                 .lines = std::string("part at 460 -200 mass ") + mass,
                 .before = picked,
                 .begins = std::string("holds ") + mass + " g",
                 .parameters = {{.name = "speed", .value = speed}}});
  cases.add({.skill = "palletize", .scene = "pallet", .begins = "empty"});
  cases.add({.skill = "palletize", .scene = "pallet", .before = picked_high, .begins = "holds"});
  cases.corners_of({.skill = "palletize", .scene = "pallet", .before = picked_high, .begins = "holds"});
  cases.add({.skill = "palletize",
             .scene = "pallet",
             .before = picked_high,
             .begins = "holds",
             .parameters = {named("corner", "PLACE")}});
}

}  // namespace

std::vector<EndingCase> ending_cases() {
  Cases cases;
  pad(cases);
  range_finder(cases);
  moves(cases);
  transfers(cases);
  return cases.take();
}

}  // namespace pal::test
