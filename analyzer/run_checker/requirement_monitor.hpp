// Measures a requirement while the referee follows a run.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyzer/run_checker/check_run.hpp"

namespace pal::analyzer::run_checker {

/// Is told everything that may count, in the order of the run. docs/reference/execution-model.md says what is
/// measured. Births (of events, of samples, of values of a condition) are numbered in their order.
class RequirementMonitor {
 public:
  /// Without a requirement, or of a load, nothing is measured.
  RequirementMonitor(const Problem& problem, const Requirement* requirement, BusyFrom busy_from);

  void at(Nanoseconds now) { now_ = now; }

  // Threads.
  void begins(ThreadId block, ThreadId parent);
  void ends(ThreadId thread);
  void reaches(ThreadId thread, StepId step);
  void passes(ThreadId thread, StepId step);
  void completes(ThreadId thread, StepId step, int code);
  void sets(ThreadId thread, pan::ConditionId condition);
  void reads(ThreadId thread, pan::ConditionId condition);
  void busy(ProcessorId processor);
  void idle(ProcessorId processor);

  /// What the module keeps: a statement uses it, at its effect and before all else; an activity has written
  /// it.
  void uses(ThreadId thread, StepId step);
  void writes(ThreadId thread, StepId step);

  // Messages. What the thread carries goes with one that it puts.
  void puts(ThreadId thread, ChannelId channel);
  void takes(ThreadId thread, ChannelId channel);
  void empties(ChannelId channel);
  void withdrawn(ChannelId channel);

  // Devices. `first`: of several requests that one frame serves.
  void serves(ChannelId request, bool first);
  /// What it has served must be answered now; it may begin to serve the next request before.
  void is_due(ChannelId request);
  void event(DeviceId device, ChannelId channel, bool lost);
  void answers(ChannelId channel, bool lost);
  void served(DeviceId device, bool lost);
  void frame_for_nobody(DeviceId device);

  const std::vector<Measured>& measured() const { return measured_; }
  bool failed() const { return failed_; }
  /// Since when a value has been growing that is not measured yet.
  std::optional<Nanoseconds> growing_since() const;
  void skill_ends();

 private:
  using Measure = Requirement::Measure;
  /// In births_.
  using BirthId = Id<struct BirthTag>;
  static constexpr BirthId none{};

  bool is(Measure measure) const { return requirement_ != nullptr && requirement_->measure == measure; }
  bool of_condition(pan::ConditionId condition) const;
  bool of_samples() const;
  bool is_sample(ChannelId channel) const;
  bool is_event(ChannelId channel) const;
  BirthId birth();
  void judge(ThreadId thread, StepId step);
  bool counts() const { return !phase_ || in_phase_; }
  void follow_loops();
  void phase_begins();
  void phase_ends();
  BirthId& thread(ThreadId thread) { return threads_[thread]; }
  BirthId& channel(ChannelId channel) { return channels_[channel]; }
  void show(Nanoseconds born, StepId step);
  void respond(ThreadId thread, StepId step);
  void react(ThreadId thread, StepId step);
  void occurrence(DeviceId device, bool lost);
  void show_losses();

  const Problem& problem_;
  const Requirement* requirement_;
  BusyFrom busy_from_;
  Nanoseconds now_ = 0;
  const Phase* phase_ = nullptr;  // what is measured, if it is not the whole run
  bool in_phase_ = false;
  Table<ThreadId, StepId> at_;  // of a phase: the step that each thread is at
  Table<BirthId, Nanoseconds> births_;
  Table<BirthId, bool> answered_;                // events
  Table<BirthId, bool> uncounted_;               // events outside of the phase, or left unanswered by it
  Table<ThreadId, BirthId> threads_;             // the birth that each carries
  Table<ChannelId, BirthId> channels_;           // and each message
  Table<ChannelId, BirthId> serving_;            // and the answer to each request that is being served
  Table<ChannelId, BirthId> due_;                // … to each that has been
  Table<pan::ConditionId, BirthId> conditions_;  // and each condition
  Table<KeptId, BirthId> kept_;                  // and each value that a module keeps
  BirthId reference_{};                          // reactions: the latest birth that a statement has reflected
  bool sampled_ = false;                         // reactions: there was a sample
  Nanoseconds begun_ = 0;                        // durations: when they began
  std::optional<Nanoseconds> last_pass_;
  Table<ProcessorId, std::vector<Nanoseconds>> busy_since_;  // several, with pauses of no length between
  Table<ProcessorId, Nanoseconds> paused_;                   // when it had nothing to do last; -1: never
  Table<ProcessorId, bool> working_;
  std::vector<bool> lost_;            // by occurrence
  bool occurred_ = false;             // there was one
  Table<ChannelId, int> occurrence_;  // of the message in each channel
  std::vector<Measured> measured_;
  bool failed_ = false;
  bool ended_ = false;
};

}  // namespace pal::analyzer::run_checker
