#include "programs/workcell/session/skill_figures.hpp"

#include <algorithm>

#include "sim/val/transformation.hpp"

namespace pal::workcell {

operations::Sensors figures_of_skills() {
  return {{"x", {"mm", "where the tool's tip is at the skill's end, along x of the arm"}},
          {"y", {"mm", "likewise along y"}},
          {"z", {"mm", "likewise along z"}},
          {"duration", {"s", "how long the skill took"}},
          {"force", {"N", "how hard the tool pressed along its axis at the last reading of the skill"}},
          {"greatest-force", {"N", "… at the greatest reading of the skill"}}};
}

void SkillFigures::begin() {
  force_.reset();
  greatest_force_.reset();
}

void SkillFigures::passed(runtime::Time when, const runtime::Device& device, std::size_t port,
                          std::span<const double> fields) {
  constexpr std::size_t force_z = 2, axes = 6;
  const std::string_view message = device.ports()[port].message;
  if (device.name() == "force-torque" && (message == "wrench" || message == "record") &&
      fields.size() >= axes) {
    force_ = -fields[force_z];  // pressing is negative there
    greatest_force_ = std::max(greatest_force_.value_or(*force_), *force_);
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
  if (force_) result.push_back({"force", *force_});
  if (greatest_force_) result.push_back({"greatest-force", *greatest_force_});
  return result;
}

}  // namespace pal::workcell
