// Where the flow of a module leads, read off its graph.
#include "tests/support/runs/all_runs.hpp"

#include <algorithm>

namespace pal::test {

using namespace pan;
using namespace runs;

const Node& AllRuns::node(const Thread& thread) const {
  const auto [module, at] = thread.at.back();
  return network_.modules[ix(module)].body.nodes[ix(at)];
}

/// What a flow from a node comes to before it leaves its body, or its block.
AllRuns::Ahead AllRuns::ahead(int module, int from) const {
  const auto known = ahead_.find({module, from});
  if (known != ahead_.end()) return known->second;
  ahead_[{module, from}] = {};  // a module that executes itself never comes back
  const Graph& body = network_.modules[ix(module)].body;
  Ahead result;
  std::set<int> seen;
  std::vector<int> todo{from};
  while (!todo.empty()) {
    const int at = todo.back();
    todo.pop_back();
    if (!seen.insert(at).second) continue;
    const Node& here = body.nodes[ix(at)];
    result.meets = result.meets || wanted_.at.count({module, at}) != 0;
    bool passes = true;
    if (std::holds_alternative<End>(here.content)) {
      result.ends = true;
      continue;
    }
    if (std::holds_alternative<Complete>(here.content)) continue;
    if (const auto* execute = std::get_if<Execute>(&here.content)) {
      const Ahead within = ahead(execute->module.value, 0);
      result.meets = result.meets || within.meets;
      passes = within.ends;
    } else if (const auto* until = std::get_if<Until>(&here.content)) {
      todo.push_back(here.mate.value);
      passes = until->guard.has_value();
    } else if (std::holds_alternative<Fork>(here.content)) {
      for (NodeId block : here.out) {
        const Ahead within = ahead(module, block.value);
        result.meets = result.meets || within.meets;
        if (within.ends) todo.push_back(here.mate.value);
      }
      continue;
    }
    for (NodeId out : here.out) {
      if (passes) todo.push_back(out.value);
    }
  }
  ahead_[{module, from}] = result;
  return result;
}

/// Whether the flow of the thread itself leads to a statement at which something is measured.
bool AllRuns::leads(const Thread& thread) const {
  if (thread.status == Status::off || thread.at.empty()) return false;
  if (thread.cancelled) return thread.begun && wanted_.at.count(thread.at.back()) != 0;
  auto [module, from] = thread.at.back();
  if (thread.status == Status::joining) {
    const bool ends = std::any_of(thread.blocks.begin(), thread.blocks.end(),
                                  [this](int block) { return s_.threads[ix(block)].can_end; });
    if (!ends) return false;
    from = node(thread).mate.value;
  }
  for (std::size_t level = thread.at.size();;) {
    const Ahead here = ahead(module, from);
    if (here.meets) return true;
    if (!here.ends || --level == 0) return false;
    module = thread.at[level - 1].first;
    from = network_.modules[ix(module)].body.nodes[ix(thread.at[level - 1].second)].out.front().value;
  }
}

void AllRuns::leave_node(int thread, std::size_t out) {
  Thread& of = s_.threads[ix(thread)];
  const auto* until = std::get_if<Until>(&node(of).content);
  if (until != nullptr && out == 1) {
    of.at.back().second = node(of).mate.value;
    return;
  }
  of.at.back().second = node(of).out[out].value;
}

void AllRuns::walk_on(int thread) {
  for (int passed = 0;; ++passed) {
    if (passed > 10'000) throw TooMuch("nothing happens in a loop");
    Thread& of = s_.threads[ix(thread)];
    const Node& here = node(of);
    if (std::holds_alternative<End>(here.content)) {
      if (of.at.size() == 1 || of.at[of.at.size() - 2].second < 0) {
        finished(thread);
        return;
      }
      of.at.pop_back();
      of.at.back().second = node(of).out.front().value;
      continue;
    }
    if (const auto* execute = std::get_if<Execute>(&here.content)) {
      of.at.push_back({execute->module.value, 0});
      continue;
    }
    const auto* until = std::get_if<Until>(&here.content);
    if (until != nullptr && !until->guard) {
      of.at.back().second = here.mate.value;
      continue;
    }
    const bool nothing =
        std::holds_alternative<Start>(here.content) || std::holds_alternative<WaitForStart>(here.content) ||
        std::holds_alternative<Nothing>(here.content) || std::holds_alternative<Merge>(here.content) ||
        std::holds_alternative<Loop>(here.content) || std::holds_alternative<Join>(here.content);
    if (!nothing) break;
    of.at.back().second = here.out.front().value;
  }
  reach(thread);
}

}  // namespace pal::test
