#include "analyzer/problem/compile.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <tuple>

#include "analyzer/problem/empty_rounds.hpp"
#include "pal/pan/dump.hpp"
#include "pal/pan/threads.hpp"
#include "pal/support/finding.hpp"

namespace pal::analyzer {
namespace {

using namespace pan;

Range range(const Interval& interval) {
  return {interval.best.count(), interval.worst.count()};
}

/// Steps of one body in one thread. A module that is executed in two places is compiled once for each: where
/// its flow goes on differs. Its blocks are compiled once for each thread that executes it: where they end
/// nothing goes on.
class Compiler {
 public:
  Compiler(const Network& network, TimesAndPlaces& environment, const SourceManager* sources,
           Diagnostics& diagnostics, Problem& problem)
      : network_(network),
        environment_(environment),
        sources_(sources),
        diagnostics_(diagnostics),
        problem_(problem) {}

  void threads() {
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      const pan::Module& module = network_.modules[m];
      if (module.body.empty() || module.executed_by.valid()) continue;
      const ThreadId index = new_thread(module.name, ModuleId(m), {}, {});
      Place place{m, index, index, {}, nullptr};
      const StepId entry = step_at(place, NodeId(std::size_t{0}));
      thread(index).entry = entry;
      fill_all();
    }
  }

 private:
  /// Where code is being compiled: a body, for a thread, with what follows its end (nothing: the thread
  /// ends).
  struct Place {
    std::size_t module;
    ThreadId thread;
    ThreadId runner;                // the thread that runs the module's body: of a block, an outer one
    std::map<NodeId, StepId> done;  // step of each node that has one
    std::function<StepId()> after;
    int depth = 0;
    CallId call{};  // of a body that is executed
  };

  /// A step that is known and not yet filled, or one that stands in for the beginning of a body.
  struct Open {
    Place* place;
    NodeId node{};
    StepId step;
    bool stands_in;
  };

  /// One step after another, so that a long body takes no deep stack.
  void fill_all() {
    while (!open_.empty()) {
      const Open next = open_.back();
      open_.pop_back();
      if (next.stands_in) {
        const StepId first = step_at(*next.place, next.node);
        forwards_[next.step] = first;
        continue;
      }
      Step made;
      made.statement = statement(next.place->module, next.node);
      made.call = next.place->call;
      fill(*next.place, body(*next.place)[next.node], made);
      step(next.step) = std::move(made);
    }
  }

  /// Past all stand-ins that follow one another.
  void lead_on(StepId entry) {
    std::vector<StepId> way;
    StepId at = entry;
    while (forwards_.contains(at) && !led_.contains(at)) {
      led_.insert(at);
      way.push_back(at);
      at = forwards_[at];
    }
    if (!way.empty() && forwards_.contains(at) && std::find(way.begin(), way.end(), at) != way.end()) {
      diagnostics_.report(Finding::nothing_happens_around_this, executes_.at(at));
    }
    const auto known = forwards_.find(at);
    const StepId first = known == forwards_.end() ? at : known->second;
    for (const StepId each : way) forwards_[each] = first;
  }

  Thread& thread(ThreadId index) { return problem_.threads[index]; }
  /// What the module of `place` keeps of the messages. Those without a value are not kept.
  std::vector<KeptId> kept(const Place& place, const std::vector<MessageId>& messages) {
    std::vector<KeptId> all;
    for (const MessageId message : messages) {
      if (network_.messages[message.index()].fields.empty()) continue;
      const auto key = std::pair(thread(place.thread).module, message);
      const auto [known, fresh] = kept_.try_emplace(key, KeptId(problem_.kept.size()));
      if (fresh) problem_.kept.push_back({key.first, key.second});
      all.push_back(known->second);
    }
    return all;
  }

  Step& step(StepId index) { return problem_.steps[index]; }

  ThreadId new_thread(const std::string& name, ModuleId module, ThreadId parent, ThreadId runner) {
    Thread made;
    made.name = name;
    made.module = module;
    made.parent = parent;
    environment_.place(made, runner);
    return problem_.threads.push_back(std::move(made));
  }

  const Graph& body(const Place& place) const { return network_.modules[place.module].body; }

  StepId end_step() { return problem_.steps.push_back({}); }

  /// The first step from `node` on that is one: everything without time is passed over.
  StepId step_at(Place& place, NodeId node) {
    const Graph& graph = body(place);
    for (std::size_t passed = 0; passed <= graph.nodes.size(); ++passed) {
      const Node& at = graph[node];
      if (std::holds_alternative<End>(at.content)) return place.after ? place.after() : end_step();
      if (const auto* execute = std::get_if<Execute>(&at.content)) return inlined(place, at, *execute);
      const auto* until = std::get_if<Until>(&at.content);
      const bool forever = until != nullptr && !until->guard;
      const bool passes =
          forever || std::holds_alternative<Start>(at.content) ||
          std::holds_alternative<WaitForStart>(at.content) || std::holds_alternative<Nothing>(at.content) ||
          std::holds_alternative<Merge>(at.content) || std::holds_alternative<Loop>(at.content) ||
          std::holds_alternative<Join>(at.content);
      if (!passes) return compiled(place, node);
      node = forever ? graph[at.mate].out.front() : at.out.front();
    }
    diagnostics_.report(Finding::nothing_happens_in_loop, graph[node].where);
    return end_step();
  }

  StepId inlined(Place& place, const Node& node, const Execute& execute) {
    if (place.depth > 32) {
      diagnostics_.report(Finding::executes_too_deeply, node.where);
      return end_step();
    }
    if (problem_.steps.size() > most_steps) return end_step();
    // Each place of an Execute has its own copy, kept alive as long as its steps may still be asked for.
    const auto known = place.done.find(index_of(place, node));
    if (known != place.done.end()) return known->second;
    const StepId entry = end_step();
    place.done.emplace(index_of(place, node), entry);
    auto inner = std::make_unique<Place>();
    inner->module = execute.module.index();
    inner->thread = inner->runner = place.thread;
    inner->depth = place.depth + 1;
    inner->call = problem_.calls.push_back({ModuleId(place.module), index_of(place, node), place.call});
    const NodeId next = node.out.front();
    inner->after = [this, &place, next] { return step_at(place, next); };
    Place& kept = *inner;
    places_.push_back(std::move(inner));
    executes_.emplace(entry, node.where);
    open_.push_back({&kept, NodeId(std::size_t{0}), entry, true});
    return entry;
  }

  NodeId index_of(const Place& place, const Node& node) const {
    return NodeId(static_cast<std::size_t>(&node - body(place).nodes.data()));
  }

  StepId compiled(Place& place, NodeId id) {
    const auto known = place.done.find(id);
    if (known != place.done.end()) return known->second;
    const StepId index = end_step();
    place.done.emplace(id, index);
    // Modules that execute one another twice each multiply; what is too large is refused, however it goes on.
    if (problem_.steps.size() > most_steps) return index;
    open_.push_back({&place, id, index, false});
    return index;
  }

  void follow(Place& place, const Node& node, Step& made) {
    for (NodeId out : node.out) made.next.push_back(step_at(place, out));
  }

  void fill(Place& place, const Node& node, Step& made) {
    const Costs& costs = environment_.costs();
    if (const auto* wait = std::get_if<Wait>(&node.content)) {
      made.kind = Step::Kind::wait;
      made.cost = range(costs.receive);
      made.give_up_cost = range(costs.test);
      for (ChannelId channel : wait->channels) made.channels.push_back(channel);
      if (wait->within) made.within = wait->within->count();
      follow(place, node, made);
    } else if (const auto* send = std::get_if<Send>(&node.content)) {
      made.kind = Step::Kind::send;
      made.cost = range(costs.send);
      made.channels.push_back(send->channel);
      made.uses = kept(place, {network_.channels[send->channel.index()].message});
      follow(place, node, made);
    } else if (const auto* complete = std::get_if<Complete>(&node.content)) {
      made.kind = Step::Kind::complete;
      made.cost = range(costs.send);
      made.code = complete->code;
    } else if (const auto* set = std::get_if<Set>(&node.content)) {
      made.kind = Step::Kind::set;
      made.cost = range(costs.set);
      made.condition = set->condition;
      made.value = set->value;
      if (!set->value) made.uses = kept(place, network_.conditions[set->condition.index()].from);
      follow(place, node, made);
    } else if (const auto* read = std::get_if<Read>(&node.content)) {
      made.kind = Step::Kind::read;
      made.cost = range(costs.read);
      made.condition = read->condition;
      follow(place, node, made);
    } else if (const auto* perform = std::get_if<Perform>(&node.content)) {
      made.kind = Step::Kind::activity;
      const pan::Activity& activity = network_.activities[perform->activity.index()];
      made.cost = environment_.activity(activity);
      made.uses = kept(place, activity.reads);
      made.writes = kept(place, activity.writes);
      follow(place, node, made);
    } else if (const auto* choose = std::get_if<Choose>(&node.content)) {
      made.kind = Step::Kind::test;
      made.cost = range(costs.test);
      made.guards = choose->guards;
      follow(place, node, made);
    } else if (const auto* until = std::get_if<Until>(&node.content)) {
      made.kind = Step::Kind::test;
      made.cost = range(costs.test);
      made.guards.push_back(*until->guard);
      follow(place, node, made);
      made.next.push_back(step_at(place, body(place)[node.mate].out.front()));
    } else if (const auto* fork = std::get_if<Fork>(&node.content)) {
      fill_fork(place, node, *fork, made);
    }
  }

  void fill_fork(Place& place, const Node& node, const Fork& fork, Step& made) {
    made.kind = Step::Kind::fork;
    for (std::size_t i = 0; i < fork.threads.size(); ++i)
      made.threads.push_back(block(place, node.out[i], fork.threads[i]));
    made.next.push_back(step_at(place, body(place)[node.mate].out.front()));
  }

  /// The thread of a block: its own for each thread that begins it, however often that executes the module.
  ThreadId block(Place& place, NodeId first, std::size_t number) {
    const auto key = std::tuple(place.thread, place.module, number);
    if (const auto known = blocks_.find(key); known != blocks_.end()) return known->second;
    const Thread& runner = thread(place.runner);
    const std::string name =
        pan::block_name(runner.name, runner.parent.valid(), network_.modules[place.module].threads[number]);
    const ThreadId made = new_thread(name, runner.module, place.thread, place.runner);
    blocks_.emplace(key, made);
    auto inside = std::make_unique<Place>();
    inside->module = place.module;
    inside->thread = made;
    inside->runner = place.runner;
    inside->depth = place.depth;
    Place& kept = *inside;
    places_.push_back(std::move(inside));
    const StepId entry = step_at(kept, first);
    thread(made).entry = entry;
    return made;
  }

  StatementId statement(std::size_t module, NodeId id) {
    const auto key = std::pair{module, id.value};
    const auto known = statements_.find(key);
    if (known != statements_.end()) return known->second;
    const Node& node = network_.modules[module].body[id];
    Statement made;
    made.module = network_.modules[module].name;
    made.text = pan::statement_text(network_, pan::ModuleId(module), id);
    made.where = node.where;
    made.source_module = ModuleId(module);
    made.source_node = id;
    if (sources_ != nullptr && node.where.valid()) {
      made.file = sources_->name(node.where.file);
      made.line = sources_->line_column(node.where.file, node.where.begin).line;
    }
    const StatementId index = problem_.statements.push_back(std::move(made));

    statements_.emplace(key, index);
    return index;
  }

 public:
  /// The taker of a message keeps it where a statement may use it.
  void keep_taken() {
    for (const ChannelId c : problem_.channels.ids()) {
      const auto known =
          kept_.find({problem_.channels[c].receiver_module, network_.channels[c.index()].message});
      if (known != kept_.end()) problem_.channels[c].kept = known->second;
    }
  }

  /// Links that lead to the stand-in of an Execute lead on to its first step.
  void link() {
    for (const auto& [entry, first] : forwards_) lead_on(entry);
    const auto target = [this](StepId index) {
      const auto forward = forwards_.find(index);
      return forward == forwards_.end() ? index : forward->second;
    };
    for (Step& each : problem_.steps) {
      for (StepId& next : each.next) next = target(next);
    }
    for (Thread& each : problem_.threads) each.entry = target(each.entry);
  }

 private:
  const Network& network_;
  TimesAndPlaces& environment_;
  const SourceManager* sources_;
  Diagnostics& diagnostics_;
  Problem& problem_;
  std::vector<std::unique_ptr<Place>> places_;
  std::vector<Open> open_;
  std::map<StepId, StepId> forwards_;      // by stand-in: the step that it stands for
  std::map<StepId, SourceSpan> executes_;  // by stand-in
  std::set<StepId> led_;
  std::map<std::tuple<ThreadId, std::size_t, std::size_t>, ThreadId> blocks_;  // by parent, module and number
  std::map<std::pair<std::size_t, std::int32_t>, StatementId> statements_;
  std::map<std::pair<ModuleId, MessageId>, KeptId> kept_;
};

/// Which threads can reach their end. Blocks stand behind their parents, so the last are known first.
void find_ends(Problem& problem) {
  for (std::size_t i = problem.threads.size(); i-- > 0;) {
    const ThreadId t(i);
    Table<StepId, bool> seen(problem.steps.size());
    std::vector<StepId> open{problem.threads[t].entry};
    bool can_end = false;
    while (!open.empty()) {
      const StepId at = open.back();
      open.pop_back();
      if (seen[at]) continue;
      seen[at] = true;
      const Step& step = problem.steps[at];
      if (step.kind == Step::Kind::end) can_end = true;
      bool passes = step.kind != Step::Kind::fork;
      for (const ThreadId block : step.threads) passes = passes || problem.threads[block].can_end;
      if (passes) open.insert(open.end(), step.next.begin(), step.next.end());
    }
    problem.threads[t].can_end = can_end;
  }
}

}  // namespace

void compile(const Network& network, TimesAndPlaces& environment, const SourceManager* sources,
             Diagnostics& diagnostics, Problem& problem) {
  Compiler compiler(network, environment, sources, diagnostics, problem);
  compiler.threads();
  compiler.link();
  compiler.keep_taken();
  find_ends(problem);
  report_empty_rounds(problem, diagnostics);
}

DeviceId device_of(const Network& network, const Party& party) {
  if (const auto* device = std::get_if<pan::DeviceId>(&party)) return DeviceId(device->index());
  const std::size_t module = std::get<ModuleId>(party).index();
  if (!network.modules[module].body.empty()) return DeviceId{};
  std::size_t index = network.devices.size();
  for (std::size_t m = 0; m < module; ++m) {
    if (network.modules[m].body.empty()) ++index;
  }
  return DeviceId(index);
}

}  // namespace pal::analyzer
