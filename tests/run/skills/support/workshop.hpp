// A workcell in which skills run one after the other, and what there is to measure in it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/cell/cell.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

/// A scene of the project with lines of one's own at its end: "machine seed 2". Its file lives as long as it.
class ChangedScene {
 public:
  ChangedScene(const std::string& name, const std::string& lines);
  ~ChangedScene();
  ChangedScene(const ChangedScene&) = delete;
  ChangedScene& operator=(const ChangedScene&) = delete;

  const sim::Scene& scene() const { return scene_; }

 private:
  std::filesystem::path folder_;
  sim::Scene scene_;
};

class Workshop {
 public:
  explicit Workshop(const sim::Scene& scene, std::uint64_t seed = 1);
  Workshop(const sim::Scene& scene, const sim::CellOptions& options);

  /// Runs the skill, then lets the arm rest for 0.3 s.
  runtime::Outcome run(const std::string& skill, const std::vector<runtime::ParameterValue>& parameters = {});
  /// The same, and holds it against what was proved.
  runtime::Outcome run(const std::string& skill, const std::vector<runtime::ParameterValue>& parameters,
                       ProvedBounds& bounds);

  sim::Cell& cell() { return cell_; }
  /// Frame 0, mm.
  Eigen::Vector3d tip() { return 1e3 * cell_.workcell().tool().translation(); }
  /// The middle of a thing of the scene, "part" or "part 2"; frame 0, mm.
  Eigen::Vector3d middle(const std::string& thing);
  /// The middles of all loose parts.
  std::map<std::string, Eigen::Vector3d> parts();
  /// Of a location that VAL knows; mm.
  Eigen::Vector3d location(const std::string& name) {
    return 1e3 * cell_.val_store().locations.at(name).translation();
  }
  /// What the last run was like, step by step, with the rest after it.
  std::span<const sim::Sample> log();

 private:
  sim::Cell cell_;
  std::map<std::string, std::size_t> bodies_;
  std::size_t begun_ = 0;  // in the log
};

/// A text parameter.
inline runtime::ParameterValue text(std::string name, std::string value) {
  return {.name = std::move(name), .text = std::move(value)};
}

}  // namespace pal::test
