// All runs of a skill, as a finite graph of classes: what state it is in, and all that its timers can show
// there.
//
// State classes of time Petri nets (B. Berthomieu, M. Diaz, Modeling and verification of time dependent
// systems using time Petri nets, 1991), over the times that the active timers still have to go. Instants that
// are being measured are variables too: how far they lie back. Actions of preempted threads run on below zero
// and get back, whenever one that others had the processor for ends, the time of that (exact where it is
// fixed; E. Fersman, P. Krcal, P. Pettersson, W. Yi, Task automata, 2007).
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "analyzer/dbm.hpp"
#include "analyzer/machine.hpp"

namespace pal::analyzer {

/// Bounds on an exploration. `stop`, if given, is asked now and then and ends it when it says true.
struct Limits {
  std::size_t classes = 2'000'000;
  std::function<bool()> stop;
};

struct ZoneClass {
  int state = -1;
  Dbm zone;  // variables: 0, the state's timers, its observers
  int parent = -1;
  int timer = -1;  // whose firing led here from the parent
  std::vector<std::uint8_t> choices;
  bool relaxed = false;  // somewhere on the way the zone is larger than what can be
  int replaced_by = -1;
};

struct Transition {
  int timer = -1;
  std::vector<std::uint8_t> choices;
  Outcome outcome;  // its state moved away
  int target = -1;  // state
};

/// A state of the machine with its active timers, in order, and where they lead.
struct Place {
  State state;
  std::vector<int> timers;
  std::vector<bool> frozen;
  std::optional<std::vector<Transition>> transitions;
};

/// The greatest value measured (the least, if that is watched): at the firing of `timer` in class `parent`
/// with `choices`.
struct Peak {
  Nanoseconds value = -1;
  int parent = -1;
  int timer = -1;
  std::vector<std::uint8_t> choices;
  int measured = 0;  // observer in the parent's state, or Outcome::born_now
  int step = -1;
  bool relaxed = false;
  /// Nothing is measured yet: `measured` is the observer, after the firing, from which a value grows.
  bool grows = false;
};

struct Edge {
  int from = -1;
  int to = -1;
  int timer = -1;
};

class ZoneGraph {
 public:
  /// Observed values up to `cap` are followed exactly; beyond, only that they are greater is known.
  ZoneGraph(const Machine& machine, Nanoseconds cap, bool keep_edges);

  /// Explores everything. False: a limit was met, or the machine outgrown.
  bool explore(const Limits& limits);

  const std::vector<ZoneClass>& classes() const { return classes_; }
  const std::vector<Place>& places() const { return places_; }
  /// Only if they were to be kept. Their ends are classes that were not replaced.
  const std::vector<Edge>& edges() const { return edges_; }
  const Peak& peak() const { return peak_; }
  bool over_cap() const { return over_cap_; }
  /// The firing after which an event can have no response any more, if there is one.
  const std::optional<Peak>& failure() const { return failure_; }
  /// A value grows beyond the cap, or for ever.
  bool never_answered() const { return never_answered_; }
  /// The first firing after which a value that still grows can be greater than the limit.
  const std::optional<Peak>& growing() const { return growing_; }
  /// A class in which nothing happens any more while a value grows; -1: there is none.
  int stuck() const { return stuck_; }
  /// What is watched happens in some run.
  bool passed() const { return passed_; }
  /// Some action was preempted by others whose time is not fixed.
  bool relaxed() const { return relaxed_; }

 private:
  int place_of(State state, std::vector<int> timers, std::vector<bool> frozen);
  void compute_transitions(int place);
  void expand(int index);
  void follow(int from, const Transition& transition, const Dbm& fired, std::size_t variable);
  void split(int from, const Transition& transition, State state, std::vector<int> timers,
             std::vector<bool> frozen, ZoneClass made);
  void add(int from, const Transition& transition, int place, ZoneClass made);
  void measure(int from, const Transition& transition, const Dbm& fired, std::size_t variable);
  int current(int index) const;

  const Machine& machine_;
  Nanoseconds cap_;
  bool keep_edges_;
  std::vector<ZoneClass> classes_;
  std::vector<Place> places_;
  std::unordered_map<State, int, StateHash> index_;
  std::vector<std::vector<int>> classes_of_;  // by place
  std::deque<int> open_;
  std::vector<Edge> edges_;
  Peak peak_;
  std::optional<Peak> failure_;
  void observe_growth(int from, const Transition& transition, const ZoneClass& made, std::size_t timers);

  std::optional<Peak> growing_;
  int stuck_ = -1;
  bool passed_ = false;
  bool over_cap_ = false;
  bool never_answered_ = false;
  bool outgrown_ = false;
  bool relaxed_ = false;
};

}  // namespace pal::analyzer
