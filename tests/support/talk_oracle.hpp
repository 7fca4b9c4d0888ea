// Every interleaving of a small skill's modules (talk.hpp), for comparison with pal/check/deadlock.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/talk.hpp"

namespace pal::test {

class TalkOracle {
 public:
  /// Times that must be right, then messages sent, taken or given up.
  using Length = std::pair<int, int>;

  struct Result {
    bool complete = true;
    std::optional<Length> total;                // to where nothing moves
    std::optional<Length> dead;                 // to where the method can never end
    std::set<std::size_t> untaken;              // channels
    std::map<std::size_t, Length> undelivered;  // channels, to the completion
  };

  TalkOracle(const pan::Network& network, std::size_t most_states)
      : network_(network), talk_(network), most_(most_states) {}

  Result run();

 private:
  using State = talk::State;
  struct Edge {
    std::size_t from, to;
    bool timely, talk;
    std::vector<bool> moved;  // by number of thread
  };

  std::size_t number(State state);
  void explore();
  std::vector<Length> lengths() const;
  void conclude();
  bool dead(const State& state, const std::vector<bool>& moves, int thread) const;

  const pan::Network& network_;
  talk::Talk talk_;
  std::size_t most_;
  std::map<State, std::size_t> known_;
  std::vector<const State*> states_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> completions_;
  std::set<std::size_t> put_, taken_;
  Result result_;
};

}  // namespace pal::test
