#include "programs/workcell/session/skill_figures.hpp"

#include <algorithm>
#include <cmath>

#include "sim/val/transformation.hpp"

namespace pal::workcell {

operations::Sensors figures_of_skills() {
  return {{"x", {"mm", "where the tool's tip is at the skill's end, along x of the arm"}},
          {"y", {"mm", "likewise along y"}},
          {"z", {"mm", "likewise along z"}},
          {"duration", {"s", "how long the skill took"}},
          {"distance", {"mm", "how far the tool's tip is at the end from where it was at the beginning"}},
          {"force", {"N", "how hard the tool pressed along its axis at the last reading of the skill"}},
          {"greatest-force", {"N", "… at the greatest reading of the skill"}},
          {"mean-force", {"N", "the mean of all readings of the skill"}},
          {"rms-force", {"N", "the root of their mean square"}}};
}

void SkillFigures::begin(const sim::Workcell& workcell) {
  force_.reset();
  greatest_force_.reset();
  sum_ = squares_ = 0;
  readings_ = 0;
  from_ = workcell.tool().translation();
}

void SkillFigures::passed(runtime::Time when, const runtime::Device& device, std::size_t port,
                          std::span<const double> fields) {
  constexpr std::size_t force_z = 2, axes = 6;
  const std::string_view message = device.ports()[port].message;
  if (device.name() == "force-torque" && (message == "wrench" || message == "record") &&
      fields.size() >= axes) {
    force_ = -fields[force_z];  // pressing is negative there
    greatest_force_ = std::max(greatest_force_.value_or(*force_), *force_);
    sum_ += *force_;
    squares_ += *force_ * *force_;
    ++readings_;
  }
  if (next_ != nullptr) next_->passed(when, device, port, fields);
}

void SkillFigures::forgotten(const runtime::Device& device, std::size_t port) {
  if (next_ != nullptr) next_->forgotten(device, port);
}

std::vector<operations::Figure> SkillFigures::end(const sim::Workcell& workcell,
                                                  runtime::Time duration) const {
  const auto place = sim::val::shown_figures(workcell.tool());
  std::vector<operations::Figure> result{{"x", place[0]}, {"y", place[1]}, {"z", place[2]}};
  result.push_back({"duration", std::chrono::duration<double>(duration).count()});
  constexpr double mm = 1000;
  result.push_back({"distance", mm * (workcell.tool().translation() - from_).norm()});
  if (force_) result.push_back({"force", *force_});
  if (greatest_force_) result.push_back({"greatest-force", *greatest_force_});
  if (readings_ > 0) {
    const auto count = static_cast<double>(readings_);
    result.push_back({"mean-force", sum_ / count});
    result.push_back({"rms-force", std::sqrt(squares_ / count)});
  }
  return result;
}

}  // namespace pal::workcell
