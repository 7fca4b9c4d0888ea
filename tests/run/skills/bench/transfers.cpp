#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tests/run/skills/bench/table.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"
#include "tests/run/skills/support/skill_cell.hpp"

namespace pal::test {

namespace {

constexpr double middle = -156.8;  // mm: of a block of 50 mm on the table
constexpr double near_y = -290, far_y = 15;

/// The middle of the block that stands about there, found by rays from its four sides; mm.
Eigen::Vector2d block_at(const sim::Workcell& workcell, double x, double y) {
  constexpr double away = 60;
  const auto side = [&](double dx, double dy) {
    const Eigen::Vector3d from(x + away * dx, y + away * dy, middle);
    const auto met = workcell.cast(from * 1e-3, Eigen::Vector3d(-dx, -dy, 0));
    if (!met || *met * 1e3 > 2 * away) throw std::runtime_error("there is no block");
    return away - *met * 1e3;
  };
  return {x + (side(1, 0) - side(-1, 0)) / 2, y + (side(0, 1) - side(0, -1)) / 2};
}

}  // namespace

std::vector<Figure> measure_transfers() {
  ProvedBounds picks("pick-at-location"), places("place-at-location");
  SkillCell cell("transfer");
  cell.teach("NEAR", 460, near_y, middle);
  cell.teach("FAR", 460, far_y, middle);
  const std::vector<runtime::ParameterValue> fast{{"approach", 25}, {"speed", 100}, {"grip-delay", 0.3}};
  const Eigen::Vector2d start = block_at(cell.workcell(), 460, near_y);
  double worst_one = 0, last = 0, cycle = 0;
  bool ended = true;
  Eigen::Vector2d before = start;
  for (int i = 0; i < 6; ++i) {
    const bool there = i % 2 == 0;
    auto from = fast, to = fast;
    from.push_back(text("location", there ? "NEAR" : "FAR"));
    to.push_back(text("location", there ? "FAR" : "NEAR"));
    const auto picked = cell.run("pick-at-location", from);
    const auto placed = cell.run("place-at-location", to);
    picks.observe(picked.trace);
    places.observe(placed.trace);
    ended = ended && picked.code == 0 && placed.code == 0;
    if (!ended)
      throw std::runtime_error("transfer " + std::to_string(i + 1) + ": " + picked.reason + " " +
                               placed.reason);
    cycle = std::chrono::duration<double>(picked.duration + placed.duration).count();
    const double y = there ? far_y : near_y;
    const Eigen::Vector2d now = block_at(cell.workcell(), 460, y);
    const Eigen::Vector2d shift(0, there ? far_y - near_y : near_y - far_y);
    worst_one = std::max(worst_one, (now - before - shift).norm());
    last = (now - start - Eigen::Vector2d(0, y - near_y)).norm();
    before = now;
  }
  const double part = std::max(picks.greatest_part(), places.greatest_part());
  return {{"pick-at-location, place-at-location",
           "a block of 50 mm, 25-305-25 mm six times, scene transfer, seed 1",
           "0.3 mm a transfer, 0.5 mm after six",
           fmt::format("{:.2f} mm a transfer at most, {:.2f} mm after six; cycle {:.2f} s", worst_one, last,
                       cycle),
           ended && worst_one <= 0.3 && last <= 0.5, part}};
}

}  // namespace pal::test
