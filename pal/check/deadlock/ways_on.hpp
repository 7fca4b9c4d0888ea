// The shortest run to a state in which a thread can never come to its end.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "pal/check/deadlock/search.hpp"

namespace pal::check::deadlock {

/// For each state, and each thread on which the end of the first thread depends, this keeps some way on for
/// that thread. A run to a state without such a way must at some time interfere with the way that exists now.
class WaysOn {
 public:
  /// `most_states` limits each search for a way, and `most_in_all` all of them together. `stop` ends them as
  /// it ends a search.
  WaysOn(const Automata& automata, const Moves& moves, const Independence& independence,
         std::size_t most_states, std::size_t most_in_all, const std::function<bool()>& stop)
      : automata_(automata),
        moves_(moves),
        independence_(independence),
        most_states_(most_states),
        left_(most_in_all),
        stop_(stop) {}

  /// The thread can never move again. False also if that was not found out.
  bool never_moves(const State& state, std::size_t thread);
  /// The first thread can never come to its end.
  bool dead(const State& state);
  /// One of these threads must move before the first thread is dead.
  Threads in_the_way(const State& state);
  /// Most ways are still valid after `move` from `before` to `after`.
  void inherit(const State& before, const Move& move);

  /// For some way it was not found out whether it exists.
  bool complete() const { return complete_; }
  /// The limits are used up.
  bool exhausted() const { return left_ == 0; }

 private:
  struct Way {
    std::vector<Action> run;  // empty: none was found
    Threads in_the_way;
    bool missing = false;  // there is none
  };
  using ByThread = std::map<std::size_t, std::shared_ptr<const Way>>;

  const Way& way(const State& state, std::size_t thread);
  bool follows(const State& state, std::size_t thread, const std::vector<Action>& run) const;
  std::shared_ptr<const Way> described(const State& state, std::size_t thread, std::vector<Action> run) const;

  const Automata& automata_;
  const Moves& moves_;
  const Independence& independence_;
  std::size_t most_states_;
  std::size_t left_;
  const std::function<bool()>& stop_;
  bool complete_ = true;
  std::unordered_map<State, ByThread> ways_;
};

}  // namespace pal::check::deadlock
