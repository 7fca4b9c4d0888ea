// Skills tried aside: each trial has a workcell of its own in virtual time.
#pragma once

#include <vector>

#include "pal/runtime/cost_policy.hpp"
#include "programs/workcell/session/skills.hpp"
#include "server/locations.hpp"
#include "server/study.hpp"
#include "sim/scene.hpp"

namespace pal::workcell {

class SimulatedTrials final : public server::Trials {
 public:
  /// All outlive it.
  SimulatedTrials(const sim::Scene& scene, const std::vector<KnownSkill>& known, runtime::CostPolicy times)
      : scene_(scene), known_(known), times_(times) {}

  /// What its trials know of locations; it outlives it.
  void know(const server::Locations& book) { book_ = &book; }

  server::TrialResult run(const server::Trial& trial, const std::function<bool()>& stop) override;

 private:
  const sim::Scene& scene_;
  const std::vector<KnownSkill>& known_;
  runtime::CostPolicy times_;
  const server::Locations* book_ = nullptr;
};

}  // namespace pal::workcell
