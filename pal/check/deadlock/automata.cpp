#include "pal/check/deadlock/automata.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <tuple>
#include <utility>

#include "pal/check/deadlock/simplify.hpp"
#include "pal/pan/threads.hpp"

namespace pal::check::deadlock {

namespace {

class Compiler {
 public:
  Compiler(const pan::Network& network, const pan::Flow& flow) : network_(network), flow_(flow) {}

  Automata compile() {
    describe_channels();
    std::vector<std::size_t> order;
    if (network_.main.valid()) order.push_back(network_.main.index());
    for (std::size_t m = 0; m < network_.modules.size(); ++m) {
      if (pan::ModuleId(m) != network_.main) order.push_back(m);
    }
    for (const auto m : order) {
      const auto& module = network_.modules[m];
      if (module.body.empty() || module.executed_by.valid()) continue;
      const auto thread = new_thread(module.name, pan::ModuleId(m), std::nullopt);
      Body& body = new_body(pan::ModuleId(m), thread, thread);
      body.after = [this, m, thread] { return end(pan::ModuleId(m), thread); };
      const auto first = step_at(body, pan::NodeId(0));
      result_.threads[thread].first = first;
    }
    // A list of what is still to be done instead of recursion: a body may be very long.
    while (!open_.empty() && result_.steps.size() <= most_steps) {
      const auto [body, id, index] = open_.back();
      open_.pop_back();
      const auto& here = node(*body, id);
      Step step = result_.steps[index];
      std::visit([&, b = body](const auto& content) { fill(*b, here, content, step); }, here.content);
      result_.steps[index] = std::move(step);
    }
    simplify(result_);
    return std::move(result_);
  }

 private:
  /// A body on its way to steps: for a thread, with what follows its end.
  struct Body {
    pan::ModuleId module;
    std::size_t thread;
    std::size_t runner;  // the thread that runs the module's body: of a block, an outer one
    std::map<pan::NodeId, std::size_t> done;
    std::function<std::size_t()> after;
  };

  struct Open {
    Body* body;
    pan::NodeId node;
    std::size_t step;
  };

  Body& new_body(pan::ModuleId module, std::size_t thread, std::size_t runner) {
    bodies_.push_back({module, thread, runner, {}, {}});
    return bodies_.back();
  }

  bool is_device(const pan::Party& party) const {
    const auto* module = std::get_if<pan::ModuleId>(&party);
    return module == nullptr || network_.modules[module->index()].body.empty();
  }

  void describe_channels() {
    result_.request_of.resize(network_.channels.size());
    result_.answer_of.resize(network_.channels.size());
    for (std::size_t i = 0; i < network_.channels.size(); ++i) {
      const auto& channel = network_.channels[i];
      if (channel.answer.valid()) {
        result_.request_of[channel.answer.index()] = pan::ChannelId(i);
        result_.answer_of[i] = channel.answer;
      }
      result_.from_device.push_back(is_device(channel.sender));
      result_.to_device.push_back(is_device(channel.receiver));
      const bool is_request = network_.messages[channel.message.index()].asks_for.valid();
      const auto* sender = std::get_if<pan::ModuleId>(&channel.sender);
      result_.command.push_back(!is_request && sender != nullptr && *sender == network_.main &&
                                !result_.to_device.back());
    }
    result_.bit.resize(network_.conditions.size());
    result_.unknown.resize(network_.conditions.size());
  }

  std::size_t new_thread(std::string name, pan::ModuleId module, std::optional<std::size_t> parent) {
    Thread thread;
    thread.name = std::move(name);
    thread.module = module;
    thread.parent = parent;
    const auto index = result_.threads.size();
    if (parent) {
      thread.depth = result_.threads[*parent].depth + 1;
      result_.threads[*parent].children.push_back(index);
    }
    result_.threads.push_back(std::move(thread));
    return index;
  }

  std::size_t new_step(Step::Kind kind, pan::ModuleId module, pan::NodeId node, std::size_t thread) {
    Step step;
    step.kind = kind;
    step.module = module;
    step.node = node;
    step.thread = thread;
    result_.steps.push_back(std::move(step));
    return result_.steps.size() - 1;
  }

  std::size_t end(pan::ModuleId module, std::size_t thread) {
    const auto& nodes = network_.modules[module.index()].body.nodes;
    return new_step(Step::Kind::end, module, pan::NodeId(nodes.size() - 1), thread);
  }

  const pan::Node& node(const Body& body, pan::NodeId id) const {
    return network_.modules[body.module.index()].body[id];
  }

  bool passed_over(const pan::Content& content) const {
    if (const auto* until = std::get_if<pan::Until>(&content)) return !until->guard;
    if (const auto* execute = std::get_if<pan::Execute>(&content))
      return network_.modules[execute->module.index()].body.empty();
    return std::holds_alternative<pan::Start>(content) ||
           std::holds_alternative<pan::WaitForStart>(content) ||
           std::holds_alternative<pan::Perform>(content) || std::holds_alternative<pan::Nothing>(content) ||
           std::holds_alternative<pan::Merge>(content) || std::holds_alternative<pan::Loop>(content) ||
           std::holds_alternative<pan::Join>(content);
  }

  /// The first step from `id` on that is one.
  std::size_t step_at(Body& body, pan::NodeId id) {
    const auto& nodes = network_.modules[body.module.index()].body.nodes;
    std::optional<pan::NodeId> work;  // the last that takes time
    for (std::size_t passed = 0; passed <= 2 * nodes.size(); ++passed) {
      const auto& here = node(body, id);
      if (std::holds_alternative<pan::End>(here.content))
        return work ? worked(body, *work, body.after()) : body.after();
      if (!passed_over(here.content)) {
        const bool may_end = std::holds_alternative<pan::Fork>(here.content) ||
                             std::holds_alternative<pan::Execute>(here.content);
        return work && may_end ? worked(body, *work, made(body, id)) : made(body, id);
      }
      if (std::holds_alternative<pan::Perform>(here.content)) work = id;
      const bool forever = std::holds_alternative<pan::Until>(here.content);
      id = forever ? here.mate : here.out.front();
    }
    return new_step(Step::Kind::spin, body.module, id, body.thread);
  }

  /// Work of a block before `next`, where the block may end.
  std::size_t worked(Body& body, pan::NodeId id, std::size_t next) {
    if (!result_.threads[body.thread].parent) return next;
    const auto [found, fresh] = body.done.emplace(id, result_.steps.size());
    if (!fresh) return found->second;
    const auto index = new_step(Step::Kind::work, body.module, id, body.thread);
    result_.steps[index].next = {next};
    return index;
  }

  std::size_t made(Body& body, pan::NodeId id) {
    if (const auto found = body.done.find(id); found != body.done.end()) return found->second;
    const auto index = new_step(Step::Kind::spin, body.module, id, body.thread);
    body.done.emplace(id, index);
    open_.push_back({&body, id, index});
    return index;
  }

  void follow(Body& body, const pan::Node& here, Step& step) {
    for (const auto out : here.out) step.next.push_back(step_at(body, out));
  }

  template <class Content>
  void fill(Body&, const pan::Node&, const Content&, Step&) {}

  void fill(Body& body, const pan::Node& here, const pan::Execute& execute, Step& step) {
    step.kind = Step::Kind::enter;
    Body& inner = new_body(execute.module, body.thread, body.thread);
    inner.after = [this, &body, next = here.out.front()] { return step_at(body, next); };
    step.next.push_back(step_at(inner, pan::NodeId(0)));
  }

  void fill(Body& body, const pan::Node& here, const pan::Wait& wait, Step& step) {
    step.kind = Step::Kind::wait;
    step.channels = wait.channels;
    step.gives_up = wait.within.has_value();
    follow(body, here, step);
  }

  void fill(Body& body, const pan::Node& here, const pan::Send& send, Step& step) {
    step.kind = Step::Kind::send;
    step.channels = {send.channel};
    follow(body, here, step);
  }

  void fill(Body&, const pan::Node&, const pan::Complete&, Step& step) { step.kind = Step::Kind::complete; }

  void fill(Body& body, const pan::Node& here, const pan::Set& set, Step& step) {
    step.kind = Step::Kind::set;
    step.condition = set.condition;
    step.value = set.value;
    follow(body, here, step);
  }

  void fill(Body& body, const pan::Node& here, const pan::Read& read, Step& step) {
    step.kind = Step::Kind::latch;
    step.condition = read.condition;
    follow(body, here, step);
  }

  void fill(Body& body, const pan::Node& here, const pan::Choose& choose, Step& step) {
    step.kind = Step::Kind::test;
    step.guards = choose.guards;
    follow(body, here, step);
  }

  void fill(Body& body, const pan::Node& here, const pan::Until& until, Step& step) {
    step.kind = Step::Kind::test;
    step.guards = {*until.guard};
    step.otherwise = true;
    step.next.push_back(step_at(body, here.out.front()));
    step.next.push_back(step_at(body, here.mate));
  }

  void fill(Body& body, const pan::Node& here, const pan::Fork& fork, Step& step) {
    step.kind = Step::Kind::fork;
    const bool ends =
        flow_.fork_can_end(body.module, node(body, here.mate).mate);  // the join's mate is this node
    const auto join = new_step(Step::Kind::join, body.module, here.mate, body.thread);
    for (std::size_t i = 0; i < fork.threads.size(); ++i) {
      const auto thread = block(body, here.out[i], fork.threads[i]);
      step.blocks.push_back(thread);
      step.next.push_back(result_.threads[thread].first);
    }
    step.next.push_back(join);  // where the parent waits
    if (ends) {
      const auto after = step_at(body, node(body, here.mate).out.front());
      result_.steps[join].next.push_back(after);
    }
  }

  /// The thread of a block: its own for each thread that begins it, however often that executes the module.
  std::size_t block(const Body& body, pan::NodeId first, std::size_t number) {
    const auto key = std::tuple(body.thread, body.module, number);
    if (const auto known = blocks_.find(key); known != blocks_.end()) return known->second;
    const Thread& runner = result_.threads[body.runner];
    const auto& text = network_.modules[body.module.index()].threads[number];
    const auto thread =
        new_thread(pan::block_name(runner.name, runner.parent.has_value(), text), body.module, body.thread);
    blocks_.emplace(key, thread);
    result_.threads[thread].can_end = flow_.block_can_end(body.module, first);
    Body& inside = new_body(body.module, thread, body.runner);
    inside.after = [this, module = body.module, thread] { return end(module, thread); };
    const auto begins = step_at(inside, first);
    result_.threads[thread].first = begins;
    return thread;
  }

  const pan::Network& network_;
  const pan::Flow& flow_;
  Automata result_;
  std::map<std::tuple<std::size_t, pan::ModuleId, std::size_t>, std::size_t> blocks_;
  std::deque<Body> bodies_;
  std::vector<Open> open_;
};

}  // namespace

Automata automata(const pan::Network& network, const pan::Flow& flow) {
  return Compiler(network, flow).compile();
}

bool end_may_cancel(const Automata& automata, std::size_t thread) {
  for (auto at = thread; automata.threads[at].parent;) {
    at = *automata.threads[at].parent;
    for (const auto block : automata.threads[at].children) {
      if (!automata.threads[block].can_end) return true;
    }
  }
  return false;
}

Automata without_conditions(Automata automata) {
  for (std::size_t c = 0; c < automata.bit.size(); ++c) {
    automata.unknown[c] = automata.bit[c].has_value();
    automata.bit[c].reset();
  }
  automata.bits = 0;
  return automata;
}

}  // namespace pal::check::deadlock
