// What the cell knows of a skill that has ended.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/executor.hpp"
#include "pal/runtime/observer.hpp"
#include "sim/workcell.hpp"

namespace pal::workcell {

/// All that there are, with units and descriptions.
operations::Sensors figures_of_skills();

/// Follows the force-torque sensor while a skill uses it.
class SkillFigures final : public runtime::MessageObserver {
 public:
  /// `next`: sees the messages, too; may be null, else outlives this.
  explicit SkillFigures(runtime::MessageObserver* next) : next_(next) {}

  void begin(const sim::Workcell& workcell);
  void passed(runtime::Time when, const runtime::Device& device, std::size_t port,
              std::span<const double> fields) override;
  void forgotten(const runtime::Device& device, std::size_t port) override;
  /// Of the skill since begin(), which took `duration`; the forces are left out if it read none.
  std::vector<operations::Figure> end(const sim::Workcell& workcell, runtime::Time duration) const;

 private:
  runtime::MessageObserver* next_;
  std::optional<double> force_, greatest_force_;  // N, pressing is positive
  double sum_ = 0, squares_ = 0;                  // of the readings, N and N^2
  std::size_t readings_ = 0;
  Eigen::Vector3d from_ = Eigen::Vector3d::Zero();  // m, of the tool's tip
};

}  // namespace pal::workcell
