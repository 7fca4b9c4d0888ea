// One run of a skill in a scene: everything that decides how it goes, and what came of it.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pal/runtime/measurement.hpp"
#include "pal/trace/spool.hpp"
#include "programs/workcell/session/skills.hpp"
#include "runtime/drivers/station.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/cell/fault_plan.hpp"
#include "sim/picture/picture.hpp"
#include "sim/report/message_log.hpp"
#include "sim/report/sample_spool.hpp"
#include "sim/scene.hpp"
#include "sim/workcell.hpp"

namespace pal::workcell {

struct Session {
  sim::Scene scene;
  std::vector<runtime::ParameterValue> parameters;
  runtime::CostPolicy times = runtime::CostPolicy::random;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> machine_seed = std::nullopt;  // as the scene says if not given
  /// From the skill's beginning to ALTER's first request; drawn by the seed if not given.
  std::optional<runtime::Time> phase;
  /// How much higher than in the scene the tool starts, mm.
  double raise = 0;
  /// A skill that is run before, with its defaults. What it did is not in the result.
  std::optional<KnownSkill> before{};
  bool picture = false;
  std::string video{};               // the file; empty: none
  std::ostream* progress = nullptr;  // where progress is shown; nullptr: nowhere
  bool terminal = false;             // progress is a line that is rewritten
  /// Outlive the run; empty: time is virtual, bytes stay in the process, the skill is not stopped.
  runtime::drivers::Pace* pace = nullptr;
  std::function<std::unique_ptr<runtime::drivers::Carrier>()> carrier{};
  runtime::RunControl* control = nullptr;
  runtime::Time limit = runtime::RunOptions().horizon;  // of the skill's time
  std::optional<runtime::RealTime> real_time{};         // of the skill; nothing: virtual time
  std::vector<sim::PlannedFault> faults{};
  runtime::Measurement* measurement = nullptr;  // of the skill, over all its runs; null: nothing is measured
  std::vector<runtime::SlowStatement> slow{};   // statements that take longer than is declared
  runtime::OnBrokenPromise on_broken_promise = runtime::OnBrokenPromise::report;
  runtime::TraceRing* live = nullptr;  // gets the events of the skill, not of the one before
};

struct SessionResult {
  runtime::Outcome outcome;
  runtime::Time phase{};  // as given or drawn
  /// From the skill's beginning, time 0, until the arm has come to rest. Of more than a minute those that
  /// keep every peak and every dip; all of them are in `samples`.
  std::vector<sim::Sample> log;
  std::shared_ptr<sim::SampleSpool> samples;
  /// All events, if `outcome.trace` has only the last ones of a long run; null: it has all.
  std::shared_ptr<trace::EventSpool> events;
  sim::MessageLog messages;
  std::vector<sim::PlannedFault> faults_to_come;  // that had not come when the skill ended
  std::vector<runtime::SlowStatement> slow;       // as the session says
  std::string controller;    // what VAL said of the last command that failed; empty: none did
  double peak_force = 0;     // N
  double resting_force = 0;  // N, at the end of the log
  sim::Picture picture;
  std::string video_problem;  // why there is no video after all; empty with it, or if none was asked for

  /// Gives back the memory of `log`, until read_log() takes it from `samples` again.
  void drop_log();
  void read_log();
};

/// Runs the skill, then lets the arm end its motion and come to rest. Pictures, video and progress change
/// nothing of the run. Throws
/// - sim::SceneError, also when the skill before does not end with completion 0;
/// - sim::VideoError, before the run;
/// - std::runtime_error when the physics diverged after the skill's end (before it, that is a fault of the
///   skill).
SessionResult run_session(runtime::Skill& skill, const Session& session);

/// "touch in scene touch"
std::string title(const runtime::Skill& skill, const Session& session);

/// The value that the session gives a parameter, or its default; nothing if the skill has none of that name.
std::optional<double> parameter_value(const runtime::Skill& skill, const Session& session,
                                      std::string_view name);

/// Likewise of a parameter that is a text.
std::string text_parameter(const runtime::ParameterSpec& parameter, const Session& session);

}  // namespace pal::workcell
