#include "tests/support/talk_oracle.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <queue>

namespace pal::test {

TalkOracle::Result TalkOracle::run() {
  explore();
  if (result_.complete) conclude();
  return result_;
}

std::size_t TalkOracle::number(State state) {
  const auto [entry, is_new] = known_.emplace(talk_.packed(std::move(state)), states_.size());
  if (is_new) states_.push_back(&entry->first);
  return entry->second;
}

void TalkOracle::explore() {
  number(talk_.first());
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_.size() > most_) {
      result_.complete = false;
      return;
    }
    if (states_[i]->ended) continue;
    for (std::size_t t = 0; t < states_[i]->threads.size(); ++t) {
      for (auto& step : talk_.steps(*states_[i], static_cast<int>(t))) {
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

std::vector<TalkOracle::Length> TalkOracle::lengths() const {
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

void TalkOracle::conclude() {
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
    if (taken_.count(c) == 0 && !talk_.is_device(network_.channels[c].receiver)) result_.untaken.insert(c);
  }
  for (const auto i : completions_) {
    for (std::size_t c = 0; c < states_[i]->slots.size(); ++c) {
      const auto& channel = network_.channels[c];
      if (!states_[i]->slots[c].full || network_.messages[channel.message.index()].asks_for.valid()) continue;
      if (channel.sender != pan::Party(network_.main) || talk_.is_device(channel.receiver)) continue;
      const auto known = result_.undelivered.find(c);
      if (known == result_.undelivered.end() || length[i] < known->second) result_.undelivered[c] = length[i];
    }
  }
}

bool TalkOracle::dead(const State& state, const std::vector<bool>& moves, int thread) const {
  const auto& self = state.threads[talk::Talk::at(thread)];
  if (self.gone) return false;
  const auto& content = talk_.node(state, thread).content;
  if (std::holds_alternative<pan::Wait>(content) || std::holds_alternative<pan::Send>(content))
    return !moves[talk::Talk::at(thread)];
  if (!std::holds_alternative<pan::Join>(content)) return false;
  const auto blocks = talk_.blocks_of(state, thread);
  const auto& place = self.at.back();
  bool ends = false;
  for (const auto out : talk_.node({place.module, talk_.node(place).mate.index()}).out)
    ends = ends || talk_.block_can_end(place.module, out.index());
  bool some = false;
  bool all = true;
  for (const int b : blocks) {
    if (ends && !state.threads[talk::Talk::at(b)].can_end) continue;
    const bool block = dead(state, moves, b);
    some = some || block;
    all = all && block;
  }
  return some && (ends || all);
}

}  // namespace pal::test
