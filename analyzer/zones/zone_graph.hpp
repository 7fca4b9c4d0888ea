// All runs of a skill as a finite graph of classes. A class is a state with all values that its timers can
// have there.
//
// State classes of time Petri nets (B. Berthomieu, M. Diaz, Modeling and verification of time dependent
// systems using time Petri nets, 1991), over the times that the active timers still have to go. Instants that
// are being measured are variables too: how long ago they were. Actions of preempted threads run on below
// zero. When they are resumed, they get back the processor time that others had meanwhile (exact where that
// time is fixed; E. Fersman, P. Krcal, P. Pettersson, W. Yi, Task automata, 2007).
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "analyzer/machine/machine.hpp"
#include "analyzer/zones/known_zones.hpp"
#include "analyzer/zones/successors.hpp"
#include "analyzer/zones/workers.hpp"

namespace pal::analyzer {

class ZoneGraph;

/// Bounds on an exploration, and the workers that help with it.
struct Limits {
  /// For about ten timers. Of classes with more than twenty, fewer are explored, so that they take no more
  /// memory (memory_for).
  std::size_t classes = 2'000'000;
  /// If given, called now and then, by one thread at a time. The exploration ends when it returns true.
  std::function<bool()> stop;
  /// If given, called now and then: returns whether what was found is enough.
  std::function<bool(const ZoneGraph&)> enough = {};
  Workers* workers = nullptr;  // none: the thread that explores works alone
};

/// The greatest value measured (the least, if that is watched): at the firing of `timer` in class `parent`
/// with `choices`.
struct Peak {
  Nanoseconds value = -1;
  int parent = -1;
  int timer = -1;
  std::vector<std::uint8_t> choices;
  int measured = 0;  // observer in the parent's state, or Outcome::born_now
  StepId step{};
  bool relaxed = false;
  /// Nothing is measured yet: `measured` is the observer, after the firing, from which a value grows.
  bool grows = false;
};

struct Edge {
  int from = -1;
  int to = -1;
  int timer = -1;
  int move = -1;  // of the place that it comes from
};

/// What was measured, and what cannot be.
struct Findings {
  Peak peak;
  Peak certain;  // the peak where no zone on the way is larger than what can be
  /// The firing after which an event can have no response any more, if there is one.
  std::optional<Peak> failure;
  /// The first firing after which a value that still grows can be greater than the limit.
  std::optional<Peak> growing;
  int stuck = -1;              // a class in which nothing has to happen any more while a value grows
  bool passed = false;         // what is watched happens in some run
  std::optional<Peak> beyond;  // the first value greater than the cap
  bool over_cap = false;
  /// Values grow beyond the cap round a way of classes, or where nothing has to happen any more.
  bool never_answered = false;
  bool grows_on = false;  // the same, and all the time one and the same value
  bool outgrown = false;  // a count outgrew the machine: nothing may be concluded
  bool relaxed = false;   // some action with a time that is not fixed preempted others

  /// Of two like values the first counts. `least`: the least is looked for.
  void add(const Findings& later, bool least);
  void measured(const Peak& value, bool least);
};

/// Classes are expanded in batches, in the order in which they were found. All threads work on a batch, first
/// class by class, then place by place. Neither depends on which thread does what, and new classes are
/// numbered in the order of the old ones. So the graph is the same for any number of threads.
class ZoneGraph {
 public:
  /// Which classes are not followed: those that lie within another, or only those that are equal to another.
  /// Hull: where a place has many classes, a new one is enlarged to contain another. The result is then a
  /// bound that no run need come near.
  enum class Merging { within, equal, hull };

  /// Observed values up to `cap` are followed exactly. Beyond the cap it is only known that they are greater.
  ZoneGraph(const Machine& machine, Nanoseconds cap, bool keep_edges, Merging merging = Merging::within);

  /// Explores everything. False: a limit was met, or a count outgrew the machine.
  bool explore(const Limits& limits);

  const std::vector<ZoneClass>& classes() const { return classes_; }
  const std::vector<Place>& places() const { return places_; }
  /// Only if edges were to be kept. Their ends are classes that were not replaced.
  const std::vector<Edge>& edges() const { return edges_; }
  /// Which of the firings of its parent, or of the ways to begin, led to a class.
  const Move& move_to(const ZoneClass& made) const;
  /// The class that includes this one now; itself, if it was not replaced.
  int current(int index) const;
  const Findings& findings() const { return findings_; }
  const Peak& peak() const { return findings_.peak; }
  bool over_cap() const { return findings_.over_cap; }
  const std::optional<Peak>& failure() const { return findings_.failure; }
  bool never_answered() const { return findings_.never_answered; }
  bool grows_on() const { return findings_.grows_on; }
  /// A class on a way round on which one and the same value grows beyond the cap; -1: there is none.
  int round() const { return round_; }
  const std::optional<Peak>& growing() const { return findings_.growing; }
  int stuck() const { return findings_.stuck; }
  bool passed() const { return findings_.passed; }
  bool relaxed() const { return findings_.relaxed; }

 private:
  /// A class on its way into the graph.
  struct Arrival {
    ZoneClass made;
    Move* move = nullptr;         // that led to it
    std::optional<State> passed;  // its state, if that is not the move's because an observer passed the cap
    int held_by = -1;             // a class, or another arrival (below -1), that includes it
    std::vector<int> replaces;    // the same, that it includes
    int number = -1;              // its class, or the one that includes it
    std::size_t next = 0;         // arrival at the same place
  };
  /// The successors of one class, in memory that is used again and again.
  struct Expansion {
    std::vector<Arrival> arrivals;
    std::size_t used = 0;  // of them
    Findings findings;
    Dbm fired;
    std::vector<Source> sources;

    void begin();
    Arrival& arrival(Move& move);
  };
  /// Arrivals at one place: a chain.
  struct Landing {
    int place;
    std::size_t first;
    std::size_t last;
    std::size_t count;
  };

  void in_parts(const Limits& limits, std::size_t count, std::size_t grain,
                const std::function<void(std::size_t)>& part) const;
  bool try_all(const std::vector<int>& untried, const Limits& limits, StopToken& stop);
  void shorten_ways();
  int on_a_round(const std::vector<std::pair<int, int>>& edges) const;
  bool grow(const Limits& limits);
  void expand(int index, Expansion& expansion);
  void measure(int from, const Move& move, const Dbm& fired, std::size_t timers, Findings& findings) const;
  void observe_growth(const Arrival& arrival, Findings& findings) const;
  void split(Arrival& arrival, Expansion& expansion) const;
  int place_of(Arrival& arrival);
  void merge(std::size_t expanded, const Limits& limits);
  void compare(const Landing& landing);
  void widen(ZoneClass& made, const KnownZones& known) const;
  void enter();
  const ZoneClass& zone_class(int id) const;

  const Machine& machine_;
  Nanoseconds cap_;
  bool keep_edges_;
  Merging merging_;
  std::vector<ZoneClass> classes_;
  std::vector<Place> places_;
  std::unordered_map<State, int, StateHash> index_;
  std::vector<KnownZones> known_;  // by place
  std::deque<int> open_;
  std::vector<Edge> edges_;
  // Edges from and to where a value grows that is beyond the cap; the second, where none of these goes.
  std::vector<std::pair<int, int>> growing_;
  std::vector<std::pair<int, int>> growing_on_;
  std::vector<Move> first_moves_;
  // Of the batch in work.
  std::vector<Expansion> expansions_;
  std::vector<Arrival*> arrivals_;
  std::vector<Landing> landings_;
  std::vector<int> landing_of_;  // by place; -1: none
  Findings findings_;
  std::size_t memory_ = 0;  // of zones, and of where places lead, about, in bytes
  int round_ = -1;
};

}  // namespace pal::analyzer
