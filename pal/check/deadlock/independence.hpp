// Which threads interfere, and so which moves of a state suffice: moves that do not interfere need only one
// order.
//
// Stubborn sets (Valmari, Stop it, and be stubborn!, 2017; Godefroid, Partial-Order Methods, 1996), as a set
// of threads for each state. Whatever the other threads do, for as long as they like, neither changes the
// next moves of the set nor enables new ones.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pal/check/deadlock/moves.hpp"
#include "pal/check/deadlock/threads.hpp"

namespace pal::check::deadlock {

class Independence {
 public:
  /// `observed`, by channel: the result must tell whether a message is still there when the skill completes,
  /// or was taken. `absorb`: a move that the cancellation of its block would undo is explored before that
  /// cancellation only. This keeps what can be reached, but not the lengths of runs.
  Independence(const Automata& automata, const Moves& moves, std::vector<bool> observed, bool absorb);

  /// The least set with `seeds` that the other threads do not influence. Nothing: only the set of all moves.
  std::optional<Threads> closure(const State& state, const Enabled& enabled, const Threads& seeds) const;

  bool from_device(pan::ChannelId channel) const { return automata_.from_device[channel.index()]; }

  /// Those that may, now or later, do something on which the thread's next move depends.
  Threads disturbing(const State& state, std::size_t thread, const std::vector<Move>& moves) const;

 private:
  /// What a thread may do to something that it shares with others.
  enum class Use { put, take, withdraw, device, read, write, complete };
  std::size_t resource(Use use, std::size_t index) const;
  void enter_uses(std::size_t index);

  bool concerns_all(const State& state, std::size_t thread, const std::vector<Move>& moves) const;
  bool undone_by_cancelling(const State& state, std::size_t thread, const std::vector<Move>& moves) const;
  void add_users(const State& state, Use use, std::size_t index, std::size_t thread, Threads& result) const;
  void add_withdrawers(const State& state, std::size_t request, std::size_t thread, Threads& result) const;
  void add_channels(const State& state, std::size_t thread, bool withdrawers, Threads& result) const;
  Threads disturbing_step(const State& state, std::size_t thread, bool withdrawers) const;
  std::optional<Threads> disturbing_service(const State& state, std::size_t thread,
                                            const std::vector<Move>& moves) const;
  std::optional<std::size_t> helper(const State& state, std::size_t thread) const;
  void add_conditions(const State& state, std::size_t thread, Threads& result) const;
  std::size_t step_of(const State& state, std::size_t thread) const;

  const Automata& automata_;
  const Moves& moves_;
  std::vector<bool> observed_;
  bool absorb_;
  StepSets future_;                  // by step: what is used there or later
  std::vector<Threads> users_;       // by resource: threads that ever use it
  std::vector<Threads> cancellers_;  // by thread: those whose end may cancel it
  std::vector<Threads> above_;       // by thread: its parent, its parent's parent, …
};

}  // namespace pal::check::deadlock
