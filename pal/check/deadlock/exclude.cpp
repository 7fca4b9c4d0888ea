#include "pal/check/deadlock/exclude.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace pal::check::deadlock {

namespace {

/// Random runs, the same ones each time, until each of the wanted messages was taken. With the conditions
/// unknown a message may be taken only in runs that the skill does not have.
class Walks {
 public:
  Walks(const Automata& automata, int withdrawn, std::vector<bool> wanted, const std::function<bool()>& stop)
      : moves_(automata, withdrawn),
        threads_(automata.threads.size()),
        wanted_(std::move(wanted)),
        stop_(stop) {}

  /// True: all of them were taken.
  bool run() {
    while (moves_left_ > 0 && some_wanted() && !moves_.overflowed() && !stopped()) walk();
    return !some_wanted() && !moves_.overflowed();
  }

 private:
  bool some_wanted() const { return std::find(wanted_.begin(), wanted_.end(), true) != wanted_.end(); }

  bool stopped() const { return stop_ && stop_(); }

  void walk() {
    constexpr int most_in_one = 2'000;
    State state = moves_.first();
    for (int i = 0; i < most_in_one && !stopped(); ++i) {
      --moves_left_;
      auto moves = next(state);
      if (moves.empty()) return;
      auto& move = moves[below(moves.size())];
      if (move.guessed) return;
      if (move.action.kind == Action::Kind::takes) wanted_[move.action.channel.index()] = false;
      if (move.ended) return;
      state = std::move(move.state);
    }
  }

  /// The moves of a random thread of those that can move.
  std::vector<Move> next(const State& state) {
    std::vector<Move> result;
    const auto first = below(threads_);
    for (std::size_t i = 0; i < threads_ && result.empty(); ++i) {
      moves_.of(state, (first + i) % threads_, result);
    }
    return result;
  }

  std::size_t below(std::size_t size) { return static_cast<std::size_t>(engine_() % size); }

  Moves moves_;
  std::size_t threads_;
  std::vector<bool> wanted_;
  const std::function<bool()>& stop_;
  int moves_left_ = 100'000;
  std::mt19937_64 engine_{1};
};

}  // namespace

std::optional<Decision> exclude(const Automata& automata, int withdrawn, std::size_t most_states,
                                const std::function<bool()>& stop) {
  const auto unknown = without_conditions(automata);
  const Moves any(unknown, withdrawn);
  const Independence independence(unknown, any, unknown.command, true);
  auto decision = decide(unknown, any, independence, most_states, stop);
  if (!decision.complete || decision.total || decision.partial) return std::nullopt;
  std::vector<bool> to_be_taken(automata.request_of.size());
  for (std::size_t c = 0; c < to_be_taken.size(); ++c) {
    to_be_taken[c] = decision.put[c] && !automata.to_device[c];
    if (to_be_taken[c] && !decision.taken[c]) return std::nullopt;
  }
  if (!Walks(automata, withdrawn, std::move(to_be_taken), stop).run()) return std::nullopt;
  return decision;
}

}  // namespace pal::check::deadlock
