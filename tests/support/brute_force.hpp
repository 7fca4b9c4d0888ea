// Every run with times that are whole multiples of a unit, one instant at a time. It is slow and simple. With
// the zone graph it shares the machine and nothing else.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>

#include "analyzer/machine/machine.hpp"

namespace pal::test {

struct BruteForce {
  analyzer::Nanoseconds greatest = -1;
  analyzer::Nanoseconds least = -1;
  bool grown = false;     // a value that still grows is over the limit
  bool failed = false;    // an event can stay without a response
  bool complete = false;  // everything was seen; values above the cap are not told apart

  /// The worse of both.
  void add(const BruteForce& other) {
    if (other.greatest >= 0) least = greatest < 0 ? other.least : std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
    grown = grown || other.grown;
    failed = failed || other.failed;
    complete = complete && other.complete;
  }
};

inline BruteForce brute_force(const analyzer::Machine& machine, analyzer::Nanoseconds unit,
                              analyzer::Nanoseconds cap, std::size_t most) {
  using namespace pal::analyzer;
  struct Timer {
    Nanoseconds left = 0;
    bool frozen = false;
    auto operator<=>(const Timer&) const = default;
  };
  struct Node {
    State state;
    std::map<int, Timer> timers;
    std::vector<Nanoseconds> ages;
  };
  BruteForce result;
  std::map<std::pair<std::map<int, Timer>, std::vector<Nanoseconds>>, std::vector<State>> seen;
  std::deque<Node> open;
  std::size_t count = 0;
  const auto visit = [&](Node node) {
    auto& there = seen[{node.timers, node.ages}];
    if (std::find(there.begin(), there.end(), node.state) != there.end()) return;
    there.push_back(node.state);
    ++count;
    open.push_back(std::move(node));
  };
  const auto arrive = [&](const Node* from, Nanoseconds elapsed, int fired, const Outcome& outcome) {
    const auto age = [&](int origin) {
      if (origin < 0) return Nanoseconds{0};
      return std::min(cap, from->ages[static_cast<std::size_t>(origin)] + elapsed);
    };
    const auto show = [&result](Nanoseconds value) {
      result.least = result.greatest < 0 ? value : std::min(result.least, value);
      result.greatest = std::max(result.greatest, value);
    };
    for (int origin : outcome.measured) show(age(origin));
    if (outcome.lost >= 0) show(outcome.lost);
    result.failed = result.failed || outcome.state.failed;
    if (outcome.state.ended) return;
    Node next{outcome.state, {}, {}};
    for (int origin : outcome.origin) {
      next.ages.push_back(age(origin));
      const bool growing = grows(next.state, machine.watch(), static_cast<int>(next.ages.size()) - 1);
      result.grown = result.grown || (growing && next.ages.back() > machine.watch().limit);
    }
    if (from != nullptr) {
      for (auto [timer, of] : from->timers) {
        if (timer == fired) continue;
        if (!of.frozen && of.left > 0) of.left -= elapsed;
        next.timers[timer] = of;
      }
    }
    std::vector<Node> made{next};
    for (const TimerChange& change : outcome.changes) {
      std::vector<Node> more;
      for (Node& node : made) {
        if (change.kind == TimerChange::Kind::start) {
          const bool unbounded = change.range.worst >= Range::unbounded;
          const Nanoseconds last = unbounded ? change.range.best + 8 * unit : change.range.worst;
          for (Nanoseconds left = change.range.best; left <= last; left += unit) {
            node.timers[change.timer] = {left, false};
            more.push_back(node);
          }
          continue;
        }
        if (change.kind == TimerChange::Kind::stop) node.timers.erase(change.timer);
        if (change.kind == TimerChange::Kind::freeze) node.timers[change.timer].frozen = true;
        if (change.kind == TimerChange::Kind::resume) node.timers[change.timer].frozen = false;
        more.push_back(node);
      }
      made = std::move(more);
    }
    for (Node& node : made) visit(std::move(node));
  };
  AllChoices choices;
  do {
    arrive(nullptr, 0, -1, machine.initial(choices, false));
  } while (choices.next());
  while (!open.empty()) {
    if (count > most) return result;
    const Node node = std::move(open.front());
    open.pop_front();
    Nanoseconds least = Range::unbounded;
    for (const auto& [timer, of] : node.timers) {
      if (!of.frozen) least = std::min(least, of.left);
    }
    for (const auto& [timer, of] : node.timers) {
      if (of.frozen || of.left != least) continue;
      AllChoices each;
      do {
        Outcome outcome;
        if (!machine.fire(node.state, timer, each, false, outcome)) break;
        arrive(&node, least, timer, outcome);
      } while (each.next());
    }
  }
  result.complete = true;
  return result;
}

}  // namespace pal::test
