// Which threads get into each other's way, and so which moves of a state are enough: of moves that do not,
// one order stands for all.
//
// Stubborn sets (Valmari, Stop it, and be stubborn!, 2017; Godefroid, Partial-Order Methods, 1996), a set of
// threads for each state: whatever the others do, for as long as they like, leaves the next moves of the set
// as they are and brings none about.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pal/check/deadlock/moves.hpp"
#include "pal/check/deadlock/threads.hpp"

namespace pal::checker::deadlock {

class Independence {
 public:
  /// `observed`, by channel: that a message is still there when the skill completes is told apart from that
  /// it was taken. `absorb`: a block's move that its cancellation would undo needs not wait for that
  /// cancellation to be tried first. This keeps what can be reached, but not the length of the way there.
  Independence(const Automata& automata, const Moves& moves, std::vector<bool> observed, bool absorb);

  /// The least set with `seeds` that the others leave alone. Nothing: only all moves are such a set.
  std::optional<Threads> closure(const State& state, const Enabled& enabled, const Threads& seeds) const;

  bool from_device(pan::ChannelId channel) const { return automata_.from_device[channel.index()]; }

  /// Those that may, now or later, do what the thread's next move depends on.
  Threads disturbing(const State& state, std::size_t thread, const std::vector<Move>& moves) const;

 private:
  /// What a thread may do to something that others share.
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

}  // namespace pal::checker::deadlock
