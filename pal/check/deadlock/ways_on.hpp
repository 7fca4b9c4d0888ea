// Looks for the shortest run to where a thread can never come to its end.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "pal/check/deadlock/search.hpp"

namespace pal::checker::deadlock {

/// For each state and each thread on which the end of the first thread depends: some way on for it. A run to
/// a state without one must at some time get into the way of the way on that there is now.
class WaysOn {
 public:
  /// `most_states`: that each search for a way may look at, and `most_in_all` that all of them together may;
  /// `stop` ends them as it ends a search.
  WaysOn(const Automata& automata, const Moves& moves, const Independence& independence,
         std::size_t most_states, std::size_t most_in_all, const std::function<bool()>& stop)
      : automata_(automata),
        moves_(moves),
        independence_(independence),
        most_states_(most_states),
        left_(most_in_all),
        stop_(stop) {}

  /// The thread can never move again. False if that was not found out.
  bool never_moves(const State& state, std::size_t thread);
  /// The first thread can never come to its end.
  bool dead(const State& state);
  /// Threads of which one must move before the first thread is dead.
  Threads in_the_way(const State& state);
  /// After `move` from `before` to `after` most ways are what they were.
  void inherit(const State& before, const Move& move);

  /// Some way was not found, nor found to be missing.
  bool complete() const { return complete_; }
  /// No more will be looked at.
  bool exhausted() const { return left_ == 0; }

 private:
  struct Way {
    std::vector<Deed> run;  // empty: none was found
    Threads in_the_way;
    bool missing = false;  // there is none
  };
  using ByThread = std::map<std::size_t, std::shared_ptr<const Way>>;

  const Way& way(const State& state, std::size_t thread);
  bool follows(const State& state, std::size_t thread, const std::vector<Deed>& run) const;
  std::shared_ptr<const Way> described(const State& state, std::size_t thread, std::vector<Deed> run) const;

  const Automata& automata_;
  const Moves& moves_;
  const Independence& independence_;
  std::size_t most_states_;
  std::size_t left_;
  const std::function<bool()>& stop_;
  bool complete_ = true;
  std::unordered_map<State, ByThread> ways_;
};

}  // namespace pal::checker::deadlock
