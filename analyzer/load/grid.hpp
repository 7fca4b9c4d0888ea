// The machine with times that are whole multiples of a unit: enough where a greatest ratio is asked for.
//
// All bounds are closed and multiples of the unit. Then the greatest ratio of two sums over a run is
// attained, or approached, on corner points, which are such multiples too (P. Bouyer, E. Brinksma, K. G.
// Larsen, Optimal infinite scheduling for multi-priced timed automata, 2008; digitization: T. A. Henzinger,
// Z. Manna, A. Pnueli, 1992).
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "analyzer/load/recurrence.hpp"
#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

struct GridEdge {
  int from = -1;
  int to = -1;
  Nanoseconds time = 0;
  int timer = -1;  // -1: time passes
};

struct GridNode {
  int place = -1;
  std::vector<Nanoseconds> left;  // of each timer of the place; of a sporadic event: until it may come
};

struct GridPlace {
  State state;
  std::vector<int> timers;
  std::vector<bool> frozen;
};

class Grid {
 public:
  /// Follows `slice` only; everything else of `machine` stands still.
  Grid(const Machine& machine, const Slice& slice);

  /// From every point of the classes at which the recurrence is entered. False: a limit was met, or no start
  /// was found from which the recurrence can be followed.
  bool start(const ZoneGraph& graph, const Recurrence& recurrence, const Limits& limits);
  /// False: a limit was met.
  bool explore(const Limits& limits);

  const std::vector<GridNode>& nodes() const { return nodes_; }
  const std::vector<GridPlace>& places() const { return places_; }
  const std::vector<GridEdge>& edges() const { return edges_; }
  /// The class from which each start came. By node; -1: the node is not a start.
  const std::vector<int>& origins() const { return origins_; }
  /// `state` as the grid sees it: parts that are left out stand still.
  State masked(State state) const;
  /// Preempted actions got back times that are not fixed, so multiples of the unit do not suffice.
  bool relaxed() const { return relaxed_; }
  /// Events of the slice may come as late as they like. The result is then only a bound.
  bool sporadic() const { return sporadic_; }

 private:
  struct Move {
    int timer;
    int place;
    std::vector<TimerChange> changes;
    bool pays_unfixed;
  };
  struct Hash {
    std::size_t operator()(const std::vector<Nanoseconds>& key) const;
  };

  int place_of(State state, std::vector<int> timers, std::vector<bool> frozen);
  int node_of(int place, std::vector<Nanoseconds> left);
  void points(int place, const Dbm& zone, const std::vector<std::size_t>& variables,
              std::vector<Nanoseconds>& left, int origin, std::size_t most, StopToken& stop);
  const std::vector<Move>& moves(int place);
  void expand(int node);
  void wait(int node, const std::vector<int>& timers, const std::vector<bool>& frozen, Nanoseconds most);
  bool may_wait(int timer) const { return unforced_[static_cast<std::size_t>(timer)]; }
  void arrive(int from, const Move& move, Nanoseconds time, std::vector<Nanoseconds>& left, std::size_t next,
              const std::vector<Range>& ranges);

  Machine sliced_;
  const Slice& slice_;
  Nanoseconds unit_ = 0;
  std::size_t most_ = 0;  // nodes; with more it is given up
  std::vector<GridNode> nodes_;
  std::vector<GridPlace> places_;
  std::vector<std::vector<Move>> moves_;
  std::vector<bool> moves_known_;
  std::vector<GridEdge> edges_;
  std::vector<int> origins_;
  std::unordered_map<State, int, StateHash> place_index_;
  std::unordered_map<std::vector<Nanoseconds>, int, Hash> node_index_;
  std::vector<bool> unforced_;  // by timer: of a sporadic event
  std::size_t tried_ = 0;       // of the points at which a recurrence is entered
  bool stopped_ = false;
  bool sporadic_ = false;
  bool relaxed_ = false;
};

}  // namespace pal::analyzer
