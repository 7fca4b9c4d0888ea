#include "programs/workcell/session/trials.hpp"

#include <sys/resource.h>

#include <chrono>
#include <exception>
#include <memory>
#include <optional>

#include "programs/workcell/session/cell_runner.hpp"
#include "programs/workcell/session/margin_meter.hpp"
#include "programs/workcell/session/taught_robot.hpp"
#include "programs/workcell/session/watched_world.hpp"
#include "server/knowledge.hpp"
#include "sim/cell/cell.hpp"
#include "sim/val/transformation.hpp"

namespace pal::workcell {

server::TrialResult SimulatedTrials::run(const server::Trial& trial, const std::function<bool()>& stop) {
  // The live cell's threads come first; on Linux this is of the thread.
  constexpr int least_urgent = 19;
  ::setpriority(PRIO_PROCESS, 0, least_urgent);
  constexpr auto look_each = std::chrono::milliseconds(20);
  CellRunner* runs = nullptr;
  sim::CellOptions options;
  options.seed = trial.seed;
  options.times = times_;
  options.keep_log = false;
  options.watch = [&](sim::Workcell& workcell) {
    auto watched =
        std::make_unique<WatchedWorld>(workcell, std::vector{Watcher{look_each, [&] {
                                                                       if (runs != nullptr && stop())
                                                                         runs->stop();
                                                                     }}});
    watched->begin(workcell.now());
    return watched;
  };
  if (trial.joints) options.start = sim::val::joints_of(*trial.joints);
  std::optional<sim::Cell> opened;
  try {
    opened.emplace(scene_, options);
  } catch (const std::exception& problem) {
    return {{operations::SkillResult::Kind::error, -1, problem.what()}};
  }
  sim::Cell& cell = *opened;
  if (book_ != nullptr) CellRobot(cell).teach_all(book_->list());
  server::Knowledge of_this_trial;
  MarginMeter margins(of_this_trial);
  CellRunner runner(cell, known_, times_, trial.seed, OnInterrupt::leave);
  runner.measure(&margins);
  runs = &runner;
  server::TrialResult got;
  for (const server::Trial::Skill& each : trial.before) {
    got.begin = runner.now();
    got.result = runner.run(each.skill, each.parameters, std::nullopt);
    got.end = runner.now();
    if (got.result.kind != operations::SkillResult::Kind::normal) {
      got.result.reason = "before it, " + each.skill + ": " + got.result.reason;
      return got;
    }
  }
  got.begin = runner.now();
  got.result = runner.run(trial.tried.skill, trial.tried.parameters, std::nullopt);
  got.end = runner.now();
  return got;
}

}  // namespace pal::workcell
