#include "tests/unit/pan/touch_network.hpp"

#include <utility>

namespace pal::pan {

namespace {

/// Appends statements one after the other; branches end at a merge.
class Body {
 public:
  explicit Body(Graph& graph) : graph_(graph) {}

  NodeId add(Content content) {
    const NodeId id(graph_.nodes.size());
    graph_.nodes.push_back({std::move(content), {}, {}, {}});
    for (const NodeId from : open_) graph_.nodes[from.index()].out.push_back(id);
    open_ = {id};
    return id;
  }

  void branch(NodeId split) { open_ = {split}; }
  void leave() {
    ends_.insert(ends_.end(), open_.begin(), open_.end());
    open_.clear();
  }
  void merge(NodeId split) {
    open_ = std::exchange(ends_, {});
    mates(split, add(Merge{}));
  }
  void until(NodeId loop, std::optional<Guard> guard) {
    const bool forever = !guard;
    const NodeId end = add(Until{std::move(guard)});
    mates(loop, end);
    if (forever) open_.clear();
  }
  void end_block() {
    add(End{});
    open_.clear();
  }
  void join(NodeId fork) {
    open_.clear();
    mates(fork, add(Join{}));
  }

 private:
  void mates(NodeId a, NodeId b) {
    graph_.nodes[a.index()].mate = b;
    graph_.nodes[b.index()].mate = a;
  }

  Graph& graph_;
  std::vector<NodeId> open_;
  std::vector<NodeId> ends_;
};

Guard equals(std::size_t condition, bool value) {
  return {Guard::Kind::equals, ConditionId(condition), value, {}};
}

constexpr std::size_t sm1 = 0, mc1 = 1, ls1 = 2, cm1 = 3;

ChannelId channel(Network& network, Party from, const char* message, Party to) {
  const MessageId id(network.messages.size());
  network.messages.push_back({message, {}, {}, {}});
  if (std::string_view(message).substr(0, 8) == "request ") network.messages.back().asks_for = id;
  network.channels.push_back({from, id, to, {}, {}});
  return ChannelId(network.channels.size() - 1);
}

}  // namespace

Network touch_network() {
  Network network;
  network.skill.name = "touch";
  network.main = ModuleId(sm1);
  network.modules = {{"SM1", ModuleKind::skill_module, {}, {}, {"SM1", "SM1.1", "SM1.2"}, {}, {}, {}, {}, {}},
                     {"MC1", ModuleKind::machine_controller, {}, {}, {"MC1"}, {}, {}, {}, {}, {}},
                     {"LS1", ModuleKind::logical_sensor, {}, {}, {"LS1"}, {}, {}, {}, {}, {}},
                     {"CM1", ModuleKind::contingency_module, {}, ModuleId(sm1), {}, {}, {}, {}, {}, {}}};
  network.devices = {{"alter", "", {}}};
  network.conditions = {{"pc-force", "", ModuleId(sm1), {}, {}}, {"pc-reach", "", ModuleId(sm1), {}, {}}};
  network.activities = {{"advance", ModuleId(sm1), {}, {}, {}},
                        {"stand-still", ModuleId(sm1), {}, {}, {}},
                        {"obey", ModuleId(mc1), {}, {}, {}},
                        {"hold", ModuleId(mc1), {}, {}, {}}};
  const ChannelId ask_force = channel(network, ModuleId(sm1), "request Zforce", ModuleId(ls1));
  const ChannelId force = channel(network, ModuleId(ls1), "Zforce", ModuleId(sm1));
  const ChannelId ask_motion = channel(network, ModuleId(mc1), "request motion", ModuleId(sm1));
  const ChannelId motion = channel(network, ModuleId(sm1), "motion", ModuleId(mc1));
  const ChannelId tick = channel(network, DeviceId(std::size_t{0}), "tick", ModuleId(mc1));
  const ChannelId correction = channel(network, ModuleId(mc1), "correction", DeviceId(std::size_t{0}));
  const ConditionId pc_force(std::size_t{0});
  const ConditionId pc_reach(std::size_t{1});

  Body body(network.modules[sm1].body);
  body.add(Start{});
  body.add(WaitForStart{});
  body.add(Send{ask_force});
  body.add(Wait{{force}, {}});
  body.add(Set{pc_force, {}});
  const NodeId fork = body.add(Fork{{1, 2}});
  NodeId loop = body.add(Loop{});
  body.add(Send{ask_force});
  body.add(Wait{{force}, {}});
  body.add(Set{pc_force, {}});
  body.until(loop, {});
  body.end_block();
  body.branch(fork);
  loop = body.add(Loop{});
  body.add(Wait{{ask_motion}, {}});
  body.add(Read{pc_force});
  NodeId choose = body.add(Choose{{equals(0, true), equals(0, false)}});
  body.add(Perform{ActivityId(std::size_t{1})});
  body.add(Send{motion});
  body.leave();
  body.branch(choose);
  body.add(Perform{ActivityId(std::size_t{0})});
  body.add(Send{motion});
  body.add(Set{pc_reach, {}});
  body.leave();
  body.merge(choose);
  body.until(loop, Guard{Guard::Kind::any_of, {}, true, {equals(0, true), equals(1, true)}});
  body.end_block();
  body.join(fork);
  network.modules[sm1].body.nodes[fork.index()].out.resize(2);
  body.branch(NodeId(network.modules[sm1].body.nodes.size() - 1));
  choose = body.add(Choose{{equals(1, false), equals(1, true)}});
  body.add(Complete{0});
  body.leave();
  body.branch(choose);
  body.add(Execute{ModuleId(cm1)});
  body.add(Complete{1});
  body.leave();
  body.merge(choose);
  body.add(End{});

  Body controller(network.modules[mc1].body);
  controller.add(Start{});
  loop = controller.add(Loop{});
  controller.add(Wait{{tick}, {}});
  controller.add(Send{ask_motion});
  const NodeId wait = controller.add(Wait{{motion}, Duration(4'000'000)});
  controller.add(Perform{ActivityId(std::size_t{2})});
  controller.leave();
  controller.branch(wait);
  controller.add(Perform{ActivityId(std::size_t{3})});
  controller.leave();
  controller.merge(wait);
  controller.add(Send{correction});
  controller.until(loop, {});
  controller.end_block();
  return network;
}

}  // namespace pal::pan
