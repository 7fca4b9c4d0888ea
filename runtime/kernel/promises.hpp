// Promises of the environment and requirements, while a skill runs: notes those that are broken, and applies
// the run's policy.
#pragma once

#include <atomic>

#include <cstdint>
#include <span>
#include <vector>

#include "pal/runtime/broken_promise.hpp"
#include "pal/runtime/outcome.hpp"
#include "pal/runtime/skill.hpp"
#include "runtime/kernel/journal.hpp"
#include "runtime/watch/device_watch.hpp"
#include "runtime/watch/requirement_watch.hpp"

namespace pal::runtime {

/// Devices, threads and statements are named by their index. Nothing is allocated, and no text made, before a
/// promise is broken.
class Promises final : public EventWatcher {
 public:
  /// All outlive the promises. `connections`: as many as the run has devices.
  Promises(const Clock& clock, Journal& journal, Skill& skill, const RunOptions& options);

  // What devices do.
  void opened(int device) {
    if (!devices_.empty()) watch(device).opened(clock_.now), look_at(device);
  }
  void asked(int device) {
    if (!devices_.empty()) watch(device).asked(clock_.now), look_at(device);
  }
  void forgotten(int device, bool busy) {
    if (!devices_.empty()) watch(device).forgotten(clock_.now, busy), look_at(device);
  }
  /// The device has sent a message that answers nothing.
  void sent(int device, int channel);
  /// It has answered the request that came at `asked`.
  void answered(int device, int channel, Time asked);

  /// It has sent an answer that nobody has asked for.
  void unasked(int device, int channel) { note_unasked(device, channel, Time::zero()); }
  /// It leaves a request unanswered, and must not.
  void left_out(int device, int channel) { note_unasked(device, channel, Time::max()); }

  /// The current statement of the thread has taken `used` of its processor.
  void took(const Thread& thread, Time used);

  /// An event of the run.
  void see(const trace::Event& event, std::span<const std::uint32_t> meters) override;
  /// A thread comes to a loop that a phase names, and leaves it.
  void enter(int loop, int thread) {
    const std::vector<Exceeded>& exceeded = requirements_.enter(loop, thread, clock_.now);
    journal_.routes_changed();
    note(exceeded);
  }
  void leave(int loop, int thread) {
    const std::vector<Exceeded>& exceeded = requirements_.leave(loop, thread);
    journal_.routes_changed();
    note(exceeded);
  }

  /// A lower bound of due(). To be called before each event.
  Time next() const { return next_; }
  /// The next instant at which something becomes late that was not reported yet.
  Time due();
  /// Time has reached due(): notes what is late. The devices whose oldest request is late, or has no answer
  /// any more; valid until the next call.
  const std::vector<int>& overdue();

  /// Whether the skill is being asked for its answer to a broken promise. From any thread.
  bool asks_skill() const { return asks_skill_.load(std::memory_order_relaxed); }

  /// What was broken. Once.
  std::vector<BrokenPromise> take();
  /// How near the run came to each requirement. Once, after its end.
  std::vector<MeasuredRequirement> measured();

 private:
  /// What was seen of one promise.
  struct Row {
    std::int32_t broken = -1;  // in broken_
    Time measured{};
  };
  /// The party that has broken it, and where.
  struct Breach {
    std::size_t row = 0;
    Time measured{};
    std::int32_t actor = -1;
    std::int32_t statement = -1;
    std::int32_t channel = -1;
    bool least = false;  // the promise is a least time
    bool noted = false;  // another measure of a breach that was noted
    Time limit{};        // of a statement: the longest time that it may take
  };

  DeviceWatch& watch(int device) { return devices_[static_cast<std::size_t>(device)]; }
  void look_at(int device) { next_ = std::min(next_, watch(device).due()); }
  std::size_t row_of_device(int device, std::size_t promise) const;
  std::size_t row_of_statement(int statement) const;
  std::size_t row_of_requirement(std::size_t requirement) const;

  void note(int device, int channel, const Seen& seen);
  void note_unasked(int device, int channel, Time measured);
  void note(const std::vector<Exceeded>& exceeded);
  void note(const Breach& breach);
  void apply_policy(const Breach& breach, const BrokenPromise& broken);
  BrokenPromise describe(const Breach& breach) const;
  std::string promise_of_device(std::size_t device, std::size_t promise) const;
  std::string promise_of_requirement(const RequirementSpec& requirement) const;
  std::string name_of(std::int32_t actor) const;

  const Clock& clock_;
  Journal& journal_;
  Skill& skill_;
  const Wiring& wiring_;
  OnBrokenPromise policy_;
  Time cost_tolerance_;
  std::vector<DeviceWatch> devices_;  // none: nothing is promised of any
  RequirementWatch requirements_;
  std::vector<Row> rows_;  // of each device three, of each statement and each requirement one
  std::vector<int> late_devices_;
  std::vector<BrokenPromise> broken_;
  Time next_ = Time::max();
  std::atomic<bool> asks_skill_ = false;
};

}  // namespace pal::runtime
