#include "codegen/body.hpp"

#include <algorithm>

#include "codegen/file_names.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::codegen {

namespace {

using Kind = PlannedStatement::Kind;

template <class T>
void add_once(std::vector<T>& list, const T& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

class BodyPlanner {
 public:
  BodyPlanner(const pan::Network& network, const pan::Flow& flow, pan::ModuleId module,
              const pan::Environment& environment, const SourceManager& sources, const Indices& indices,
              Diagnostics& diagnostics, Scope& rows, Plan& plan)
      : network_(network),
        flow_(flow),
        module_(module),
        graph_(network.modules[module.index()].body),
        environment_(environment),
        sources_(sources),
        indices_(indices),
        diagnostics_(diagnostics),
        rows_(rows),
        plan_(plan),
        planned_(plan.modules[*indices.modules[module.index()]]) {}

  void plan() {
    methods_.resize(network_.activities.size());
    decisions_.resize(network_.conditions.size());
    composes_.resize(network_.messages.size());
    activities();
    find_taken();
    planned_.body = follow(pan::NodeId(std::size_t{0}), {});
    std::sort(planned_.blocks.begin(), planned_.blocks.end(),
              [](const auto& a, const auto& b) { return a.threads < b.threads; });
  }

 private:
  // What the module's author writes.

  void activities() {
    for (std::size_t a = 0; a < network_.activities.size(); ++a) {
      const pan::Activity& activity = network_.activities[a];
      if (activity.module != module_) continue;
      PlannedMethod method;
      method.kind = PlannedMethod::Kind::activity;
      method.name = names_.unique(snake_case(activity.name));
      method.pal = "ACTIVITY " + activity.name;
      method.reads = keep(activity.reads, " READS ", method.pal);
      method.writes = keep(activity.writes, " WRITES ", method.pal);
      for (const pan::MessageId message : activity.writes) given_.push_back(message);
      methods_[a] = planned_.methods.size();
      planned_.methods.push_back(std::move(method));
    }
  }

  /// The messages with fields among `messages`, which the module keeps from now on; `pal` gets the list of
  /// all.
  std::vector<std::size_t> keep(const std::vector<pan::MessageId>& messages, const char* word,
                                std::string& pal) {
    std::vector<std::size_t> kept;
    for (const pan::MessageId message : messages) {
      pal += (message == messages.front() ? word : ", ") + network_.messages[message.index()].name;
      if (const auto index = keep(message)) kept.push_back(*index);
    }
    return kept;
  }

  std::optional<std::size_t> keep(pan::MessageId message) {
    const auto index = indices_.messages[message.index()];
    if (index) add_once(planned_.messages, *index);
    return index;
  }

  /// A message that the module takes somewhere is what it sends on under the same name.
  void find_taken() {
    for (const pan::Node& node : graph_.nodes) {
      const auto* wait = std::get_if<pan::Wait>(&node.content);
      if (wait == nullptr) continue;
      for (const pan::ChannelId channel : wait->channels) {
        given_.push_back(network_.channels[channel.index()].message);
      }
    }
  }

  std::size_t decision(pan::ConditionId id) {
    auto& known = decisions_[id.index()];
    if (known) return *known;
    const pan::Condition& condition = network_.conditions[id.index()];
    PlannedMethod method;
    method.kind = PlannedMethod::Kind::decide;
    method.name = names_.unique("decide_" + snake_words(condition.name));
    method.pal = "SPC( " + condition.name + " )";
    method.description = condition.description;
    method.reads = keep(condition.from, " FROM ", method.pal);
    known = planned_.methods.size();
    planned_.methods.push_back(std::move(method));
    return *known;
  }

  std::optional<std::size_t> composition(pan::MessageId id) {
    const auto message = keep(id);
    if (!message || std::find(given_.begin(), given_.end(), id) != given_.end()) return std::nullopt;
    auto& known = composes_[id.index()];
    if (known) return known;
    PlannedMethod method;
    method.kind = PlannedMethod::Kind::compose;
    method.name = names_.unique("compose_" + snake_words(network_.messages[id.index()].name));
    method.pal = "TXM( " + network_.messages[id.index()].name + " … )";
    method.writes.push_back(*message);
    known = planned_.methods.size();
    planned_.methods.push_back(std::move(method));
    return known;
  }

  // Statements.

  int line_of(const pan::Node& node) const {
    if (!node.where.valid()) return 0;
    return sources_.line_column(node.where.file, node.where.begin).line;
  }

  std::size_t row(pan::NodeId id, const Interval& cost) {
    const pan::Node& node = graph_[id];
    PlannedRow made;
    made.module = planned_.pal_name;
    made.text = pan::statement_text(network_, module_, id);
    if (node.where.valid()) made.file = file_name(sources_, node.where.file, network_.skill.where.file);
    made.line = line_of(node);
    const std::string place =
        made.line > 0 ? "line_" + std::to_string(made.line) : "node_" + std::to_string(id.value);
    made.constant = rows_.unique(planned_.words + "_" + place);
    made.cost = cost;
    made.pan_module = module_;
    made.pan_node = id;
    plan_.statements.push_back(std::move(made));
    return plan_.statements.size() - 1;
  }

  Interval time_of(pan::ActivityId id) {
    const pan::Activity& activity = network_.activities[id.index()];
    const pan::ActivityTime* found = nullptr;
    for (const pan::ActivityTime& time : environment_.activities) {
      if (time.activity != activity.name || !(time.module.empty() || time.module == planned_.pal_name))
        continue;
      if (found == nullptr || found->module.empty()) found = &time;
    }
    if (found != nullptr) return found->time;
    diagnostics_.report(Finding::activity_without_time, environment_.where, environment_.name, activity.name,
                        planned_.pal_name);
    return {};
  }

  PlannedEnd end(pan::ChannelId id) { return {id.index(), keep(network_.channels[id.index()].message)}; }

  /// The statements from `id` up to, and without, `stop` or an end.
  PlannedBody follow(pan::NodeId id, pan::NodeId stop) {
    PlannedBody body;
    while (id.valid() && id != stop && !std::holds_alternative<pan::End>(graph_[id].content)) {
      PlannedStatement made;
      made.pal = pan::statement_text(network_, module_, id);
      made.line = line_of(graph_[id]);
      const pan::NodeId next = std::visit(
          [&](const auto& content) { return plan_statement(id, content, made); }, graph_[id].content);
      if (!std::holds_alternative<pan::Start>(graph_[id].content)) body.push_back(std::move(made));
      id = next;
    }
    return body;
  }

  pan::NodeId after(pan::NodeId id) const {
    return graph_[id].out.empty() ? pan::NodeId{} : graph_[id].out.front();
  }

  void branches(pan::NodeId id, PlannedStatement& made) {
    for (const pan::NodeId out : graph_[id].out) made.branches.push_back(follow(out, graph_[id].mate));
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Start&, PlannedStatement&) { return after(id); }
  pan::NodeId plan_statement(pan::NodeId, const pan::End&, PlannedStatement&) { return {}; }

  pan::NodeId plan_statement(pan::NodeId id, const pan::WaitForStart&, PlannedStatement& made) {
    made.kind = Kind::take_start;
    made.row = row(id, {});
    return after(id);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Wait& wait, PlannedStatement& made) {
    made.kind = Kind::wait;
    made.row = row(id, environment_.costs.receive);
    made.within = wait.within;
    for (const pan::ChannelId channel : wait.channels) made.ends.push_back(end(channel));
    if (!graph_[id].mate.valid()) return after(id);
    for (const pan::ChannelId channel : wait.channels) {
      made.arms.push_back(network_.messages[network_.channels[channel.index()].message.index()].name +
                          " from " + pan::party_name(network_, network_.channels[channel.index()].sender));
    }
    if (wait.within) made.arms.emplace_back("ELSE");
    branches(id, made);
    return after(graph_[id].mate);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Send& send, PlannedStatement& made) {
    made.kind = Kind::send;
    made.row = row(id, environment_.costs.send);
    made.method = composition(network_.channels[send.channel.index()].message);
    made.ends.push_back(end(send.channel));
    return after(id);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Complete& complete, PlannedStatement& made) {
    made.kind = Kind::complete;
    made.row = row(id, environment_.costs.send);
    made.code = complete.code;
    return after(id);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Set& set, PlannedStatement& made) {
    made.kind = Kind::set;
    made.row = row(id, environment_.costs.set);
    made.condition = set.condition.index();
    made.value = set.value;
    if (!set.value) made.method = decision(set.condition);
    return after(id);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Read& read, PlannedStatement& made) {
    made.kind = Kind::read;
    made.row = row(id, environment_.costs.read);
    made.condition = read.condition.index();
    return after(id);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Perform& perform, PlannedStatement& made) {
    made.kind = Kind::perform;
    made.row = row(id, time_of(perform.activity));
    made.method = methods_[perform.activity.index()];
    return after(id);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Execute& execute, PlannedStatement& made) {
    made.kind = Kind::execute;
    made.module = indices_.modules[execute.module.index()];
    if (made.module) add_once(planned_.executes, *made.module);
    return after(id);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Nothing&, PlannedStatement& made) {
    made.kind = Kind::nothing;
    return after(id);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Choose& choose, PlannedStatement& made) {
    made.kind = Kind::choose;
    made.row = row(id, environment_.costs.test);
    made.guards = choose.guards;
    for (const pan::Guard& guard : choose.guards)
      made.arms.push_back("( " + pan::guard_text(network_, guard) + " )");
    branches(id, made);
    return after(graph_[id].mate);
  }

  // A body stops at a Merge, an Until or a Join that the flow comes to. A graph that is well formed has none
  // elsewhere.
  pan::NodeId plan_statement(pan::NodeId, const pan::Merge&, PlannedStatement&) { return {}; }
  pan::NodeId plan_statement(pan::NodeId, const pan::Until&, PlannedStatement&) { return {}; }
  pan::NodeId plan_statement(pan::NodeId, const pan::Join&, PlannedStatement&) { return {}; }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Loop&, PlannedStatement& made) {
    made.kind = Kind::loop;
    made.pan_node = id;
    const pan::NodeId until = graph_[id].mate;
    made.branches.push_back(follow(after(id), until));
    made.until = pan::statement_text(network_, module_, until);
    made.until_line = line_of(graph_[until]);
    const auto& guard = std::get<pan::Until>(graph_[until].content).guard;
    if (!guard) return {};
    made.guards.push_back(*guard);
    made.row = row(until, environment_.costs.test);
    return after(until);
  }

  pan::NodeId plan_statement(pan::NodeId id, const pan::Fork& fork, PlannedStatement& made) {
    made.kind = Kind::concurrent;
    made.row = row(id, {});
    for (std::size_t block = 0; block < fork.threads.size(); ++block) {
      const std::size_t thread = fork.threads[block];
      const std::vector<std::size_t>& threads = indices_.threads[module_.index()][thread];
      made.threads.push_back(threads);
      const bool can_end = flow_.block_can_end(module_, graph_[id].out[block]);
      for (const std::size_t each : threads) plan_.threads[each].can_end = can_end;
      const std::string& name = network_.modules[module_.index()].threads[thread];
      planned_.blocks.push_back({threads, block_function(name), {}});
    }
    branches(id, made);
    return after(graph_[id].mate);
  }

  /// "SM1.2.1" → "block_2_1"
  static std::string block_function(const std::string& thread) {
    std::string name = "block" + thread.substr(std::min(thread.find('.'), thread.size()));
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
  }

  const pan::Network& network_;
  const pan::Flow& flow_;
  pan::ModuleId module_;
  const pan::Graph& graph_;
  const pan::Environment& environment_;
  const SourceManager& sources_;
  const Indices& indices_;
  Diagnostics& diagnostics_;
  Scope& rows_;
  Plan& plan_;
  PlannedModule& planned_;
  Scope names_{{"start", "promise_broken"}};
  std::vector<pan::MessageId> given_;                  // messages that an activity writes or a wait takes
  std::vector<std::optional<std::size_t>> methods_;    // of each activity
  std::vector<std::optional<std::size_t>> decisions_;  // of each condition
  std::vector<std::optional<std::size_t>> composes_;   // of each message
};

}  // namespace

void plan_body(const pan::Network& network, const pan::Flow& flow, pan::ModuleId module,
               const pan::Environment& environment, const SourceManager& sources, const Indices& indices,
               Diagnostics& diagnostics, Scope& rows, Plan& plan) {
  BodyPlanner(network, flow, module, environment, sources, indices, diagnostics, rows, plan).plan();
}

}  // namespace pal::codegen
