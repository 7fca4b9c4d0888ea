// What the modules of a skill can do, worked out from their graphs alone in the plainest way: every
// interleaving, every step a state. For comparison with pal/check/deadlock, with which it shares nothing.
//
// Left out: devices that lose answers. A skill must not have two requests to a device open at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "pal/pan/network.hpp"

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

  TalkOracle(const pan::Network& network, std::size_t most_states) : network_(network), most_(most_states) {}

  Result run() {
    explore();
    if (result_.complete) conclude();
    return result_;
  }

 private:
  struct Place {
    std::size_t module;
    std::size_t node;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct Thread {
    std::vector<Place> at;  // the last one is where it is; those before execute it
    int parent = -1;
    std::size_t name = 0;  // the same block, begun again, has the same
    bool can_end = true;
    bool finishing = false;
    bool gone = false;
    std::map<std::size_t, bool> latched;
    friend auto operator<=>(const Thread&, const Thread&) = default;
  };
  /// A request or answer channel.
  struct Slot {
    bool full = false;
    int discard = 0;               // answers nobody wants any more
    std::vector<int> waiting_for;  // threads whose request has no answer yet that was taken, oldest first
    std::size_t last_asker = 0;    // its name
    friend auto operator<=>(const Slot&, const Slot&) = default;
  };
  struct State {
    std::vector<Thread> threads;
    std::vector<Slot> slots;
    std::vector<bool> values;
    bool ended = false;
    friend auto operator<=>(const State&, const State&) = default;
  };
  struct Step {
    State to;
    bool timely = false;
    bool talk = false;
    int thread = -1;
    bool completes = false;
    std::optional<std::size_t> put, take;
  };

  const pan::Node& node(const Place& place) const {
    return network_.modules[place.module].body.nodes[place.node];
  }
  const pan::Node& node(const State& state, int thread) const {
    return node(state.threads[at(thread)].at.back());
  }
  static std::size_t name(std::size_t module, std::size_t node) { return module * 100'000 + node + 1; }
  static std::size_t at(int thread) { return static_cast<std::size_t>(thread); }

  bool is_device(const pan::Party& party) const {
    const auto* module = std::get_if<pan::ModuleId>(&party);
    return module == nullptr || network_.modules[module->index()].body.empty();
  }
  std::optional<std::size_t> answer_to(std::size_t request) const {
    const auto& answer = network_.channels[request].answer;
    return answer.valid() ? std::optional(answer.index()) : std::nullopt;
  }
  std::optional<std::size_t> request_for(std::size_t answer) const {
    for (std::size_t c = 0; c < network_.channels.size(); ++c) {
      if (answer_to(c) == answer) return c;
    }
    return std::nullopt;
  }

  // ---- can a block end? By search over its nodes, all guards free.
  bool block_can_end(std::size_t module, std::size_t first) const {
    std::set<std::size_t> seen{first};
    std::deque<std::size_t> open{first};
    const auto& nodes = network_.modules[module].body.nodes;
    while (!open.empty()) {
      const auto& here = nodes[open.front()];
      open.pop_front();
      if (std::holds_alternative<pan::End>(here.content)) return true;
      std::vector<std::size_t> next;
      if (std::holds_alternative<pan::Complete>(here.content)) continue;
      if (const auto* until = std::get_if<pan::Until>(&here.content)) {
        next.push_back(here.mate.index());
        if (until->guard) next.push_back(here.out.front().index());
      } else if (std::holds_alternative<pan::Fork>(here.content)) {
        bool some = false;
        for (const auto block : here.out) some = some || block_can_end(module, block.index());
        if (some) next.push_back(nodes[here.mate.index()].out.front().index());
      } else if (const auto* execute = std::get_if<pan::Execute>(&here.content)) {
        const auto callee = execute->module.index();
        if (network_.modules[callee].body.empty() || block_can_end(callee, 0))
          next.push_back(here.out.front().index());
      } else {
        for (const auto out : here.out) next.push_back(out.index());
      }
      for (const auto n : next) {
        if (seen.insert(n).second) open.push_back(n);
      }
    }
    return false;
  }

  // ---- reaching statements

  void go_to(State state, int thread, std::size_t target, std::vector<State>& result) const {
    state.threads[at(thread)].at.back().node = target;
    settle(std::move(state), thread, result);
  }

  /// Passes what takes no step of its own.
  void settle(State state, int thread, std::vector<State>& result) const {
    for (int guard = 0; guard < 200; ++guard) {
      auto& here = state.threads[at(thread)];
      const auto place = here.at.back();
      const auto& n = node(place);
      if (std::holds_alternative<pan::End>(n.content)) {
        if (here.at.size() > 1) {
          here.at.pop_back();
          here.at.back().node = node(here.at.back()).out.front().index();
          continue;
        }
        if (here.parent < 0) break;
        here.gone = true;
        here.latched.clear();
        const int parent = here.parent;
        return block_gone(std::move(state), parent, result);
      }
      if (const auto* execute = std::get_if<pan::Execute>(&n.content)) {
        if (network_.modules[execute->module.index()].body.empty()) {
          here.at.back().node = n.out.front().index();
        } else {
          here.at.push_back({execute->module.index(), 0});
        }
        continue;
      }
      if (const auto* until = std::get_if<pan::Until>(&n.content); until != nullptr && !until->guard) {
        here.at.back().node = n.mate.index();
        continue;
      }
      if (std::holds_alternative<pan::Fork>(n.content)) return fork(std::move(state), thread, result);
      const bool silent = std::holds_alternative<pan::Start>(n.content) ||
                          std::holds_alternative<pan::WaitForStart>(n.content) ||
                          std::holds_alternative<pan::Perform>(n.content) ||
                          std::holds_alternative<pan::Nothing>(n.content) ||
                          std::holds_alternative<pan::Merge>(n.content) ||
                          std::holds_alternative<pan::Loop>(n.content);
      if (!silent) break;
      here.at.back().node = n.out.front().index();
    }
    result.push_back(std::move(state));
  }

  void fork(State state, int parent, std::vector<State>& result) const {
    const auto place = state.threads[at(parent)].at.back();
    const auto& n = node(place);
    std::vector<int> blocks;
    for (std::size_t i = 0; i < n.out.size(); ++i) {
      Thread block;
      block.at = {{place.module, n.out[i].index()}};
      block.parent = parent;
      block.name = name(place.module, n.out[i].index());
      block.can_end = block_can_end(place.module, n.out[i].index());
      block.latched = state.threads[at(parent)].latched;
      std::size_t place_for = 0;
      while (place_for < state.threads.size() && !state.threads[place_for].gone) ++place_for;
      if (place_for == state.threads.size()) state.threads.emplace_back();
      state.threads[place_for] = std::move(block);
      blocks.push_back(static_cast<int>(place_for));
    }
    state.threads[at(parent)].at.back().node = n.mate.index();  // waits at the join
    std::vector<State> now{std::move(state)};
    for (const int block : blocks) {
      std::vector<State> more;
      for (auto& each : now) {
        if (each.threads[at(block)].gone || each.threads[at(block)].finishing) {
          more.push_back(std::move(each));
        } else {
          settle(std::move(each), block, more);
        }
      }
      now = std::move(more);
    }
    for (auto& each : now) result.push_back(std::move(each));
  }

  std::vector<int> blocks_of(const State& state, int parent) const {
    std::vector<int> result;
    for (std::size_t t = 0; t < state.threads.size(); ++t) {
      if (state.threads[t].parent == parent && !state.threads[t].gone) result.push_back(static_cast<int>(t));
    }
    return result;
  }

  void block_gone(State state, int parent, std::vector<State>& result) const {
    const auto blocks = blocks_of(state, parent);
    const auto& above = state.threads[at(parent)];
    if (blocks.empty()) {
      if (above.finishing) return stop(std::move(state), parent, result);
      const auto next = node(above.at.back()).out.front().index();
      return go_to(std::move(state), parent, next, result);
    }
    bool can_end = false;
    for (const int b : blocks)
      can_end = can_end || (state.threads[at(b)].can_end && !state.threads[at(b)].finishing);
    if (above.finishing || !can_end) return cancel(std::move(state), parent, result);
    result.push_back(std::move(state));
  }

  /// All blocks that are not yet cancelled are.
  void cancel(State state, int parent, std::vector<State>& result) const {
    for (const int b : blocks_of(state, parent)) {
      if (state.threads[at(b)].finishing) continue;
      State finishing = state;
      finishing.threads[at(b)].finishing = true;
      if (!blocks_of(state, b).empty()) return cancel(std::move(finishing), b, result);
      if (may_be_working(state, b)) cancel(std::move(finishing), parent, result);
      return stop(std::move(state), b, result);
    }
    const auto& above = state.threads[at(parent)];
    if (above.finishing && above.parent >= 0) return cancel(std::move(state), above.parent, result);
    result.push_back(std::move(state));
  }

  bool may_be_working(const State& state, int thread) const {
    const auto& n = node(state, thread);
    if (const auto* wait = std::get_if<pan::Wait>(&n.content)) {
      return std::any_of(wait->channels.begin(), wait->channels.end(),
                         [&](pan::ChannelId c) { return available(state, c.index()); });
    }
    return std::holds_alternative<pan::Send>(n.content) || std::holds_alternative<pan::Set>(n.content);
  }

  void stop(State state, int thread, std::vector<State>& result) const {
    auto& self = state.threads[at(thread)];
    self.gone = true;
    self.finishing = false;
    self.latched.clear();
    for (std::size_t c = 0; c < state.slots.size(); ++c) {
      if (!state.slots[c].waiting_for.empty() && state.slots[c].last_asker == self.name) withdraw(state, c);
    }
    block_gone(std::move(state), state.threads[at(thread)].parent, result);
  }

  // ---- messages

  bool available(const State& state, std::size_t channel) const {
    if (!is_device(network_.channels[channel].sender)) return state.slots[channel].full;
    const auto request = request_for(channel);
    return !request || !state.slots[*request].waiting_for.empty();
  }

  /// Every open request: out of its slot, or its answer out of its slot, or the answer to come is not wanted.
  void withdraw(State& state, std::size_t request) const {
    auto& slot = state.slots[request];
    if (const auto answer = answer_to(request); answer && !is_device(network_.channels[request].receiver)) {
      auto& back = state.slots[*answer];
      for (std::size_t i = 0; i < slot.waiting_for.size(); ++i) {
        if (slot.full) {
          slot.full = false;
        } else if (back.full) {
          back.full = false;
        } else {
          ++back.discard;
        }
      }
    }
    slot.waiting_for.clear();
    slot.last_asker = 0;
  }

  void take(State& state, std::size_t channel) const {
    state.slots[channel].full = false;
    if (const auto request = request_for(channel)) {
      auto& open = state.slots[*request].waiting_for;
      if (!open.empty()) open.erase(open.begin());
      if (open.empty()) state.slots[*request].last_asker = 0;
    }
  }

  // ---- steps

  /// The thread is done with its statement and goes on, or stops.
  void done(Step step, std::size_t next, std::vector<Step>& result) const {
    std::vector<State> states;
    if (step.to.threads[at(step.thread)].finishing) {
      stop(std::move(step.to), step.thread, states);
    } else {
      go_to(std::move(step.to), step.thread, next, states);
    }
    for (auto& state : states) {
      Step one = step;
      one.to = std::move(state);
      result.push_back(std::move(one));
    }
  }

  bool value(const State& state, int thread, std::size_t condition) const {
    const auto& latched = state.threads[at(thread)].latched;
    const auto found = latched.find(condition);
    return found != latched.end() ? found->second : state.values[condition];
  }
  bool holds(const State& state, int thread, const pan::Guard& guard) const {
    switch (guard.kind) {
      case pan::Guard::Kind::equals:
        return value(state, thread, guard.condition.index()) == guard.value;
      case pan::Guard::Kind::negation:
        return !holds(state, thread, guard.terms[0]);
      case pan::Guard::Kind::all_of:
        for (const auto& term : guard.terms) {
          if (!holds(state, thread, term)) return false;
        }
        return true;
      case pan::Guard::Kind::any_of:
        for (const auto& term : guard.terms) {
          if (holds(state, thread, term)) return true;
        }
        return false;
    }
    return false;
  }

  std::vector<Step> steps(const State& state, int thread) const {
    std::vector<Step> result;
    const auto& self = state.threads[at(thread)];
    if (self.gone) return result;
    const auto& n = node(state, thread);
    const auto fresh = [&] {
      Step step;
      step.to = state;
      step.thread = thread;
      return step;
    };
    if (const auto* wait = std::get_if<pan::Wait>(&n.content)) {
      bool took = false;
      for (std::size_t i = 0; i < wait->channels.size(); ++i) {
        const auto channel = wait->channels[i].index();
        if (!available(state, channel)) continue;
        auto step = fresh();
        step.talk = true;
        step.take = channel;
        take(step.to, channel);
        done(std::move(step), n.out[i].index(), result);
        took = true;
      }
      if (self.finishing) {
        if (!took) done(fresh(), 0, result);
      } else if (wait->within) {
        auto step = fresh();
        step.timely = step.talk = true;
        for (const auto channel : wait->channels) {
          if (const auto request = request_for(channel.index())) withdraw(step.to, *request);
        }
        done(std::move(step), n.out.back().index(), result);
      }
    } else if (const auto* send = std::get_if<pan::Send>(&n.content)) {
      const auto channel = send->channel.index();
      auto step = fresh();
      auto& slot = step.to.slots[channel];
      step.talk = true;
      step.put = channel;
      const bool to_device = is_device(network_.channels[channel].receiver);
      if (slot.discard > 0) {
        --slot.discard;
        step.put.reset();
      } else if (slot.full) {
        if (!self.finishing) return result;
        step.put.reset();
        step.talk = false;
      } else {
        slot.full = !to_device;
        if (answer_to(channel)) {
          slot.waiting_for.push_back(0);
          slot.last_asker = self.name;
        }
      }
      done(std::move(step), n.out.front().index(), result);
    } else if (std::holds_alternative<pan::Complete>(n.content)) {
      auto step = fresh();
      step.to = State{};
      step.to.ended = true;
      step.completes = true;
      result.push_back(std::move(step));
    } else if (const auto* set = std::get_if<pan::Set>(&n.content)) {
      for (const bool v : {false, true}) {
        if (set->value && *set->value != v) continue;
        auto step = fresh();
        step.to.values[set->condition.index()] = v;
        done(std::move(step), n.out.front().index(), result);
      }
    } else if (const auto* read = std::get_if<pan::Read>(&n.content)) {
      auto step = fresh();
      step.to.threads[at(thread)].latched[read->condition.index()] = state.values[read->condition.index()];
      done(std::move(step), n.out.front().index(), result);
    } else if (const auto* choose = std::get_if<pan::Choose>(&n.content)) {
      auto step = fresh();
      step.to.threads[at(thread)].latched.clear();
      for (std::size_t i = 0; i < choose->guards.size(); ++i) {
        if (!holds(state, thread, choose->guards[i])) continue;
        done(std::move(step), n.out[i].index(), result);
        return result;
      }
      step.to = State{};
      step.to.ended = true;
      result.push_back(std::move(step));
    } else if (const auto* until = std::get_if<pan::Until>(&n.content)) {
      auto step = fresh();
      step.to.threads[at(thread)].latched.clear();
      const bool out = holds(state, thread, *until->guard);
      done(std::move(step), out ? n.out.front().index() : n.mate.index(), result);
    } else if (!std::holds_alternative<pan::End>(n.content) &&
               !std::holds_alternative<pan::Join>(n.content)) {
      result.push_back(fresh());  // goes round for ever
    }
    return result;
  }

  /// Threads that are gone leave no trace, so that a loop over CONCURRENT comes back to where it was.
  static State packed(State state) {
    while (!state.threads.empty() && state.threads.back().gone) state.threads.pop_back();
    for (auto& thread : state.threads) {
      if (thread.gone) thread = Thread{{}, -2, 0, true, false, true, {}};
    }
    return state;
  }

  // ---- all of it

  struct Edge {
    std::size_t from, to;
    bool timely, talk;
    std::vector<bool> moved;  // by number of thread
  };

  State first() const {
    State state;
    state.slots.resize(network_.channels.size());
    state.values.resize(network_.conditions.size());
    std::vector<std::size_t> order;
    if (network_.main.valid()) order.push_back(network_.main.index());
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      const auto& module = network_.modules[m];
      if (!module.body.empty() && !module.executed_by.valid() && pan::ModuleId(m) != network_.main)
        order.push_back(m);
    }
    for (const auto m : order) {
      Thread thread;
      thread.at = {{m, 0}};
      thread.name = name(m, 0);
      state.threads.push_back(thread);
    }
    for (std::size_t t = 0; t < order.size(); ++t) {
      std::vector<State> begun;
      settle(state, static_cast<int>(t), begun);
      state = begun.front();
    }
    return packed(state);
  }

  std::size_t number(State state) {
    const auto [entry, is_new] = known_.emplace(packed(std::move(state)), states_.size());
    if (is_new) states_.push_back(&entry->first);
    return entry->second;
  }

  void explore() {
    number(first());
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (states_.size() > most_) {
        result_.complete = false;
        return;
      }
      if (states_[i]->ended) continue;
      for (std::size_t t = 0; t < states_[i]->threads.size(); ++t) {
        for (auto& step : steps(*states_[i], static_cast<int>(t))) {
          if (step.put) put_.insert(*step.put);
          if (step.take) taken_.insert(*step.take);
          if (step.completes) completions_.push_back(i);
          std::vector<bool> moved(states_[i]->threads.size());
          for (std::size_t u = 0; u < moved.size(); ++u) {
            moved[u] = u == t || step.to.ended || u >= step.to.threads.size() ||
                       step.to.threads[u] != states_[i]->threads[u];
          }
          const auto to = number(std::move(step.to));
          edges_.push_back({i, to, step.timely, step.talk, std::move(moved)});
        }
      }
    }
  }

  std::vector<Length> lengths() const {
    std::vector<std::vector<std::size_t>> out(states_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) out[edges_[e].from].push_back(e);
    std::vector<Length> result(states_.size(), {1 << 20, 0});
    using Entry = std::pair<Length, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    result[0] = {0, 0};
    open.push({{0, 0}, 0});
    while (!open.empty()) {
      const auto [length, i] = open.top();
      open.pop();
      if (length != result[i]) continue;
      for (const auto e : out[i]) {
        const Length next{length.first + edges_[e].timely, length.second + edges_[e].talk};
        if (next >= result[edges_[e].to]) continue;
        result[edges_[e].to] = next;
        open.push({next, edges_[e].to});
      }
    }
    return result;
  }

  void conclude() {
    std::size_t most_threads = 0;
    for (const auto* state : states_) most_threads = std::max(most_threads, state->threads.size());
    // By state: threads that move on some run from there. What is beyond the threads of a state begins later.
    std::vector<std::vector<bool>> moves(states_.size(), std::vector<bool>(most_threads));
    std::vector<bool> stands(states_.size(), true);
    std::vector<std::vector<std::size_t>> into(states_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) into[edges_[e].to].push_back(e);
    std::deque<std::size_t> open;
    for (const auto& edge : edges_) {
      stands[edge.from] = false;
      for (std::size_t t = 0; t < edge.moved.size(); ++t)
        moves[edge.from][t] = moves[edge.from][t] || edge.moved[t];
    }
    for (std::size_t i = 0; i < states_.size(); ++i) open.push_back(i);
    while (!open.empty()) {
      const auto i = open.front();
      open.pop_front();
      for (const auto e : into[i]) {
        bool changed = false;
        auto& from = moves[edges_[e].from];
        for (std::size_t t = 0; t < states_[edges_[e].from]->threads.size(); ++t) {
          if (from[t] || !moves[i][t]) continue;
          from[t] = true;
          changed = true;
        }
        if (changed) open.push_back(edges_[e].from);
      }
    }
    const auto length = lengths();
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (states_[i]->ended) continue;
      if (stands[i] && (!result_.total || length[i] < *result_.total)) result_.total = length[i];
      if (dead(*states_[i], moves[i], 0) && (!result_.dead || length[i] < *result_.dead))
        result_.dead = length[i];
    }
    for (const auto c : put_) {
      if (taken_.count(c) == 0 && !is_device(network_.channels[c].receiver)) result_.untaken.insert(c);
    }
    for (const auto i : completions_) {
      for (std::size_t c = 0; c < states_[i]->slots.size(); ++c) {
        const auto& channel = network_.channels[c];
        if (!states_[i]->slots[c].full || network_.messages[channel.message.index()].asks_for.valid())
          continue;
        if (channel.sender != pan::Party(network_.main) || is_device(channel.receiver)) continue;
        const auto known = result_.undelivered.find(c);
        if (known == result_.undelivered.end() || length[i] < known->second)
          result_.undelivered[c] = length[i];
      }
    }
  }

  bool dead(const State& state, const std::vector<bool>& moves, int thread) const {
    const auto& self = state.threads[at(thread)];
    if (self.gone) return false;
    const auto& content = node(state, thread).content;
    if (std::holds_alternative<pan::Wait>(content) || std::holds_alternative<pan::Send>(content))
      return !moves[at(thread)];
    if (!std::holds_alternative<pan::Join>(content)) return false;
    const auto blocks = blocks_of(state, thread);
    const auto& place = self.at.back();
    bool ends = false;
    for (const auto out : node({place.module, node(place).mate.index()}).out)
      ends = ends || block_can_end(place.module, out.index());
    bool some = false;
    bool all = true;
    for (const int b : blocks) {
      if (ends && !state.threads[at(b)].can_end) continue;
      const bool block = dead(state, moves, b);
      some = some || block;
      all = all && block;
    }
    return some && (ends || all);
  }

  const pan::Network& network_;
  std::size_t most_;
  std::map<State, std::size_t> known_;
  std::vector<const State*> states_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> completions_;
  std::set<std::size_t> put_, taken_;
  Result result_;
};

}  // namespace pal::test
