// The events of a path as constraints on the times at which they happen.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "analyzer/runs/concrete_run.hpp"
#include "analyzer/runs/linear_times.hpp"

namespace pal::analyzer {

/// Of a path, what grows at its end: nothing that is asked for; or the first of the values that do.
constexpr int no_growth = -1;
constexpr int oldest_growth = -2;

/// Times at which a path can fire as it does, with what its last event measures as far as it can be.
class PathSchedule {
 public:
  /// How long an action takes that preempts others and whose time is not fixed: any time within its interval
  /// (open), or one that makes differences of all constraints.
  enum class Pin { open, worst, best };

  /// `growing`: the observer after the last event whose value is in question, or oldest_growth; no_growth:
  /// what the last event measures.
  PathSchedule(const Machine& machine, const std::vector<ScriptedFiring>& path, Pin pin,
               int growing = no_growth);

  /// False: the path cannot fire as it does, or nothing grows at its end.
  bool feasible() const { return feasible_; }
  /// Times were fixed: another pin may give other ones.
  bool pinned() const { return pinned_; }

  enum class Aim { any, greatest, least };

  /// Times of all events such that what was measured at the last is as great, or as small, as it can be;
  /// nothing if impossible. A value that can grow without end is made as great as `enough`; one that cannot
  /// is never beyond it. `less_will_not_do`: as in Goal.
  std::optional<std::vector<Nanoseconds>> solve(Aim aim, Nanoseconds enough = Range::unbounded,
                                                const std::function<bool()>& stop = {},
                                                bool less_will_not_do = false) const;

  /// At the end `timer` has `left` to go.
  void leave(int timer, Nanoseconds left);

 private:
  struct Life {
    bool active = false;
    std::size_t started = 0;
    Range range;
    Nanoseconds owed = 0;  // processor time that others had while this one was frozen
    bool frozen = false;
    std::size_t froze = 0;
    std::size_t resumed = 0;
    std::vector<std::pair<std::size_t, std::size_t>> pieces;  // that are over
  };

  std::optional<Goal> goal_of(Aim aim, Nanoseconds enough) const;
  std::optional<std::vector<Nanoseconds>> by_differences(Aim aim, Nanoseconds enough,
                                                         const std::function<bool()>& stop) const;
  void worked(Life life, std::size_t until, bool over);
  void between(std::size_t from, std::size_t to, Nanoseconds least, Nanoseconds most);
  bool build(const std::vector<ScriptedFiring>& path);
  bool find_oldest();
  void still_open(const Life& life, std::size_t until);
  void pay(ProcessorId processor, int timer, Range& range);
  void apply_changes(std::size_t k);

  const Machine& machine_;
  ConcreteRun concrete_run_;
  std::vector<Life> lives_;
  Pin pin_;
  int growing_;
  std::vector<Difference> constraints_;
  std::vector<Work> works_;  // without pins: of what was interrupted
  std::vector<std::size_t> births_at_end_;
  std::size_t count_ = 0;
  bool feasible_ = false;
  bool pinned_ = false;
};

}  // namespace pal::analyzer
