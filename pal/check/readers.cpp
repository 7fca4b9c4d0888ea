#include <algorithm>
#include <string>
#include <vector>

#include "pal/check/families.hpp"
#include "pal/check/report.hpp"
#include "pal/support/diagnostic_code.hpp"

namespace pal::frontend {

namespace {

/// Where one module comes to have a message: it takes one, or an activity writes it.
class Sources {
 public:
  Sources(const pan::Network& network, const Flow& flow, pan::ModuleId module, pan::MessageId message)
      : network_(network),
        flow_(flow),
        module_(module),
        message_(message),
        body_(network.modules[module.index()].body) {}

  bool any() const {
    for (std::size_t i = 0; i < body_.nodes.size(); ++i) {
      const auto& node = body_.nodes[i];
      for (const auto out : node.out) {
        if (gives(node, out)) return true;
      }
    }
    return false;
  }

  /// Nodes that some way from the start reaches without the message.
  std::vector<bool> reached_without() const {
    std::vector<bool> reached(body_.nodes.size(), false);
    std::vector<pan::NodeId> open{pan::NodeId(0)};
    reached[0] = true;
    while (!open.empty()) {
      const auto at = open.back();
      open.pop_back();
      for (const auto next : flow_.next(module_, at)) {
        if (!next.valid() || reached[next.index()] || gives(body_[at], next)) continue;
        reached[next.index()] = true;
        open.push_back(next);
      }
    }
    return reached;
  }

 private:
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
  const Flow& flow_;
  pan::ModuleId module_;
  pan::MessageId message_;
  const pan::Graph& body_;
};

void check_activity(const pan::Network& network, const Flow& flow, const pan::Activity& activity,
                    pan::ActivityId id, Diagnostics& diagnostics) {
  const auto& module = network.modules[activity.module.index()];
  for (const auto message : activity.reads) {
    const Sources sources(network, flow, activity.module, message);
    const auto& name = network.messages[message.index()].name;
    if (!sources.any()) {
      diagnostics.report(
          Code::PAL0509, activity.where,
          quoted(activity.name) + " reads " + quoted(name) + ", which " + quoted(module.name) + " never has",
          "take it by a WTM before, let an activity write it, or do not read it");
      continue;
    }
    const auto without = sources.reached_without();
    for (std::size_t i = 0; i < module.body.nodes.size(); ++i) {
      const auto* perform = std::get_if<pan::Perform>(&module.body.nodes[i].content);
      if (perform == nullptr || perform->activity != id || !without[i]) continue;
      auto& finding = diagnostics.report(
          Code::PAL0510, module.body.nodes[i].where,
          quoted(activity.name) + " may read " + quoted(name) + " before " + quoted(module.name) + " has one",
          "take one first on every way to here; until then all its fields are 0");
      finding.notes.push_back({activity.where, "it reads it by this"});
      break;
    }
  }
}

void check_condition(const pan::Network& network, const Flow& flow, const pan::Condition& condition,
                     Diagnostics& diagnostics) {
  if (!condition.writer.valid()) return;
  const auto& writer = network.modules[condition.writer.index()];
  for (const auto message : condition.from) {
    if (Sources(network, flow, condition.writer, message).any()) continue;
    auto& finding = diagnostics.report(
        Code::PAL0511, condition.where,
        quoted(condition.name) + " is computed from " + quoted(network.messages[message.index()].name) +
            ", which " + quoted(writer.name) + " never has",
        "let " + writer.name + " take it before it sets the condition, or remove it from FROM");
    finding.notes.push_back({writer.where, "this module sets it"});
  }
}

}  // namespace

void check_readers(const pan::Network& network, const Flow& flow, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < network.activities.size(); ++i) {
    check_activity(network, flow, network.activities[i], pan::ActivityId(i), diagnostics);
  }
  for (const auto& condition : network.conditions) check_condition(network, flow, condition, diagnostics);
}

}  // namespace pal::frontend
