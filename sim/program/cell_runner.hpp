// The workcell as what runs the skills of an operation.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/executor.hpp"
#include "sim/cell/cell.hpp"
#include "sim/program/interrupt.hpp"
#include "sim/program/skills.hpp"

namespace pal::workcell {

/// What the skills of the program say of themselves.
operations::Skills templates_of(const std::vector<KnownSkill>& skills);

/// Arm, parts and devices go on from skill to skill. Ctrl-C stops the skill that runs.
class CellRunner final : public operations::SkillRunner {
 public:
  /// All outlive the runner.
  CellRunner(sim::Cell& cell, const std::vector<KnownSkill>& skills, runtime::CostPolicy times,
             std::uint64_t seed);

  operations::SkillResult run(const std::string& skill,
                              const std::vector<operations::Parameter>& parameters) override;
  void delay(Duration time) override;
  Duration now() const override;
  void stop() noexcept override;
  void allow() override;

 private:
  runtime::Skill* find(const std::string& name);

  sim::Cell& cell_;
  const std::vector<KnownSkill>& known_;
  runtime::CostPolicy times_;
  std::uint64_t seed_;  // of the next skill
  std::map<std::string, std::unique_ptr<runtime::Skill>> made_;
  // A control that has been stopped stays so; resuming takes a new one.
  std::unique_ptr<runtime::RunControl> control_;
  std::optional<Interrupt> interrupt_;
};

}  // namespace pal::workcell
