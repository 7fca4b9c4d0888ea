#include "pal/check/to_unit.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace pal::check {

namespace {

syntax::Name named(const std::string& text) {
  return {text, {}};
}

class UnitBuilder {
 public:
  UnitBuilder(const pan::Network& network, const pan::Module& module)
      : network_(network), nodes_(module.body.nodes) {}

  /// The statements that stand at [begin, end) in the order of the text.
  syntax::Statements statements(std::size_t begin, std::size_t end) {
    syntax::Statements result;
    at_ = begin;
    while (at_ < end) {
      const pan::Node& node = nodes_[at_++];
      std::visit([&](const auto& content) { add(content, node, result); }, node.content);
    }
    return result;
  }

 private:
  template <class Content>
  static void append(Content content, syntax::Statements& to) {
    to.push_back({std::move(content), {}, {}});
  }

  syntax::MessageName message(pan::MessageId id) const {
    const pan::Message& it = network_.messages[id.index()];
    if (!it.asks_for.valid()) return {false, named(it.name), {}};
    return {true, named(network_.messages[it.asks_for.index()].name), {}};
  }

  syntax::PartyName party(const pan::Party& it) const {
    const auto* module = std::get_if<pan::ModuleId>(&it);
    const std::string& name = module != nullptr ? network_.modules[module->index()].name
                                                : network_.devices[std::get<pan::DeviceId>(it).index()].name;
    return {std::nullopt, named(name), {}};
  }

  syntax::Name condition(pan::ConditionId id) const { return named(network_.conditions[id.index()].name); }

  syntax::Source source(pan::ChannelId id) const {
    const pan::Channel& channel = network_.channels[id.index()];
    return {message(channel.message), party(channel.sender)};
  }

  syntax::Guard guard(const pan::Guard& it) const {
    syntax::Guard result;
    result.kind = static_cast<syntax::Guard::Kind>(it.kind);
    result.value = it.value;
    if (it.kind == pan::Guard::Kind::equals) result.condition = condition(it.condition);
    for (const pan::Guard& term : it.terms) result.terms.push_back(guard(term));
    return result;
  }

  /// What stands in each way out of `split`, whose ways come together at its mate; goes on behind the mate.
  std::vector<syntax::Statements> ways(const pan::Node& split) {
    std::vector<syntax::Statements> result;
    for (std::size_t i = 0; i < split.out.size(); ++i) {
      // Nodes are in the order of the text: a way ends where the next that holds anything begins. An empty
      // way of a CASE leads to the mate itself.
      std::size_t end = split.mate.index();
      if (split.out[i] != split.mate) {
        for (std::size_t k = i + 1; k < split.out.size() && end == split.mate.index(); ++k)
          end = split.out[k].index();
      }
      result.push_back(statements(split.out[i].index(), end));
    }
    at_ = split.mate.index() + 1;
    return result;
  }

  void add(const pan::Start&, const pan::Node&, syntax::Statements&) {}
  void add(const pan::End&, const pan::Node&, syntax::Statements&) {}
  void add(const pan::Merge&, const pan::Node&, syntax::Statements&) {}
  void add(const pan::Until&, const pan::Node&, syntax::Statements&) {}
  void add(const pan::Join&, const pan::Node&, syntax::Statements&) {}
  void add(const pan::WaitForStart&, const pan::Node&, syntax::Statements& to) {
    append(syntax::WaitForStart{}, to);
  }
  void add(const pan::Wait& wait, const pan::Node& node, syntax::Statements& to) {
    if (!node.mate.valid()) {
      append(syntax::Wait{source(wait.channels.front())}, to);
      return;
    }
    syntax::WaitBranches result;
    result.first = wait.channels.size() != 1;
    result.within = wait.within;
    auto bodies = ways(node);
    for (std::size_t i = 0; i < wait.channels.size(); ++i)
      result.arms.push_back({source(wait.channels[i]), std::move(bodies[i]), {}});
    if (wait.within) result.otherwise = std::move(bodies.back());
    append(std::move(result), to);
  }
  void add(const pan::Send& send, const pan::Node&, syntax::Statements& to) {
    const pan::Channel& channel = network_.channels[send.channel.index()];
    append(syntax::Send{message(channel.message), party(channel.receiver)}, to);
  }
  void add(const pan::Complete& complete, const pan::Node&, syntax::Statements& to) {
    append(syntax::Complete{complete.code, {}}, to);
  }
  void add(const pan::Set& set, const pan::Node&, syntax::Statements& to) {
    append(syntax::Set{condition(set.condition), set.value}, to);
  }
  void add(const pan::Read& read, const pan::Node&, syntax::Statements& to) {
    append(syntax::Read{condition(read.condition)}, to);
  }
  void add(const pan::Perform& perform, const pan::Node&, syntax::Statements& to) {
    append(syntax::Perform{named(network_.activities[perform.activity.index()].name)}, to);
  }
  void add(const pan::Execute& execute, const pan::Node&, syntax::Statements& to) {
    append(syntax::Execute{party(execute.module)}, to);
  }
  void add(const pan::Nothing&, const pan::Node&, syntax::Statements& to) { append(syntax::Nothing{}, to); }
  void add(const pan::Choose& choose, const pan::Node& node, syntax::Statements& to) {
    syntax::Choose result;
    auto bodies = ways(node);
    for (std::size_t i = 0; i < choose.guards.size(); ++i)
      result.arms.push_back({guard(choose.guards[i]), std::move(bodies[i]), {}});
    append(std::move(result), to);
  }
  void add(const pan::Loop&, const pan::Node& node, syntax::Statements& to) {
    syntax::Repeat result;
    const std::size_t until = node.mate.index();
    result.body = statements(at_, until);
    const auto& end = std::get<pan::Until>(nodes_[until].content);
    if (end.guard) result.until = guard(*end.guard);
    at_ = until + 1;
    append(std::move(result), to);
  }
  void add(const pan::Fork&, const pan::Node& node, syntax::Statements& to) {
    syntax::Concurrent result;
    for (auto& body : ways(node)) result.blocks.push_back({std::move(body), {}});
    append(std::move(result), to);
  }

  const pan::Network& network_;
  const std::vector<pan::Node>& nodes_;
  std::size_t at_ = 0;
};

std::vector<syntax::Name> names(const pan::Network& network, const std::vector<pan::MessageId>& ids) {
  std::vector<syntax::Name> result;
  for (const pan::MessageId id : ids) result.push_back(named(network.messages[id.index()].name));
  return result;
}

std::optional<syntax::NameSlot> slot(const std::optional<std::vector<std::string>>& listed) {
  if (!listed) return std::nullopt;
  syntax::NameSlot result;
  for (const auto& name : *listed) result.names.push_back(named(name));
  return result;
}

}  // namespace

syntax::ModuleUnit to_unit(const pan::Network& network, pan::ModuleId module) {
  const pan::Module& it = network.modules[module.index()];
  syntax::ModuleUnit unit;
  unit.kind = it.kind;
  unit.name = named(it.name);
  for (const pan::Activity& activity : network.activities) {
    if (activity.module != module) continue;
    unit.activities.push_back({named(activity.name),
                               names(network, activity.reads),
                               names(network, activity.writes),
                               {},
                               activity.time});
  }
  unit.descriptions = it.descriptions;
  unit.sensor = {slot(it.drivers), it.methods, slot(it.returns), {}};
  unit.has_body = !it.body.empty();
  if (unit.has_body) unit.body = UnitBuilder(network, it).statements(0, it.body.nodes.size());
  return unit;
}

}  // namespace pal::check
