// Which moves of a state are enough: of moves that do not get into each other's way one order stands for all.
//
// Persistent sets (Godefroid, Partial-Order Methods for the Verification of Concurrent Systems, 1996), a set
// of threads for each state: what the others can ever do leaves the next steps of the set as they are. Such
// sets keep every state in which nothing can move, and the length of the shortest run to it.
#pragma once

#include <cstddef>
#include <vector>

#include "pal/check/deadlock/moves.hpp"

namespace pal::frontend::deadlock {

class Reduction {
 public:
  Reduction(const Automata& automata, const Moves& moves);

  /// By thread: its moves in this state.
  using Enabled = std::vector<std::vector<Move>>;

  /// The threads whose moves are to be followed, of those that can move; fewest moves first found.
  std::vector<std::size_t> choose(const State& state, const Enabled& enabled) const;

 private:
  /// What a thread may do to something that others share.
  enum class Use { put, take, withdraw, device, read, write };
  std::size_t resource(Use use, std::size_t index) const;
  void use_step(const Step& step, std::vector<bool>& uses) const;
  void use_request(const Step& step, std::vector<bool>& uses) const;

  bool concerns_all(const State& state, std::size_t thread, const std::vector<Move>& moves) const;
  void disturbing(const State& state, std::size_t thread, std::vector<std::size_t>& resources) const;
  bool close(const State& state, const Enabled& enabled, std::size_t seed, std::vector<bool>& in) const;
  bool is_above(std::size_t above, std::size_t thread) const;
  std::size_t root_of(std::size_t thread) const;

  const Automata& automata_;
  const Moves& moves_;
  std::vector<std::vector<bool>> uses_;          // by thread, with its blocks: by resource
  std::vector<std::vector<std::size_t>> users_;  // by resource: threads
  std::vector<std::size_t> answer_of_;           // by channel; the number of channels: none
  std::vector<bool> cancellable_;                // by thread
};

}  // namespace pal::frontend::deadlock
