// The machine with real times: one run, instant by instant.
#pragma once

#include <optional>
#include <vector>

#include "analyzer/machine/machine.hpp"

namespace pal::analyzer {

/// A value that was measured in a run: a length of time, or of losses a number.
struct Measurement {
  Nanoseconds value = 0;
  Nanoseconds born = 0;
  Nanoseconds at = 0;
  StepId step{};
};

/// One event of a run.
struct ScriptedFiring {
  int timer = -1;  // -1: the start
  std::vector<std::uint8_t> choices;
  Nanoseconds at = 0;
};

/// One run with concrete times, instant by instant. Its driver (a script, a simulation) chooses which timer
/// fires when. The run does not check that choice, but counts exactly the work that each timer has done.
class ConcreteRun {
 public:
  struct Timer {
    bool active = false;
    bool frozen = false;
    Range range;
    Nanoseconds duration = 0;  // chosen by the caller when it starts
    Nanoseconds worked = 0;    // until `since`
    Nanoseconds since = 0;
  };

  explicit ConcreteRun(const Machine& machine, bool record = true);

  /// Time 0. The timers that this starts are in started().
  void begin(Choices& choices);
  /// Fires `timer` at `now`, not before the last instant. False: it cannot be the first at this instant, or a
  /// count outgrew the machine.
  bool fire(int timer, Nanoseconds now, Choices& choices);

  const State& state() const { return state_; }
  Nanoseconds now() const { return now_; }
  std::vector<Timer>& timers() { return timers_; }
  const std::vector<Timer>& timers() const { return timers_; }
  /// Work that the timer has done by `when` (not before the last instant).
  Nanoseconds worked(int timer, Nanoseconds when) const;
  /// Timers started by the last event.
  const std::vector<int>& started() const { return started_; }
  const std::vector<Measurement>& measured() const { return measured_; }
  /// When the observers of the state were born.
  const std::vector<Nanoseconds>& births() const { return births_; }
  const Outcome& outcome() const { return outcome_; }
  /// A count outgrew the machine: the run is known no further.
  bool outgrown() const { return outgrown_; }

  /// The run so far, `origin` predicted.
  trace::Trace trace() const;

 private:
  void apply(int fired);
  void record();
  std::size_t place_of_end(int device, Nanoseconds at) const;

  const Machine& machine_;
  bool record_;
  State state_;
  Outcome outcome_;
  Nanoseconds now_ = 0;
  bool outgrown_ = false;
  std::vector<Timer> timers_;
  std::vector<int> started_;
  std::vector<Nanoseconds> births_;
  std::vector<Measurement> measured_;
  std::vector<trace::Event> events_;
  std::vector<std::int32_t> serials_;
  std::vector<std::int32_t> current_;
};

/// The tables of a trace of `problem`, without events.
trace::Trace empty_trace(const Problem& problem);

}  // namespace pal::analyzer
