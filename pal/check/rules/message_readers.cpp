// Activities and conditions that read a message which never comes, or has not come yet.
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "pal/check/rules/families.hpp"
#include "pal/check/rules/steady_conditions.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

/// The nodes of all modules, by module and node.
using Marks = std::vector<std::vector<bool>>;

/// Where a thread comes to have a message: a module of it takes one, or an activity of one writes it. A
/// module and those that it executes keep their messages together.
class Sources {
 public:
  Sources(const pan::Network& network, const pan::Flow& flow, pan::ModuleId module, pan::MessageId message)
      : network_(network), flow_(flow), outermost_(outermost(module)), message_(message) {}

  bool any() const {
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      if (outermost(pan::ModuleId(m)) == outermost_ && gives_any(network_.modules[m].body)) return true;
    }
    return false;
  }

  /// Nodes that some way from the thread's start reaches without the message. Behind an Execute these are the
  /// ways through the module, whichever thread executed it. A way agrees with itself in the values of
  /// conditions that only it sets.
  Marks reached_without() {
    if (!follow(SteadyConditions(network_, outermost_))) follow(SteadyConditions(network_));
    Marks marks;
    for (const auto& nodes : reached_) {
      auto& of = marks.emplace_back();
      for (const auto& values : nodes) of.push_back(!values.empty());
    }
    return marks;
  }

 private:
  using Values = SteadyConditions::Values;
  struct Place {
    pan::ModuleId module;
    pan::NodeId node;
    Values values;
  };

  /// False: there are too many ways.
  bool follow(SteadyConditions conditions) {
    constexpr std::size_t most_places = 50'000;
    conditions_ = std::move(conditions);
    reached_.clear();
    open_.clear();
    ended_.assign(network_.modules.size(), {});
    for (const auto& module : network_.modules) reached_.emplace_back(module.body.nodes.size());
    reach(outermost_, pan::NodeId(0), 0);
    for (std::size_t looked = 0; !open_.empty(); ++looked) {
      if (looked > most_places && !conditions_.none()) return false;
      const Place place = open_.back();
      open_.pop_back();
      go_on(place);
    }
    return true;
  }

  pan::ModuleId outermost(pan::ModuleId module) const {
    while (network_.modules[module.index()].executed_by.valid())
      module = network_.modules[module.index()].executed_by;
    return module;
  }

  void reach(pan::ModuleId module, pan::NodeId node, Values values) {
    auto& reached = reached_[module.index()];
    if (!node.valid() || reached.empty() || !reached[node.index()].insert(values).second) return;
    open_.push_back({module, node, values});
  }

  void go_on(const Place& place) {
    const auto& [module, at, values] = place;
    const auto& body = network_.modules[module.index()].body;
    if (const auto* execute = std::get_if<pan::Execute>(&body[at].content)) {
      reach(execute->module, pan::NodeId(0), values);
      if (reached_[execute->module.index()].empty()) leave(module, at, values);
      const auto ended = ended_[execute->module.index()];
      for (const Values after : ended) leave(module, at, after);
      return;
    }
    if (at.index() + 1 == body.nodes.size()) return_to_callers(module, values);
    for (const auto next : flow_.next(module, at)) {
      if (!next.valid() || gives(body[at], next)) continue;
      for (const Values after : conditions_.after(body[at], next, values)) reach(module, next, after);
    }
  }

  void leave(pan::ModuleId module, pan::NodeId execute, Values values) {
    for (const auto next : flow_.next(module, execute)) reach(module, next, values);
  }

  void return_to_callers(pan::ModuleId module, Values values) {
    if (!ended_[module.index()].insert(values).second) return;
    const auto caller = network_.modules[module.index()].executed_by;
    if (!caller.valid()) return;
    const auto& nodes = network_.modules[caller.index()].body.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto* execute = std::get_if<pan::Execute>(&nodes[i].content);
      if (execute == nullptr || execute->module != module || reached_[caller.index()][i].empty()) continue;
      leave(caller, pan::NodeId(i), values);
    }
  }

  bool gives_any(const pan::Graph& body) const {
    return std::any_of(body.nodes.begin(), body.nodes.end(), [&](const pan::Node& node) {
      return std::any_of(node.out.begin(), node.out.end(),
                         [&](pan::NodeId next) { return gives(node, next); });
    });
  }

  /// On the way from the node to the one after it.
  bool gives(const pan::Node& node, pan::NodeId next) const {
    if (const auto* perform = std::get_if<pan::Perform>(&node.content)) {
      const auto& writes = network_.activities[perform->activity.index()].writes;
      return std::find(writes.begin(), writes.end(), message_) != writes.end();
    }
    const auto* wait = std::get_if<pan::Wait>(&node.content);
    if (wait == nullptr) return false;
    for (std::size_t i = 0; i < wait->channels.size() && i < node.out.size(); ++i) {
      if (node.out[i] == next && network_.channels[wait->channels[i].index()].message == message_)
        return true;
    }
    return false;
  }

  const pan::Network& network_;
  const pan::Flow& flow_;
  pan::ModuleId outermost_;
  pan::MessageId message_;
  SteadyConditions conditions_{network_};
  std::vector<std::vector<std::set<Values>>> reached_;  // by module and node
  std::vector<std::set<Values>> ended_;                 // by module: as some way comes to its end
  std::vector<Place> open_;
};

/// Whether a module in a file that is not given may execute this one: then it is not known what that one has.
bool may_have_a_caller_elsewhere(const pan::Network& network, const pan::Module& module) {
  const bool sketch = network.skill.completions.empty();  // every skill has one
  return sketch && !module.executed_by.valid() &&
         (module.kind == pan::ModuleKind::skill_module || module.kind == pan::ModuleKind::contingency_module);
}

void check_activity(const pan::Network& network, const pan::Flow& flow, const pan::Activity& activity,
                    pan::ActivityId id, Diagnostics& diagnostics) {
  const auto& module = network.modules[activity.module.index()];
  if (may_have_a_caller_elsewhere(network, module)) return;
  for (const auto message : activity.reads) {
    Sources sources(network, flow, activity.module, message);
    const auto& name = network.messages[message.index()].name;
    if (!sources.any()) {
      diagnostics.report(Finding::reads_what_never_comes, activity.where, activity.name, name, module.name);
      continue;
    }
    const auto without = sources.reached_without()[activity.module.index()];
    for (std::size_t i = 0; i < module.body.nodes.size(); ++i) {
      const auto* perform = std::get_if<pan::Perform>(&module.body.nodes[i].content);
      if (perform == nullptr || perform->activity != id || !without[i]) continue;
      auto& finding = diagnostics.report(Finding::may_read_too_early, module.body.nodes[i].where,
                                         activity.name, name, module.name);
      finding.note(activity.where, Remark::reads_by_this);
      break;
    }
  }
}

void check_condition(const pan::Network& network, const pan::Flow& flow, const pan::Condition& condition,
                     Diagnostics& diagnostics) {
  if (!condition.writer.valid()) return;
  const auto& writer = network.modules[condition.writer.index()];
  if (may_have_a_caller_elsewhere(network, writer)) return;
  for (const auto message : condition.from) {
    if (Sources(network, flow, condition.writer, message).any()) continue;
    auto& finding = diagnostics.report(Finding::computed_from_what_never_comes, condition.where,
                                       condition.name, network.messages[message.index()].name, writer.name);
    finding.note(writer.where, Remark::module_sets_it);
  }
}

}  // namespace

void check_readers(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < network.activities.size(); ++i) {
    check_activity(network, flow, network.activities[i], pan::ActivityId(i), diagnostics);
  }
  for (const auto& condition : network.conditions) check_condition(network, flow, condition, diagnostics);
}

}  // namespace pal::check
