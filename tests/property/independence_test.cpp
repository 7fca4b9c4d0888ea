// What the search for deadlocks takes for independent can be done in either order.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <random>
#include <set>

#include "pal/check/deadlock/independence.hpp"
#include "tests/support/random_talk.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/talking_skill.hpp"

using namespace pal;
using namespace pal::check;
using namespace pal::check::deadlock;
using pal::test::setting;
using pal::test::talking_skill;

namespace {

/// Walks through the states of a skill. In each state the search has chosen a set of threads, which the
/// others should not disturb. Take a move of the set after a few moves of others. It must be possible before
/// them, and they must then lead to the same state in some order (Godefroid, Partial-Order Methods, 1996:
/// persistent sets). Their order may be another one: of two blocks the one that ends last ends the
/// CONCURRENT, and stops the others.
class Walk {
 public:
  Walk(const Automata& automata, std::uint64_t seed)
      : threads_(automata.threads.size()),
        moves_(automata),
        independence_(automata, moves_, std::vector<bool>(automata.request_of.size()), false),
        engine_(seed) {}

  /// How many moves after others were compared.
  std::size_t run() {
    State state = moves_.first();
    for (int i = 0; i < 60 && !moves_.blurred(state) && !moves_.overflowed(); ++i) {
      const Enabled enabled(moves_, state, threads_);
      for (std::size_t t = 0; t < threads_; ++t) {
        if (enabled[t].empty()) continue;
        const auto set = independence_.closure(state, enabled, Threads().set(t));
        if (set) leave_alone(state, *set, t);
      }
      auto moves = some(state, Threads());
      if (moves.empty()) break;
      auto& move = moves[below(moves.size())];
      if (move.ended) break;
      state = std::move(move.state);
    }
    return compared_;
  }

 private:
  /// With how many lucky times, and to where.
  using Reached = std::set<std::pair<int, State>>;

  void leave_alone(const State& before, const Threads& set, std::size_t thread) {
    State state = before;
    int timely = 0;
    std::vector<std::size_t> others;
    for (int i = 0; i < 5; ++i) {
      auto moves = some(state, set);
      if (moves.empty()) return;
      auto& move = moves[below(moves.size())];
      if (move.ended || moves_.blurred(move.state)) return;
      others.push_back(move.action.thread);
      timely += move.timely ? 1 : 0;
      state = std::move(move.state);
      std::vector<Move> after;
      moves_.of(state, thread, after);
      REQUIRE_FALSE(after.empty());
      for (std::size_t t = 0; t < threads_; ++t) {
        // One that was blocked and is then cancelled stops: no move enables that but the cancelling.
        const bool stops = moves_.finishing(state, t) && !moves_.finishing(before, t);
        if (set.test(t) && !stops) compare(before, others, state, timely, t);
      }
    }
  }

  void compare(const State& before, const std::vector<std::size_t>& others, const State& state, int timely,
               std::size_t thread) {
    std::vector<Move> after;
    moves_.of(state, thread, after);
    if (after.empty()) return;
    auto in_order = others;
    std::sort(in_order.begin(), in_order.end());
    const auto reached = in_any_order(next({{0, before}}, thread), in_order);
    for (const auto& move : after) {
      if (moves_.blurred(move.state) || moves_.overflowed()) return;
      CAPTURE(thread, others, static_cast<int>(move.action.kind));
      REQUIRE(reached.contains({timely + (move.timely ? 1 : 0), move.state}));
      ++compared_;
    }
  }

  Reached in_any_order(const Reached& from, const std::vector<std::size_t>& threads) const {
    if (threads.empty() || from.empty()) return from;
    Reached result;
    for (std::size_t i = 0; i < threads.size(); ++i) {
      if (i > 0 && threads[i] == threads[i - 1]) continue;
      auto rest = threads;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      result.merge(in_any_order(next(from, threads[i]), rest));
    }
    return result;
  }

  Reached next(const Reached& from, std::size_t thread) const {
    Reached result;
    for (const auto& [timely, state] : from) {
      std::vector<Move> moves;
      moves_.of(state, thread, moves);
      for (const auto& move : moves) result.emplace(timely + (move.timely ? 1 : 0), move.state);
    }
    return result;
  }

  /// The moves of a random thread, none of `but`, of those that can move.
  std::vector<Move> some(const State& state, const Threads& but) {
    std::vector<Move> result;
    const auto first = below(threads_);
    for (std::size_t i = 0; i < threads_ && result.empty(); ++i) {
      const auto t = (first + i) % threads_;
      if (!but.test(t)) moves_.of(state, t, result);
    }
    return result;
  }

  std::size_t below(std::size_t size) { return static_cast<std::size_t>(engine_() % size); }

  std::size_t threads_;
  Moves moves_;
  Independence independence_;
  std::mt19937_64 engine_;
  std::size_t compared_ = 0;
};

/// How many moves were compared on four walks.
std::size_t walk(const std::string& text, std::uint64_t seed) {
  const auto skill = talking_skill(text);
  if (!skill) return 0;
  INFO("seed " << seed << "\n" << text);
  const auto automata = deadlock::automata(*skill, pan::Flow(*skill));
  std::size_t compared = 0;
  for (std::uint64_t i = 0; i < 4; ++i) compared += Walk(automata, 10 * seed + i).run();
  return compared;
}

}  // namespace

TEST_CASE("stubborn sets: a move that is possible after moves of others is so before them") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  std::size_t compared = 0;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 100); ++seed) {
    compared += walk(test::RandomTalk(seed).text(), seed);
    compared += walk(test::RandomNest(seed).text(), seed);
    compared += walk(test::RandomPolling(seed).text(), seed);
  }
  std::cout << compared << " moves compared\n";
  CHECK(compared > 0);
}

// The last block that stops takes its parent with it, whose request another thread may be about to take.
TEST_CASE("what a parent has asked for is withdrawn with its last block") {
  CHECK(walk(test::RandomTalk(1233).text(), 1233) > 0);
}
