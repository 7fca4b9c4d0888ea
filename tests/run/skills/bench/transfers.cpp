#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/workshop.hpp"

namespace pal::test {

namespace {

using Eigen::Vector3d;

constexpr double one_transfer = 0.3, six_transfers = 0.5;  // mm, to reach

double seconds(runtime::Time time) {
  return std::chrono::duration<double>(time).count();
}

/// Takes the part from PART to PLACE and back, three times.
void six_times(const std::string& machine, std::vector<Figure>& figures) {
  const ChangedScene changed("parts", "machine " + machine);
  Workshop shop(changed.scene());
  ProvedBounds pick("pick-at-location"), place("place-at-location");
  const Vector3d way = shop.location("PLACE") - shop.location("PART"), first = shop.middle("part");
  bool ended = true;
  double worst = 0;
  Vector3d before = first;
  for (int i = 0; i < 6; ++i) {
    const bool there = i % 2 == 0;
    const auto picked = shop.run("pick-at-location", {text("location", there ? "PART" : "PLACE")}, pick);
    const auto placed = shop.run("place-at-location", {text("location", there ? "PLACE" : "PART")}, place);
    ended = ended && picked.code == 0 && placed.code == 0 && picked.overruns + placed.overruns == 0;
    const Vector3d after = shop.middle("part");
    worst = std::max(worst, (after - before - (there ? way : Vector3d(-way))).norm());
    before = after;
  }
  const double drift = (before - first).norm();
  figures.push_back({"pick, place", fmt::format("305 mm there and back, three times, machine {}", machine),
                     fmt::format("{} mm a transfer, {} mm after six", one_transfer, six_transfers),
                     fmt::format("{:.3f} mm a transfer, {:.3f} mm after six", worst, drift),
                     ended && worst <= one_transfer && drift <= six_transfers,
                     std::max(pick.greatest_part(), place.greatest_part())});
}

/// Up by 25 mm, 305 mm across, down by 25 mm.
Figure cycle(bool feel) {
  Workshop shop(scene("parts"));
  ProvedBounds pick("pick-at-location"), place("place-at-location");
  const std::vector<runtime::ParameterValue> fast{
      {.name = "approach", .value = 25}, {.name = "speed", .value = 100}, {.name = "grip-delay", .value = 0}};
  const auto with = [&](const char* location) {
    auto parameters = fast;
    parameters.push_back(text("location", location));
    return parameters;
  };
  auto placing = with("PLACE");
  placing.push_back({.name = "feel", .value = feel ? 1.0 : 0.0});
  const auto picked = shop.run("pick-at-location", with("PART"), pick);
  const auto placed = shop.run("place-at-location", placing, place);
  return {"pick, place",
          fmt::format("cycle 25-305-25 mm at 100 %, no pause, {}",
                      feel ? "feeling on the way down" : "in one go"),
          "reported",
          fmt::format("{:.2f} s: pick {:.2f} s, place {:.2f} s",
                      seconds(picked.duration) + seconds(placed.duration), seconds(picked.duration),
                      seconds(placed.duration)),
          picked.code == 0 && placed.code == 0,
          std::max(pick.greatest_part(), place.greatest_part())};
}

}  // namespace

std::vector<Figure> measure_transfers() {
  std::vector<Figure> figures;
  for (const char* machine : {"exact", "seed 1", "seed 2", "seed 3"}) six_times(machine, figures);
  for (const bool feel : {true, false}) figures.push_back(cycle(feel));
  return figures;
}

std::vector<Figure> measure_palletize() {
  Workshop shop(scene("pallet"));
  ProvedBounds bounds("palletize");
  bool ended = true;
  double worst = 0;
  for (int i = 0; i < 4; ++i) {
    const std::string serial = std::to_string(i + 1);
    const auto picked =
        shop.run("pick-at-location", {text("location", "PART" + serial), {.name = "approach", .value = 100}});
    const auto placed = shop.run("palletize", {{.name = "placed", .value = static_cast<double>(i)}}, bounds);
    ended = ended && picked.code == 0 && placed.code == 0 && placed.overruns == 0;
    const Vector3d wanted = shop.location("CORNER") + 90.0 * Vector3d(i % 3, i / 3, 0);
    worst = std::max(worst, (shop.middle("part " + serial) - wanted).norm());
  }
  return {observed(
      {"palletize", "four parts into a tray of three by three", fmt::format("{} mm a part", one_transfer),
       fmt::format("{:.3f} mm", worst), ended && worst <= one_transfer},
      bounds)};
}

}  // namespace pal::test
