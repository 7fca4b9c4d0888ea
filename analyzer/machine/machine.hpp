// The behaviour of a skill, once for all analyses: an untimed machine with timers.
// docs/reference/execution-model.md in code.
//
// The machine says which timers start, stop, freeze and resume when one of them fires. The time domains say
// when they may fire: zones (zone_graph), single runs (run), grids of instants (load).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/machine/state.hpp"
#include "analyzer/machine/watch.hpp"
#include "analyzer/problem/problem.hpp"
#include "pal/trace/trace.hpp"

namespace pal::analyzer {

/// Decides what the skill leaves open: outcomes of conditions, and orders at one instant.
class Choices {
 public:
  virtual ~Choices() = default;
  /// One of 0 … n-1; n >= 1.
  virtual int pick(int n) = 0;
};

/// Goes through all combinations: run, then next() until it says false.
class AllChoices final : public Choices {
 public:
  int pick(int n) override;
  /// Prepares the next combination.
  bool next();
  const std::vector<std::uint8_t>& taken() const { return taken_; }

 private:
  std::vector<std::uint8_t> taken_;
  std::vector<std::uint8_t> of_;
  std::size_t at_ = 0;
};

/// Makes the choices of a script.
class ScriptedChoices final : public Choices {
 public:
  explicit ScriptedChoices(const std::vector<std::uint8_t>& script) : script_(script) {}
  int pick(int n) override;

 private:
  const std::vector<std::uint8_t>& script_;
  std::size_t at_ = 0;
};

struct TimerChange {
  enum class Kind : std::uint8_t { start, stop, freeze, resume };
  Kind kind = Kind::start;
  int timer = -1;
  Range range;  // start
};

/// What firing a timer leads to, for one combination of choices.
struct Outcome {
  static constexpr int born_now = -1;
  static constexpr int older_than_cap = -2;
  State state;
  std::vector<TimerChange> changes;    // in order; the fired timer is gone already
  std::vector<int> origin;             // of each observer of `state`: its number before, or born_now
  std::vector<int> measured;           // at this instant: number before, born_now or older_than_cap
  std::vector<StepId> measured_steps;  // the steps at which; none: at none
  int lost = -1;        // losses: the greatest number in a row of Watch::in, if it may have grown
  bool passed = false;  // what the watch is about has happened
  std::vector<trace::Event> events;  // without times and serial numbers; only if recorded
  bool over_gone = false;            // what grew beyond the cap does so no more
  bool too_many = false;             // a count outgrew the machine: nothing may be concluded
  bool hurried = false;              // a message's way that may take time took none
};

class Machine {
 public:
  /// Both must outlive the machine.
  Machine(const Problem& problem, const Watch& watch) : problem_(problem), watch_(watch) {}

  const Problem& problem() const { return problem_; }
  const Watch& watch() const { return watch_; }

  /// Timers:
  /// - one for each thread: its action, or the limit of its wait;
  /// - two for each channel: a message on its way to threads on the sender's processor, and to others;
  /// - two for each device: its next event or frame, and its service or lateness;
  /// - one that ends a busy period behind a pause of no length.
  int timer_count() const;
  int thread_timer(ThreadId thread) const { return thread.value; }
  bool is_of_thread(int timer) const { return timer < first_flight_timer(); }
  /// Whose timer it is, if it is one of a thread.
  ThreadId thread_of(int timer) const { return ThreadId::of(timer); }
  int flight_timer(ChannelId channel) const {
    return static_cast<int>(problem_.threads.size()) + 2 * channel.value;
  }
  int first_flight_timer() const { return flight_timer(ChannelId{0}); }
  /// Whose timer it is, from first_flight_timer() on.
  ChannelId channel_of(int timer) const { return ChannelId::of((timer - first_flight_timer()) / 2); }
  int next_timer(DeviceId device) const {
    return flight_timer(ChannelId(problem_.channels.size())) + 2 * device.value;
  }
  int service_timer(DeviceId device) const { return next_timer(device) + 1; }
  int first_device_timer() const { return next_timer(DeviceId{0}); }
  /// Whose timer it is, from first_device_timer() on.
  DeviceId device_of(int timer) const { return DeviceId::of((timer - first_device_timer()) / 2); }
  int pause_timer() const { return next_timer(DeviceId(problem_.devices.size())); }
  /// Processor whose work the timer measures in `state`; -1: none.
  ProcessorId processor_of(const State& state, int timer) const;
  /// Processor time of the action that a thread's timer measures in `state`.
  Range cost(const State& state, int timer) const;
  /// "SM1.2", "Zforce from LS1 to SM1 between processors", "force-torque service", …: no two have one name.
  std::string timer_name(int timer) const;

  Outcome initial(Choices& choices, bool record) const;

  /// What happens when `timer`, active in `state`, fires. False: it cannot be the first at this instant,
  /// because a frame does not start before the last one has ended.
  bool fire(const State& state, int timer, Choices& choices, bool record, Outcome& outcome) const;

  /// Conditions whose reads give any value: used where their writer is left out of an analysis.
  std::uint64_t free_conditions = 0;

 private:
  const Problem& problem_;
  const Watch& watch_;
};

/// Observer `number` only needs to be known as greater than the cap; the observers after it move up.
void pass_cap(State& state, const Watch& watch, int number);

/// Whether the value that is measured from observer `number` is still growing, and counts even if it is never
/// measured.
bool grows(const State& state, const Watch& watch, int number);

}  // namespace pal::analyzer
