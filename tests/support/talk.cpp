// How threads get to their statements: blocks that begin, end and are cancelled.
#include "tests/support/talk.hpp"

#include <algorithm>
#include <deque>
#include <set>

namespace pal::test::talk {

bool Talk::is_device(const pan::Party& party) const {
  const auto* module = std::get_if<pan::ModuleId>(&party);
  return module == nullptr || network_.modules[module->index()].body.empty();
}

std::optional<std::size_t> Talk::answer_to(std::size_t request) const {
  const auto& answer = network_.channels[request].answer;
  return answer.valid() ? std::optional(answer.index()) : std::nullopt;
}

std::optional<std::size_t> Talk::request_for(std::size_t answer) const {
  for (std::size_t c = 0; c < network_.channels.size(); ++c) {
    if (answer_to(c) == answer) return c;
  }
  return std::nullopt;
}

// ---- can a block end? By search over its nodes, all guards free.
bool Talk::block_can_end(std::size_t module, std::size_t first) const {
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

void Talk::go_to(State state, int thread, std::size_t target, std::vector<State>& result) const {
  state.threads[at(thread)].at.back().node = target;
  settle(std::move(state), thread, result);
}

/// Passes what takes no step of its own.
void Talk::settle(State state, int thread, std::vector<State>& result) const {
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
      // What it has open is its parent's.
      for (Slot& slot : state.slots) {
        for (Asked& each : slot.asked) {
          if (each.owner == here.name) each.owner = state.threads[at(parent)].name;
        }
      }
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
                        std::holds_alternative<pan::Nothing>(n.content) ||
                        std::holds_alternative<pan::Merge>(n.content) ||
                        std::holds_alternative<pan::Loop>(n.content);
    if (!silent) break;
    here.at.back().node = n.out.front().index();
  }
  result.push_back(std::move(state));
}

void Talk::fork(State state, int parent, std::vector<State>& result) const {
  const auto place = state.threads[at(parent)].at.back();
  const auto& n = node(place);
  std::vector<int> blocks;
  for (std::size_t i = 0; i < n.out.size(); ++i) {
    Thread block;
    block.at = {{place.module, n.out[i].index()}};
    block.parent = parent;
    block.name = state.threads[at(parent)].name + " " + name(place.module, n.out[i].index());
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

std::vector<int> Talk::blocks_of(const State& state, int parent) const {
  std::vector<int> result;
  for (std::size_t t = 0; t < state.threads.size(); ++t) {
    if (state.threads[t].parent == parent && !state.threads[t].gone) result.push_back(static_cast<int>(t));
  }
  return result;
}

void Talk::block_gone(State state, int parent, std::vector<State>& result) const {
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
void Talk::cancel(State state, int parent, std::vector<State>& result) const {
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

bool Talk::may_be_working(const State& state, int thread) const {
  const auto& n = node(state, thread);
  if (const auto* wait = std::get_if<pan::Wait>(&n.content)) {
    return std::any_of(wait->channels.begin(), wait->channels.end(),
                       [&](pan::ChannelId c) { return available(state, c.index()); });
  }
  return std::holds_alternative<pan::Send>(n.content) || std::holds_alternative<pan::Set>(n.content);
}

void Talk::stop(State state, int thread, std::vector<State>& result) const {
  auto& self = state.threads[at(thread)];
  self.gone = true;
  self.finishing = false;
  self.latched.clear();
  for (std::size_t c = 0; c < state.slots.size(); ++c) {
    withdraw(state, c, self.name);
  }
  block_gone(std::move(state), state.threads[at(thread)].parent, result);
}

/// Threads that are gone leave no trace, so that a loop over CONCURRENT comes back to where it was.
State Talk::packed(State state) {
  while (!state.threads.empty() && state.threads.back().gone) state.threads.pop_back();
  for (auto& thread : state.threads) {
    if (thread.gone) thread = Thread{{}, -2, "", true, false, true, {}};
  }
  return state;
}

State Talk::first() const {
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

}  // namespace pal::test::talk
