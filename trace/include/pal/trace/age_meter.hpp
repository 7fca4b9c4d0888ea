// Ages and reactions in a run: what a thread knows, and from when that is
// (docs/reference/execution-model.md, "What is measured").
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "pal/trace/meter.hpp"

namespace pal::trace {

/// A set of a condition, or a sample. They are numbered from 1 on in their order; 0: none.
struct Birth {
  std::int64_t number = 0;
  std::int64_t time_ns = 0;
};

/// The messages that modules keep, numbered from 0 on.
struct Kept {
  std::vector<std::int32_t>
      of_channel;  // by channel: where a thread that takes from it leaves the message; -1
  std::vector<std::vector<std::int32_t>> used, written;  // by statement
  std::size_t count = 0;
};

/// What each actor knows of a condition: the set whose value it read last.
class ConditionFlow {
 public:
  ConditionFlow(const Trace& tables, std::int32_t condition)
      : condition_(condition), known_(tables.actors.size()) {}
  /// The event, before its effect is measured, and afterwards.
  void see(const Event& event, std::int32_t parent);
  void after(const Event&) {}

  const Birth& known(std::int32_t actor) const { return known_[static_cast<std::size_t>(actor)]; }
  const Birth& newest() const { return set_; }
  /// One that is later than all before.
  Birth begin(std::int64_t time_ns) { return {++births_, time_ns}; }

 private:
  std::int32_t condition_;
  std::int64_t births_ = 1;
  Birth set_{1, 0};  // until the first set, what a condition says dates from the start
  std::vector<Birth> known_;
};

/// What each actor knows of a device: the newest sample that its messages of `channels` carried. A sample
/// is from when the device began to serve the request, which is when it took the request. A device may not
/// say when it is busy. Then the sample is from when the request reached it, or the answer before was sent.
class SampleFlow {
 public:
  SampleFlow(const Trace& tables, Marks channels, Kept kept = {});
  void see(const Event& event, std::int32_t parent);
  void after(const Event& event);

  const Birth& known(std::int32_t actor) const { return known_[static_cast<std::size_t>(actor)]; }
  /// Number 0: there was no sample.
  const Birth& newest() const { return newest_; }
  Birth begin(std::int64_t time_ns) { return {++births_, time_ns}; }

 private:
  void newer(Birth& known, const Birth& birth) {
    if (birth.number > known.number) known = birth;
  }
  Birth sample(std::int64_t time_ns) { return newest_ = begin(time_ns); }
  Birth served(const Event& event);
  Birth said_by_device(const Event& event);
  void use_what_is_kept(const Event& event);

  Marks channels_;
  Kept kept_;
  std::vector<std::int32_t> request_;        // by channel: of what it answers; -1: nothing
  std::vector<std::int32_t> answer_;         // by channel: on which its messages are answered; -1
  std::vector<bool> device_;                 // by actor
  std::vector<bool> marks_;                  // by actor: it says when it is busy
  std::vector<bool> serves_;                 // by actor: it has taken a request, and sent nothing since
  std::vector<std::int64_t> put_;            // by channel: when its last message was put
  std::vector<std::int64_t> answered_;       // by actor: when it sent its last message
  std::vector<std::vector<Birth>> serving_;  // by channel: of its requests that were taken, oldest first
  std::vector<Birth> on_message_;            // by channel
  std::vector<Birth> on_condition_;          // by condition
  std::vector<Birth> in_module_;             // by number of what is kept
  std::vector<Birth> known_;                 // by actor
  Birth newest_;
  std::int64_t births_ = 0;
};

/// The age of what its thread knows at each effect of a statement of `at`.
template <class Flow>
class AgeOf {
 public:
  AgeOf(Flow flow, Marks at) : flow_(std::move(flow)), at_(std::move(at)) {}
  std::optional<Occurrence> see(const Event& event, std::int32_t parent) {
    std::optional<Occurrence> seen;
    flow_.see(event, parent);
    const bool measured =
        event.kind == Kind::done && event.statement >= 0 && at_[static_cast<std::size_t>(event.statement)];
    if (measured && flow_.known(event.actor).number > 0)
      seen = Occurrence{flow_.known(event.actor).time_ns, event.time_ns, event.actor, event.statement};
    flow_.after(event);
    return seen;
  }

 private:
  Flow flow_;
  Marks at_;
};
using AgeMeter = AgeOf<ConditionFlow>;
using SampleMeter = AgeOf<SampleFlow>;

/// From a change that the last reflected set (sample) just missed to the effect of a statement of `at` that
/// reflects a later one.
template <class Flow>
class ReactionOf {
 public:
  /// `whole`: it counts from the beginning of the run; otherwise from begin_phase() on.
  ReactionOf(Flow flow, Marks at, bool whole) : flow_(std::move(flow)), at_(std::move(at)), counts_(whole) {
    if (whole) reference_ = flow_.newest();
  }

  std::optional<Occurrence> see(const Event& event, std::int32_t parent) {
    const std::int64_t before = flow_.newest().number;
    flow_.see(event, parent);
    if (counts_ && reference_.number == 0 && flow_.newest().number > before) reference_ = flow_.newest();
    std::optional<Occurrence> seen;
    const bool measured = counts_ && reference_.number > 0 && event.kind == Kind::done &&
                          event.statement >= 0 && at_[static_cast<std::size_t>(event.statement)];
    if (measured && flow_.known(event.actor).number > reference_.number) {
      seen = Occurrence{reference_.time_ns, event.time_ns, event.actor, event.statement};
      reference_ = flow_.known(event.actor);
    }
    flow_.after(event);
    return seen;
  }
  /// What is known by then reflects nothing that changes from then on.
  void begin_phase(std::int64_t time_ns) {
    counts_ = true;
    if (flow_.newest().number > 0) reference_ = flow_.begin(time_ns);
  }
  void end_phase() {
    counts_ = false;
    reference_ = {};
  }

 private:
  Flow flow_;
  Marks at_;
  bool counts_;
  Birth reference_;
};
using ConditionReactionMeter = ReactionOf<ConditionFlow>;
using SampleReactionMeter = ReactionOf<SampleFlow>;

}  // namespace pal::trace
