#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/cell/device_views.hpp"
#include "tests/run/skills/endings/truth.hpp"
#include "tests/run/skills/support/seam.hpp"

namespace pal::test {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double sensor = 0.25;   // N: half a step, the noise's mean, and the zero
constexpr double touching = 0.3;  // N
constexpr double there = 0.2;     // mm: counts, play, and where the encoders are asked
constexpr double edge_known = 4, edge_known_literal = 6;  // mm, as the template says
constexpr double opened = 79;                             // mm between the fingers
constexpr double sensor_most = 60;                        // N that a skill promises not to exceed

std::string unless(bool so, std::string untrue) {
  return so ? std::string() : std::move(untrue);
}

std::string all(std::initializer_list<std::string> parts) {
  for (const std::string& part : parts)
    if (!part.empty()) return part;
  return {};
}

std::string still(const Ended& ended) {
  return unless(ended.stands_still(), "it moves");
}
std::string free_of_all(const Ended& ended) {
  return unless(ended.after().contact_force == 0,
                fmt::format("presses with {:.1f} N", ended.after().contact_force));
}
std::string where_it_began(const Ended& ended) {
  return unless(ended.moved() < there, fmt::format("{:.2f} mm from where it began", ended.moved()));
}
std::string lifted_off(const Ended& ended) {
  return all({free_of_all(ended), still(ended)});
}
double peak(const Ended& ended) {
  double most = 0;
  for (const sim::Sample& sample : ended.during()) most = std::max(most, sample.contact_force);
  return most;
}
// Also by what the fingers hold: the contact force is that of the tool alone.
double pressed(const Ended& ended) {
  double most = 0;
  for (const sim::Sample& sample : ended.during()) most = std::max(most, ended.pressing(sample));
  return most;
}
std::string reached(const Ended& ended, double force) {
  double most = 0;
  for (const sim::Sample& sample : ended.during())
    most = std::max(
        {most, std::abs(ended.pressing(sample)), sample.wrench.force.head<2>().cwiseAbs().maxCoeff()});
  return unless(most >= force - 2, fmt::format("only {:.1f} N were met", most));
}

Judgement touch(const Ended& ended) {
  const double rest = ended.after().contact_force;
  switch (ended.outcome.code) {
    case 0:
      return {"N at rest", rest,
              all({unless(rest > touching, "touches nothing"), still(ended),
                   unless(rest < sensor_most + 5, "overloads the sensor")})};
    case 1:
      return {"N at the most", peak(ended),
              all({where_it_began(ended), still(ended),
                   unless(peak(ended) < ended.parameter("threshold") + sensor, "the threshold was met")})};
    default:
      return {"N at rest", rest, still(ended)};
  }
}

Judgement press(const Ended& ended) {
  const double rest = ended.pressing(ended.after()), force = ended.parameter("force");
  switch (ended.outcome.code) {
    case 0: {
      const double time = ended.parameter("time"), band = ended.parameter("band");
      const auto during = ended.during();
      const auto held = during.last(std::min(during.size(), static_cast<std::size_t>(1e3 * time)));
      double worst = std::abs(rest - force);
      for (const sim::Sample& sample : held)
        worst = std::max(worst, std::abs(ended.pressing(sample) - force));
      return {"N off while it holds", worst,
              all({unless(worst <= band + sensor, fmt::format("{:.2f} N off", worst)), still(ended)})};
    }
    case 1:
      return {"N at the most", peak(ended), all({where_it_began(ended), free_of_all(ended), still(ended)})};
    case 2:
      return {"N at the most", peak(ended),
              all({reached(ended, ended.parameter("stop-force")), lifted_off(ended)})};
    default:
      return {"N at rest", rest, still(ended)};
  }
}

// While it slides: from the first motion along the surface to the end.
Judgement rub(const Ended& ended) {
  const double rest = ended.pressing(ended.after());
  const double softest = -ended.parameter("least-force") / 20,
               hardest = -ended.parameter("greatest-force") / 20;
  switch (ended.outcome.code) {
    case 0: {
      const double angle = ended.parameter("direction") * degree;
      const Eigen::Vector3d way =
          ended.before.tool_turn * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
      const double gone = 1e3 * (ended.after().tool - ended.before.tool).dot(way);
      int in_air = 0, longest = 0;
      bool landed = false;  // on its way down the tool may leave its line by more than 0.1 mm, too
      for (const sim::Sample& sample : ended.during()) {
        landed = landed || sample.contact_force > touching;
        const bool slides = landed && 1e3 * std::abs((sample.tool - ended.before.tool).dot(way)) > 0.1;
        in_air = slides && sample.contact_force < 0.01 ? in_air + 1 : 0;
        longest = std::max(longest, in_air);
      }
      return {"N at rest", rest,
              all({unless(std::abs(gone - 10 * ended.parameter("distance")) < 1,
                          fmt::format("has gone {:.1f} mm", gone)),
                   unless(rest > softest - sensor && rest < hardest + sensor,
                          fmt::format("{:.1f} N at the end", rest)),
                   unless(longest < 200, fmt::format("{} ms in the air", longest)), still(ended)})};
    }
    case 1:
      return {"N at the most", peak(ended),
              all({reached(ended, ended.parameter("stop-force") / 20), lifted_off(ended)})};
    default:
      return {"N at rest", rest, still(ended)};
  }
}

// The nearest that a scan from here would meet, mm.
std::optional<double> nearest(const Ended& ended) {
  const auto view = sim::range_view(ended.shop.cell().workcell());
  const auto pose = view.pose();
  std::optional<double> least;
  for (double angle = -20; angle <= 20; angle += 0.1) {
    const Eigen::Vector3d ray(0, std::sin(angle * degree), std::cos(angle * degree));
    if (const auto met = view.cast(pose.translation(), pose.linear() * ray)) {
      const double z = 1e3 * *met * ray.z();
      least = std::min(least.value_or(z), z);
    }
  }
  return least;
}

Judgement standoff(const Ended& ended) {
  const double distance = nearest(ended).value_or(0);
  switch (ended.outcome.code) {
    case 0: {
      const double off = std::abs(distance - ended.parameter("distance"));
      return {"mm off", off,
              all({unless(off <= ended.parameter("tolerance") + 0.1, fmt::format("{:.2f} mm off", off)),
                   still(ended)})};
    }
    case 1:
      return {"mm to the nearest", distance,
              all({unless(distance < 100.2 || distance > 449.5,
                          fmt::format("a surface is at {:.1f} mm", distance)),
                   still(ended)})};
    default:
      return {"mm to the nearest", distance, still(ended)};
  }
}

// By three rays: how far the tool's axis is from the surface's normal, deg.
std::optional<double> off_normal(const Ended& ended) {
  const auto view = sim::range_view(ended.shop.cell().workcell());
  const auto pose = view.pose();
  std::array<Eigen::Vector3d, 3> met;
  for (std::size_t i = 0; i < 3; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / 3;
    const Eigen::Vector3d ray(0.05 * std::cos(turn), 0.05 * std::sin(turn), 1);
    const auto distance = view.cast(pose.translation(), pose.linear() * ray);
    if (!distance) return std::nullopt;
    met[i] = *distance * ray.normalized();
  }
  const Eigen::Vector3d normal = (met[1] - met[0]).cross(met[2] - met[0]).normalized();
  return std::acos(std::min(1.0, std::abs(normal.z()))) / degree;
}

Judgement align(const Ended& ended) {
  const double off = off_normal(ended).value_or(90);
  if (ended.outcome.code != 0) return {"deg off", off, still(ended)};
  return {"deg off", off,
          all({unless(off <= 1.5 * ended.parameter("tolerance") + 0.1, fmt::format("{:.2f} deg off", off)),
               still(ended)})};
}

// What the tool's axis meets is about where an edge would be.
bool looks_at_something(const Ended& ended, double standoff) {
  const sim::Workcell& workcell = ended.shop.cell().workcell();
  const auto met = workcell.cast(workcell.tool().translation(), workcell.tool().linear().col(2));
  return met && std::abs(1e3 * *met - standoff) < 12;
}

// Along the seam of seam.scene and of those like it.
Judgement follow_edge(const Ended& ended) {
  const Seam seam;
  const double standoff = 10 * ended.parameter("standoff");
  const auto at_edge = [&](const sim::Sample& sample) {
    return Eigen::Vector3d(1e3 * sample.tool + sample.tool_turn * Eigen::Vector3d(0, 0, standoff));
  };
  const double begun = at_edge(ended.before).x(), gone = at_edge(ended.after()).x() - begun;
  double worst = 0;
  for (const sim::Sample& sample : ended.during())
    if (at_edge(sample).x() - begun > 3) worst = std::max(worst, off(seam, sample, standoff).length);
  const double rest = off(seam, ended.after(), standoff).length;
  const double known =
      ended.parameter("literal") != 0 ? edge_known_literal + 2 * ended.parameter("translation") : edge_known;
  switch (ended.outcome.code) {
    case 0:
      return {"mm off at the most", worst,
              all({unless(worst <= known, fmt::format("{:.1f} mm off", worst)),
                   unless(rest <= known, fmt::format("ends {:.1f} mm off", rest)),
                   unless(std::abs(gone - 10 * ended.parameter("distance")) <
                              0.05 * 10 * ended.parameter("distance") + 3,
                          fmt::format("has gone {:.1f} mm", gone)),
                   still(ended)})};
    case 1:
      return {"mm off at the end", rest,
              all({unless(rest > 2.5 || !looks_at_something(ended, standoff),
                          fmt::format("the edge is {:.1f} mm from where it should be", rest)),
                   still(ended)})};
    default:
      return {"mm off at the end", rest, still(ended)};
  }
}

std::string pose_is(const Ended& ended, const sim::Pose& wanted) {
  const double length = 1e3 * (ended.after().tool - wanted.translation()).norm();
  const double turn = ended.after().tool_turn.angularDistance(Eigen::Quaterniond(wanted.linear())) / degree;
  return unless(length < there && turn < 0.1, fmt::format("{:.2f} mm, {:.2f} deg from there", length, turn));
}

Judgement motion(const Ended& ended, const std::optional<sim::Pose>& goal) {
  switch (ended.outcome.code) {
    case 0:
      return {"mm moved", ended.moved(), all({goal ? pose_is(ended, *goal) : std::string(), still(ended)})};
    case 1:
      return {"mm moved", ended.moved(), all({where_it_began(ended), still(ended)})};
    default:
      return {"mm moved", ended.moved(), still(ended)};
  }
}

Judgement move_to_location(const Ended& ended) {
  const auto& known = ended.shop.cell().val_store().locations;
  const auto found = known.find(ended.text("location"));
  return motion(ended, found == known.end() ? std::nullopt : std::optional<sim::Pose>(found->second));
}

Judgement move_cartesian(const Ended& ended) {
  if (ended.outcome.code != 0) return motion(ended, std::nullopt);
  const Eigen::Vector3d wanted(ended.parameter("x"), ended.parameter("y"), ended.parameter("z"));
  const double off = (1e3 * ended.after().tool - wanted).norm();
  return {"mm off", off, all({unless(off < there, fmt::format("{:.2f} mm off", off)), still(ended)})};
}

Judgement relative_move(const Ended& ended) {
  if (ended.outcome.code != 0) return motion(ended, std::nullopt);
  const Eigen::Vector3d way(ended.parameter("dx"), ended.parameter("dy"), ended.parameter("dz"));
  const double off = (1e3 * (ended.after().tool - ended.before.tool) - ended.before.tool_turn * way).norm();
  return {"mm off", off, all({unless(off < 2 * there, fmt::format("{:.2f} mm off", off)), still(ended)})};
}

// Above a location, along the tool's own axis there.
std::string above(const Ended& ended, const std::string& location) {
  const sim::Pose pose = ended.shop.cell().val_store().locations.at(location);
  const Eigen::Vector3d wanted =
      1e3 * pose.translation() - ended.parameter("approach") * pose.linear().col(2);
  const double off = (1e3 * ended.after().tool - wanted).norm();
  return unless(off < there, fmt::format("{:.2f} mm from above {}", off, location));
}

bool holds(const Ended& ended) {
  return ended.shop.cell().workcell().holds_part();
}

Judgement pick(const Ended& ended) {
  const double width = ended.shop.cell().workcell().gripper_width();
  const auto now = [&] { return all({above(ended, ended.text("location")), still(ended)}); };
  switch (ended.outcome.code) {
    case 0:
      return {"mm between the fingers", width,
              all({unless(holds(ended), "the fingers hold nothing"), now()})};
    case 1:
    case 3:
      return {"mm between the fingers", width,
              all({unless(!holds(ended), "the fingers hold a part"),
                   unless(width > opened, "the fingers are not open"), now()})};
    default:
      return {"mm between the fingers", width, still(ended)};
  }
}

// The part that was held moved there; which one it is the fingers do not say.
std::string part_is_at(const Ended& ended, const Eigen::Vector3d& place) {
  double least = 1e9;
  for (const auto& [name, was] : ended.things_before) {
    const Eigen::Vector3d off = ended.shop.middle(name) - place;
    least = std::min(least, off.head<2>().norm());
  }
  return unless(least < 2, fmt::format("the next part is {:.1f} mm beside the place", least));
}

std::string held_above(const Ended& ended, const std::string& location) {
  return all({unless(holds(ended), "the fingers hold nothing"), above(ended, location), still(ended)});
}

Judgement place(const Ended& ended) {
  const std::string location = ended.text("location");
  const double width = ended.shop.cell().workcell().gripper_width();
  switch (ended.outcome.code) {
    case 0:
      return {"N pressed at the most", pressed(ended),
              all({part_is_at(ended, ended.shop.location(location)),
                   unless(width > opened, "the fingers are not open"),
                   unless(!holds(ended), "the fingers hold a part"), above(ended, location), still(ended)})};
    case 1:
      if (!ended.held_before) return {"N pressed at the most", pressed(ended), where_it_began(ended)};
      return {"N pressed at the most", pressed(ended), held_above(ended, location)};
    default:
      return {"N pressed at the most", pressed(ended), still(ended)};
  }
}

Judgement palletize(const Ended& ended) {
  const int placed = static_cast<int>(ended.parameter("placed")),
            columns = static_cast<int>(ended.parameter("columns"));
  const double pitch = ended.parameter("pitch");
  const double width = ended.shop.cell().workcell().gripper_width();
  switch (ended.outcome.code) {
    case 0:
      return {"N pressed at the most", pressed(ended),
              all({part_is_at(ended, ended.shop.location(ended.text("corner")) +
                                         pitch * Eigen::Vector3d(placed % columns, placed / columns, 0)),
                   unless(width > opened, "the fingers are not open"),
                   unless(!holds(ended), "the fingers hold a part"), still(ended)})};
    case 1:
      return {"N pressed at the most", pressed(ended), where_it_began(ended)};
    case 3:
      return {"N pressed at the most", pressed(ended),
              all({unless(holds(ended), "the fingers hold nothing"), still(ended)})};
    default:
      return {"N pressed at the most", pressed(ended), still(ended)};
  }
}

}  // namespace

Judgement judge(const Ended& ended) {
  static const std::map<std::string, Judgement (*)(const Ended&)> judges{
      {"align", align},
      {"follow-edge", follow_edge},
      {"move-cartesian", move_cartesian},
      {"move-to-location", move_to_location},
      {"palletize", palletize},
      {"pick-at-location", pick},
      {"place-at-location", place},
      {"press", press},
      {"relative-move", relative_move},
      {"rub", rub},
      {"standoff", standoff},
      {"touch", touch},
      {"touch-read-first", touch}};
  const auto found = judges.find(ended.outcome.trace.skill);
  if (found == judges.end()) throw std::runtime_error("no judge for " + ended.outcome.trace.skill);
  return found->second(ended);
}

}  // namespace pal::test
