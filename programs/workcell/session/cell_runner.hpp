// Runs the skills of an operation in the workcell.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/executor.hpp"
#include "pal/runtime/observer.hpp"
#include "programs/workcell/session/interrupt.hpp"
#include "programs/workcell/session/margin_meter.hpp"
#include "programs/workcell/session/person.hpp"
#include "programs/workcell/session/skill_figures.hpp"
#include "programs/workcell/session/skills.hpp"
#include "sim/cell/cell.hpp"

namespace pal::workcell {

/// The descriptions of the program's skills.
operations::Skills templates_of(const std::vector<KnownSkill>& skills);

/// The longest times that the skills declare.
operations::DeclaredTimes longest_of(const std::vector<KnownSkill>& skills);

/// The sensors that tests and waits can read, and the locations that are taught.
operations::Sensors sensors_of(const sim::Cell& cell);
std::set<std::string> locations_of(sim::Cell& cell);

/// All that an operation can be checked against, of the cell that was made of this scene.
operations::Cell cell_of(sim::Cell& cell, const std::vector<KnownSkill>& skills, const sim::Scene& scene,
                         const std::vector<std::string>& scene_folders);

/// Whether Ctrl-C stops the skill that runs.
enum class OnInterrupt { stop, leave };

/// Arm, parts and devices go on from skill to skill.
class CellRunner final : public operations::SkillRunner {
 public:
  /// All outlive the runner. `messages`: observes the messages of each skill.
  CellRunner(sim::Cell& cell, const std::vector<KnownSkill>& skills, runtime::CostPolicy times,
             std::uint64_t seed, OnInterrupt on_interrupt = OnInterrupt::stop,
             runtime::MessageObserver* messages = nullptr);
  /// What is done when a promise of the environment, or a requirement, is broken; `report` unless it is set.
  /// The first one stands in the reason of the skill's result.
  void on_broken_promise(runtime::OnBrokenPromise policy) { on_broken_promise_ = policy; }

  /// Measures how near skills come to their requirements, and outlives the runner; null, and without this
  /// call: nobody does.
  void measure(MarginMeter* margins) { margins_ = margins; }

  /// Who answers questions, and outlives the runner; null, and without this call: nobody.
  void let_answer(Person* person) { person_ = person; }

  operations::SkillResult run(const std::string& skill, const std::vector<operations::Parameter>& parameters,
                              std::optional<Duration> limit) override;
  bool delay(Duration time) override;
  operations::Reading sense(const std::string& sensor) override;
  std::optional<std::string> zero(const std::string& sensor) override;
  void ask(const operations::Question& question) override;
  operations::Reply answer() override;
  void withdraw() override;
  Duration now() const override;
  void stop() noexcept override;
  void allow() override;

 private:
  runtime::Skill* find(const std::string& name);
  void take_new_control();
  std::shared_ptr<runtime::RunControl> control() const;

  sim::Cell& cell_;
  const std::vector<KnownSkill>& known_;
  operations::Skills templates_;
  operations::DeclaredTimes longest_;
  runtime::CostPolicy times_;
  std::uint64_t seed_;  // of the next skill
  std::map<std::string, std::unique_ptr<runtime::Skill>> made_;
  OnInterrupt on_interrupt_;
  SkillFigures figures_;
  Person* person_ = nullptr;
  MarginMeter* margins_ = nullptr;
  runtime::OnBrokenPromise on_broken_promise_ = runtime::OnBrokenPromise::report;
  // A control that has been stopped stays so; resuming takes a new one. Another thread that is about to stop
  // holds the old one for so long.
  mutable std::mutex mutex_;
  std::shared_ptr<runtime::RunControl> control_;
  // A signal's handler holds nothing: with OnInterrupt::stop all stay.
  std::vector<std::shared_ptr<runtime::RunControl>> of_signals_;
  std::optional<Interrupt> interrupt_;
};

}  // namespace pal::workcell
