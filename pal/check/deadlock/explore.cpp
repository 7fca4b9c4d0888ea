#include "pal/check/deadlock/explore.hpp"

#include <algorithm>
#include <deque>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "pal/check/deadlock/decide.hpp"
#include "pal/check/deadlock/exclude.hpp"
#include "pal/check/deadlock/search.hpp"
#include "pal/check/deadlock/ways_on.hpp"

namespace pal::check::deadlock {

namespace {

constexpr std::size_t most_nearby = 10'000;

class DeadlockExplorer {
 public:
  DeadlockExplorer(const Automata& automata, const Limits& limits)
      : automata_(automata),
        moves_(automata, limits.withdrawn),
        most_(std::min(limits.states, limits.words / moves_.words() + 1)),
        at_first_(limits.at_first),
        shared_(limits.shared),
        withdrawn_(limits.withdrawn),
        stop_(limits.stop),
        plain_(automata, moves_, std::vector<bool>(automata.request_of.size()), false) {}

  Findings run() {
    const auto decision = decision_of();
    result_.complete = decision.complete;
    result_.blurred = decision.blurred;
    result_.states = decision.states;
    // What could not be decided is still looked for nearby.
    if (!decision.complete) most_ = std::min(most_, most_nearby);
    if (decision.complete) {
      for (std::size_t c = 0; c < decision.put.size(); ++c) {
        if (decision.put[c] && !decision.taken[c] && !automata_.to_device[c]) result_.untaken.emplace_back(c);
      }
    }
    if (decision.total || !decision.complete) find_total();
    if (decision.partial || !decision.complete) find_partial();
    if (!find_undelivered(decision.undelivered, most_)) result_.complete = false;
    result_.stopped = !result_.complete && stopped();
    result_.overflowed = moves_.overflowed() || (decision.blurred && !result_.complete);
    return std::move(result_);
  }

 private:
  bool stopped() const { return stop_ && stop_(); }

  /// Small skills as they are; of large ones it is seen first whether the values of conditions matter at all.
  Decision decision_of() {
    const Independence absorbing(automata_, moves_, automata_.command, true);
    const auto at_first = automata_.bits == 0 ? most_ : std::min(at_first_, most_);
    auto decision = decide(automata_, moves_, absorbing, at_first, stop_);
    if (decision.complete || at_first == most_ || moves_.overflowed() || stopped()) return decision;
    if (auto excluded = exclude(automata_, withdrawn_, most_, stop_)) {
      result_.without_values = find_undelivered(excluded->undelivered, most_ / 4);
      if (result_.without_values) {
        excluded->undelivered.clear();
        return *excluded;
      }
      result_.undelivered.clear();
    }
    return decide(automata_, moves_, absorbing, most_, stop_);
  }

  Found look(const Independence& independence, const State& from, const Goal& goal) {
    auto found = search(moves_, independence, automata_.threads.size(), from, goal, most_, stop_);
    result_.complete = result_.complete && found.complete;
    return found;
  }

  void find_total() {
    Goal goal;
    goal.state = [](const State&, const Enabled& enabled) { return enabled.can_move().none(); };
    const auto found = look(plain_, moves_.first(), goal);
    if (!found.way) return;
    total_length_ = found.way->length;
    result_.total = DeadEnd{true, found.way->length.timely > 0, found.way->run, found.way->run.size(), {}, 0};
    WaysOn ways(automata_, moves_, plain_, most_, shared_, stop_);
    describe(*result_.total, found.way->state, ways);
  }

  void find_partial() {
    WaysOn ways(automata_, moves_, plain_, most_, shared_, stop_);
    Goal goal;
    goal.state = [&](const State& state, const Enabled&) { return ways.dead(state); };
    goal.needed = [&](const State& state, const Enabled& enabled) {
      if (ways.exhausted()) {
        result_.complete = false;
        return Threads();
      }
      const auto needed = ways.in_the_way(state);
      for (const auto& moves : choose_moves(state, enabled, needed)) ways.inherit(state, *moves);
      return needed;
    };
    const auto found = look(plain_, moves_.first(), goal);
    result_.complete = result_.complete && ways.complete();
    // Of two with one cause the one in which all stop says more.
    if (!found.way || (result_.total && total_length_.timely <= found.way->length.timely)) return;
    DeadEnd end{false, found.way->length.timely > 0, found.way->run, found.way->run.size(), {}, 0};
    const auto last = farthest(found.way->state, ways);
    end.run.insert(end.run.end(), last.first.begin(), last.first.end());
    describe(end, last.second, ways);
    result_.partial = std::move(end);
  }

  std::vector<const Move*> choose_moves(const State& state, const Enabled& enabled, const Threads& needed) {
    std::vector<const Move*> result;
    const auto chosen = choose(plain_, state, enabled, needed);
    for (std::size_t t = 0; t < enabled.size(); ++t) {
      if (!chosen.test(t)) continue;
      for (const auto& move : enabled[t]) result.push_back(&move);
    }
    return result;
  }

  /// Of those channels, as far as there is a run. False: there may be one where none was found.
  bool find_undelivered(const std::vector<bool>& channels, std::size_t most) {
    bool complete = true;
    auto left = shared_;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (!channels[c]) continue;
      const auto found = find_undelivered(pan::ChannelId(c), std::min(most, left));
      left -= std::min(left, found.states);
      complete = complete && found.complete;
      if (found.way)
        result_.undelivered.push_back({pan::ChannelId(c), found.way->length.timely > 0, found.way->run});
    }
    return complete;
  }

  Found find_undelivered(pan::ChannelId channel, std::size_t most) const {
    std::vector<bool> observed(automata_.request_of.size());
    observed[channel.index()] = true;
    const Independence independence(automata_, moves_, observed, false);
    Goal goal;
    goal.move = [&](const State& before, const Move& move) {
      return move.action.kind == Action::Kind::completes && moves_.full(before, channel);
    };
    Threads method;
    for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
      const auto& parent = automata_.threads[t].parent;
      if (t == 0 || (parent && method.test(*parent))) method.set(t);
    }
    goal.needed = [&](const State&, const Enabled&) { return method; };
    return search(moves_, independence, automata_.threads.size(), moves_.first(), goal, most, stop_);
  }

  void describe(DeadEnd& end, const State& state, WaysOn& ways) {
    end.stuck = stuck(state, ways);
    for (std::size_t i = end.stuck.size(); i-- > 0;) {
      auto root = end.stuck[i].thread;
      while (automata_.threads[root].parent) root = *automata_.threads[root].parent;
      if (root == 0) end.culprit = i;
    }
  }

  std::vector<Stuck> stuck(const State& state, WaysOn& ways) {
    std::vector<Stuck> result;
    for (std::size_t t = 0; t < automata_.threads.size(); ++t) {
      if (!moves_.active(state, t)) continue;
      const auto& step = moves_.at(state, t);
      if ((step.kind != Step::Kind::wait && step.kind != Step::Kind::send) || !ways.never_moves(state, t))
        continue;
      Stuck one{t, static_cast<std::size_t>(&step - automata_.steps.data()), step.kind == Step::Kind::wait};
      for (const auto channel : step.channels) {
        const auto& request = automata_.request_of[channel.index()];
        if (!request || moves_.open(state, *request) > 0) one.never_asked = false;
      }
      result.push_back(one);
    }
    return result;
  }

  /// The nearest state from here in which as many threads as ever wait for ever, and the way there, without a
  /// lucky time.
  std::pair<std::vector<Action>, State> farthest(const State& from, WaysOn& ways) {
    constexpr std::size_t most_looked_at = 2000;
    std::unordered_map<State, std::pair<State, Action>> by{{from, {}}};
    std::deque<State> open{from};
    State best = from;
    auto most = stuck(from, ways).size();
    while (!open.empty() && by.size() < most_looked_at && !stopped()) {
      const auto at = std::move(open.front());
      open.pop_front();
      if (const auto count = stuck(at, ways).size(); count > most) {
        best = at;
        most = count;
      }
      const Enabled enabled(moves_, at, automata_.threads.size());
      for (const auto* move : choose_moves(at, enabled, {})) {
        if (move->timely || move->ended || moves_.blurred(move->state)) continue;
        if (by.emplace(move->state, std::pair(at, move->action)).second) open.push_back(move->state);
      }
    }
    std::pair<std::vector<Action>, State> result{{}, best};
    for (auto at = best; at != from; at = by.at(at).first) result.first.push_back(by.at(at).second);
    std::reverse(result.first.begin(), result.first.end());
    return result;
  }

  const Automata& automata_;
  Moves moves_;
  std::size_t most_;
  std::size_t at_first_;
  std::size_t shared_;
  int withdrawn_;
  const std::function<bool()>& stop_;
  Independence plain_;
  Length total_length_;
  Findings result_;
};

}  // namespace

Findings explore(const Automata& automata, const Limits& limits) {
  if (automata.threads.empty()) return {};
  Findings undecided;
  undecided.complete = false;
  if (automata.steps.size() > most_steps || automata.threads.size() > most_threads) return undecided;
  return DeadlockExplorer(automata, limits).run();
}

}  // namespace pal::check::deadlock
