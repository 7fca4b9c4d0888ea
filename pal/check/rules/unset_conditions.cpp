// Conditions that are read before anything has set them.
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "pal/check/conditions/guards.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

/// A condition that is read, before which `set` may or must have been.
struct SetBefore {
  bool reached = false;
  bool may = false;   // on some way here it was set
  bool must = false;  // on every way here it was set

  bool join(const SetBefore& other) {
    if (!other.reached) return false;
    const SetBefore old = *this;
    must = reached ? must && other.must : other.must;
    may = may || other.may;
    reached = true;
    return old.reached != reached || old.may != may || old.must != must;
  }
};

std::vector<pan::ConditionId> read_at(const pan::Content& content) {
  std::vector<pan::ConditionId> result;
  if (const auto* read = std::get_if<pan::Read>(&content)) result.push_back(read->condition);
  if (const auto* choose = std::get_if<pan::Choose>(&content)) {
    for (const auto& guard : choose->guards) conditions::conditions_of(guard, result);
  }
  if (const auto* until = std::get_if<pan::Until>(&content)) {
    if (until->guard) conditions::conditions_of(*until->guard, result);
  }
  return result;
}

/// Follows one condition through the modules that run as one: a module and those that it executes. Calls are
/// followed without distinguishing where they come from, which can only lead to fewer findings.
class Follower {
 public:
  Follower(const pan::Network& network, const pan::Flow& flow, pan::ConditionId condition)
      : network_(network), flow_(flow), condition_(condition) {
    for (const auto& module : network.modules) states_.emplace_back(module.body.nodes.size());
  }

  void run(pan::ModuleId root) {
    enter(root, pan::NodeId(0), {true, false, false});
    while (!open_.empty()) {
      const auto [module, node] = open_.back();
      open_.pop_back();
      step(module, node);
    }
  }

  const SetBefore& before(pan::ModuleId module, pan::NodeId node) const {
    return states_[module.index()][node.index()];
  }

 private:
  void enter(pan::ModuleId module, pan::NodeId node, const SetBefore& state) {
    if (!node.valid()) return;
    if (states_[module.index()][node.index()].join(state)) open_.emplace_back(module, node);
  }

  bool sets_between(pan::ModuleId module, std::size_t begin, std::size_t end) const {
    const auto& nodes = network_.modules[module.index()].body.nodes;
    for (auto i = begin; i < end; ++i) {
      const auto* set = std::get_if<pan::Set>(&nodes[i].content);
      if (set != nullptr && set->condition == condition_) return true;
      // What an executed module sets counts as set by the block: it may be.
      if (std::holds_alternative<pan::Execute>(nodes[i].content)) return true;
    }
    return false;
  }

  void step(pan::ModuleId module, pan::NodeId id) {
    const auto& node = network_.modules[module.index()].body[id];
    auto state = states_[module.index()][id.index()];
    if (const auto* set = std::get_if<pan::Set>(&node.content);
        set != nullptr && set->condition == condition_) {
      state.may = state.must = true;
    }
    if (const auto* execute = std::get_if<pan::Execute>(&node.content)) {
      const auto& callee = network_.modules[execute->module.index()].body;
      if (!callee.empty()) {
        callers_[execute->module].emplace(module, id);
        enter(execute->module, pan::NodeId(0), state);
        leave(execute->module, pan::NodeId(callee.nodes.size() - 1));
        return;
      }
    }
    if (std::holds_alternative<pan::Fork>(node.content)) {
      fork(module, id, state);
      return;
    }
    if (std::holds_alternative<pan::End>(node.content)) {
      leave(module, id);
      return;
    }
    for (const auto to : flow_.next(module, id)) enter(module, to, state);
  }

  void leave(pan::ModuleId module, pan::NodeId end) {
    const auto& state = states_[module.index()][end.index()];
    if (!state.reached) return;
    if (end.index() + 1 == network_.modules[module.index()].body.nodes.size()) {
      for (const auto& [caller, execute] : callers_[module]) {
        for (const auto to : flow_.next(caller, execute)) enter(caller, to, state);
      }
      return;
    }
    if (const auto fork_node = block_ends_.find(std::pair(module, end)); fork_node != block_ends_.end()) {
      join(module, fork_node->second);
    }
  }

  static std::size_t block_end(const pan::Node& fork, std::size_t block) {
    return (block + 1 < fork.out.size() ? fork.out[block + 1].index() : fork.mate.index()) - 1;
  }

  void fork(pan::ModuleId module, pan::NodeId id, const SetBefore& state) {
    const auto& node = network_.modules[module.index()].body[id];
    forks_[std::pair(module, id)] = state;
    for (std::size_t block = 0; block < node.out.size(); ++block) {
      block_ends_[std::pair(module, pan::NodeId(block_end(node, block)))] = id;
      auto inside = state;
      // The other blocks may have gone any way meanwhile.
      for (std::size_t other = 0; other < node.out.size(); ++other) {
        if (other == block) continue;
        inside.may = inside.may || sets_between(module, node.out[other].index(), block_end(node, other));
      }
      enter(module, node.out[block], inside);
    }
    join(module, id);
  }

  void join(pan::ModuleId module, pan::NodeId id) {
    const auto& node = network_.modules[module.index()].body[id];
    if (!flow_.fork_can_end(module, id)) return;
    auto after = forks_[std::pair(module, id)];
    for (std::size_t block = 0; block < node.out.size(); ++block) {
      const auto end = block_end(node, block);
      after.may = after.may || sets_between(module, node.out[block].index(), end);
      if (!flow_.block_can_end(module, node.out[block])) continue;
      const auto& ended = states_[module.index()][end];
      if (!ended.reached) return;
      after.must = after.must || ended.must;
    }
    enter(module, node.mate, after);
  }

  const pan::Network& network_;
  const pan::Flow& flow_;
  pan::ConditionId condition_;
  std::vector<std::vector<SetBefore>> states_;
  std::vector<std::pair<pan::ModuleId, pan::NodeId>> open_;
  std::map<pan::ModuleId, std::set<std::pair<pan::ModuleId, pan::NodeId>>> callers_;
  std::map<std::pair<pan::ModuleId, pan::NodeId>, pan::NodeId> block_ends_;  // to the CONCURRENT of the block
  std::map<std::pair<pan::ModuleId, pan::NodeId>, SetBefore> forks_;
};

/// The places in one module that read a condition before it is set.
class ReadCheck {
 public:
  ReadCheck(const pan::Network& network, pan::ConditionId condition, Diagnostics& diagnostics)
      : network_(network), condition_(condition), diagnostics_(diagnostics) {}

  void check(pan::ModuleId module, const Follower* follower) {
    std::vector<SourceSpan> never;
    std::vector<SourceSpan> sometimes;
    const auto& nodes = network_.modules[module.index()].body.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!reads(nodes[i].content)) continue;
      const SetBefore state =
          follower != nullptr ? follower->before(module, pan::NodeId(i)) : SetBefore{true, false, false};
      if (!state.reached || state.must) continue;
      (state.may ? sometimes : never).push_back(nodes[i].where);
    }
    report(Finding::nothing_can_have_set, never);
    report(Finding::may_be_read_before_set, sometimes);
  }

 private:
  bool reads(const pan::Content& content) const {
    for (const auto id : read_at(content)) {
      if (id == condition_) return true;
    }
    return false;
  }

  // One finding for each module and condition: its other places are notes.
  void report(FindingWith<1> what, const std::vector<SourceSpan>& places) {
    if (places.empty()) return;
    const auto& name = network_.conditions[condition_.index()].name;
    auto& finding = diagnostics_.report(what, places.front(), name);
    for (std::size_t i = 1; i < places.size(); ++i) finding.note(places[i], Remark::and_here);
  }

  const pan::Network& network_;
  pan::ConditionId condition_;
  Diagnostics& diagnostics_;
};

/// The module in whose thread a module runs.
pan::ModuleId root_of(const pan::Network& network, pan::ModuleId module) {
  while (network.modules[module.index()].executed_by.valid())
    module = network.modules[module.index()].executed_by;
  return module;
}

}  // namespace

void check_reads(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics) {
  std::set<pan::ConditionId> read;
  for (const auto& module : network.modules) {
    for (const auto& node : module.body.nodes) {
      const auto here = read_at(node.content);
      read.insert(here.begin(), here.end());
    }
  }
  for (const auto condition : read) {
    const auto writer = network.conditions[condition.index()].writer;
    std::optional<Follower> follower;
    if (writer.valid()) {
      follower.emplace(network, flow, condition);
      follower->run(root_of(network, writer));
    }
    for (std::size_t m = 0; m < network.modules.size(); ++m) {
      const pan::ModuleId module(m);
      if (network.modules[m].body.empty()) continue;
      // Of a thread that runs beside the writer's nothing is known: it may always read later.
      const bool beside = writer.valid() && root_of(network, module) != root_of(network, writer);
      if (beside) continue;
      ReadCheck(network, condition, diagnostics).check(module, follower ? &*follower : nullptr);
    }
  }
}

}  // namespace pal::check
