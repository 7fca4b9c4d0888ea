#include "tests/support/all_runs.hpp"

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <unordered_set>

namespace pal::test {

using namespace pan;

namespace {

constexpr int most_events = 6;

template <class T>
std::size_t ix(T i) {
  return static_cast<std::size_t>(i);
}

/// Goes through all sequences of decisions.
class Every final : public Decisions {
 public:
  int pick(int n) override {
    if (at_ == taken_.size()) taken_.push_back({0, n});
    return taken_[at_++].first;
  }
  std::vector<int> decided() const {
    std::vector<int> all;
    for (const auto& [taken, of] : taken_) all.push_back(taken);
    return all;
  }
  bool next() {
    at_ = 0;
    while (!taken_.empty() && taken_.back().first + 1 == taken_.back().second) taken_.pop_back();
    if (taken_.empty()) return false;
    ++taken_.back().first;
    return true;
  }

 private:
  std::vector<std::pair<int, int>> taken_;
  std::size_t at_ = 0;
};

/// Decides what was decided before.
class Again final : public Decisions {
 public:
  explicit Again(std::vector<int> decided) : decided_(std::move(decided)) {}
  int pick(int) override { return decided_[at_++]; }

 private:
  std::vector<int> decided_;
  std::size_t at_ = 0;
};

struct TooMuch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace

std::vector<Wanted> wanted(const Network& network, const Environment& environment) {
  std::vector<Wanted> all;
  const auto at = [](const std::vector<StatementRef>& refs) {
    std::set<std::pair<int, int>> set;
    for (const StatementRef& ref : refs) set.insert({ref.module.value, ref.node.value});
    return set;
  };
  for (const Requirement& requirement : network.requirements) {
    const auto* age = std::get_if<Age>(&requirement.measure);
    const auto* condition = age == nullptr ? nullptr : std::get_if<ConditionId>(&age->of);
    if (condition != nullptr) all.push_back({requirement.name, condition->value, -1, at(age->at)});
    if (const auto* response = std::get_if<Response>(&requirement.measure))
      all.push_back({requirement.name, -1, response->event.value, at(response->at)});
  }
  const auto name_of = [&](const Party& party) {
    if (const auto* device = std::get_if<DeviceId>(&party)) return network.devices[device->index()].name;
    return network.modules[std::get<ModuleId>(party).index()].name;
  };
  for (const DeviceTiming& timing : environment.devices) {
    const auto* event = std::get_if<EventDevice>(&timing.behaviour);
    if (event == nullptr || event->answer.empty() || !event->answer_within) continue;
    Wanted answer{timing.device + ".answer", -1, -1, {}};
    for (std::size_t c = 0; c < network.channels.size(); ++c) {
      if (name_of(network.channels[c].sender) == timing.device &&
          network.messages[network.channels[c].message.index()].name == event->message)
        answer.event = static_cast<int>(c);
    }
    for (std::size_t m = 0; m < network.modules.size(); ++m) {
      const Graph& body = network.modules[m].body;
      for (std::size_t n = 0; n < body.nodes.size(); ++n) {
        const auto* send = std::get_if<Send>(&body.nodes[n].content);
        if (send == nullptr) continue;
        const Channel& channel = network.channels[send->channel.index()];
        if (name_of(channel.receiver) == timing.device &&
            network.messages[channel.message.index()].name == event->answer)
          answer.at.insert({static_cast<int>(m), static_cast<int>(n)});
      }
    }
    all.push_back(answer);
  }
  return all;
}

AllRuns::AllRuns(const Network& network, const Environment& environment, Wanted wanted, Duration unit,
                 int cap)
    : network_(network), environment_(environment), wanted_(std::move(wanted)), unit_(unit), cap_(cap) {
  const auto named = [&](const Party& party) -> std::pair<std::string, bool> {
    if (const auto* device = std::get_if<DeviceId>(&party))
      return {network.devices[device->index()].name, true};
    const Module& module = network.modules[std::get<ModuleId>(party).index()];
    return {module.name, module.body.empty()};
  };
  const auto process = [&](const Party& party) {
    const auto [name, outside] = named(party);
    if (!outside) return -1;
    for (std::size_t p = 0; p < processes_.size(); ++p) {
      if (processes_[p].name == name) return static_cast<int>(p);
    }
    Process made;
    made.name = name;
    for (const DeviceTiming& timing : environment.devices) {
      if (timing.device == name) made.timing = &timing;
    }
    processes_.push_back(made);
    return static_cast<int>(processes_.size()) - 1;
  };
  request_of_.assign(network.channels.size(), -1);
  for (std::size_t c = 0; c < network.channels.size(); ++c) {
    const Channel& channel = network.channels[c];
    sender_process_.push_back(process(channel.sender));
    receiver_process_.push_back(process(channel.receiver));
    if (channel.answer.valid()) request_of_[channel.answer.index()] = static_cast<int>(c);
  }
  for (std::size_t c = 0; c < network.channels.size(); ++c) {
    const Channel& channel = network.channels[c];
    if (sender_process_[c] >= 0) {
      Process& from = processes_[ix(sender_process_[c])];
      const auto* event =
          from.timing == nullptr ? nullptr : std::get_if<EventDevice>(&from.timing->behaviour);
      if (event != nullptr && network.messages[channel.message.index()].name == event->message)
        from.event = static_cast<int>(c);
    }
    if (receiver_process_[c] >= 0 && channel.answer.valid()) {
      Process& to = processes_[ix(receiver_process_[c])];
      if (to.timing != nullptr && !std::holds_alternative<EventDevice>(to.timing->behaviour))
        to.requests.push_back(static_cast<int>(c));
    }
  }
}

// Small things.

const Node& AllRuns::node(const Thread& thread) const {
  const auto [module, at] = thread.at.back();
  return network_.modules[ix(module)].body.nodes[ix(at)];
}

int AllRuns::draw(Interval interval) {
  const int best = static_cast<int>(interval.best / unit_);
  const int worst = static_cast<int>(interval.worst / unit_);
  return best == worst ? best : best + decisions_->pick(worst - best + 1);
}

Interval AllRuns::cost_of(const Thread& thread) const {
  const auto& content = node(thread).content;
  const Costs& costs = environment_.costs;
  if (std::holds_alternative<Wait>(content)) return thread.gives_up ? costs.test : costs.receive;
  if (std::holds_alternative<Send>(content) || std::holds_alternative<Complete>(content)) return costs.send;
  if (std::holds_alternative<Set>(content)) return costs.set;
  if (std::holds_alternative<Read>(content)) return costs.read;
  if (const auto* perform = std::get_if<Perform>(&content)) {
    const Activity& activity = network_.activities[perform->activity.index()];
    const std::string& module = network_.modules[activity.module.index()].name;
    Interval anywhere{};
    for (const ActivityTime& time : environment_.activities) {
      if (time.activity != activity.name) continue;
      if (time.module == module) return time.time;
      if (time.module.empty()) anywhere = time.time;
    }
    return anywhere;
  }
  return costs.test;
}

/// Whether a flow from `from` can reach the end of its body (or of its block).
bool AllRuns::can_end(int module, int from, std::set<int>& executing) const {
  const Graph& body = network_.modules[ix(module)].body;
  std::set<int> seen;
  std::vector<int> todo{from};
  while (!todo.empty()) {
    const int at = todo.back();
    todo.pop_back();
    if (!seen.insert(at).second) continue;
    const Node& here = body.nodes[ix(at)];
    if (std::holds_alternative<End>(here.content)) return true;
    if (std::holds_alternative<Complete>(here.content)) continue;
    if (const auto* execute = std::get_if<Execute>(&here.content)) {
      if (!executing.insert(execute->module.value).second) continue;
      const bool passes = can_end(execute->module.value, 0, executing);
      executing.erase(execute->module.value);
      if (!passes) continue;
    }
    if (const auto* until = std::get_if<Until>(&here.content)) {
      todo.push_back(here.mate.value);
      if (!until->guard) continue;
    }
    if (std::holds_alternative<Fork>(here.content)) {
      bool some = false;
      for (NodeId block : here.out) some = some || can_end(module, block.value, executing);
      if (some) todo.push_back(here.mate.value);
      continue;
    }
    for (NodeId out : here.out) todo.push_back(out.value);
  }
  return false;
}

void AllRuns::place(Thread& thread, const std::string& name, int above) const {
  const auto placed = [&](const std::string& what) -> const Placement* {
    for (const Placement& each : environment_.placements) {
      if (each.thread == what) return &each;
    }
    return nullptr;
  };
  const Placement* found = placed(name);
  if (found == nullptr) found = placed(name.substr(0, name.find('.')));
  if (found == nullptr) {
    thread.processor = s_.threads[ix(above)].processor;
    thread.priority = s_.threads[ix(above)].priority;
    return;
  }
  for (std::size_t p = 0; p < environment_.processors.size(); ++p) {
    if (environment_.processors[p].name == found->processor) thread.processor = static_cast<int>(p);
  }
  thread.priority = found->priority;
}

std::string AllRuns::who(int thread) const {
  return thread < 0 ? "-" : names_.at(thread);
}

void AllRuns::say(const std::string& what) {
  if (telling_) story.push_back(std::to_string(now_) + " " + what);
}

void AllRuns::either(bool matters, const std::function<void()>& first, const std::function<void()>& second) {
  if (matters && decisions_->pick(2) == 1) {
    second();
    if (!s_.ended) first();
  } else {
    first();
    if (!s_.ended) second();
  }
}

void AllRuns::any_order(std::vector<int> of, const std::function<void(int)>& each) {
  while (!of.empty() && !s_.ended) {
    const int chosen = of.size() == 1 ? 0 : decisions_->pick(static_cast<int>(of.size()));
    const int next = of[ix(chosen)];
    of.erase(of.begin() + chosen);
    each(next);
  }
}

// The beginning, and time.

void AllRuns::begin() {
  s_ = {};
  now_ = 0;
  s_.running.assign(environment_.processors.size(), -1);
  s_.queues.resize(environment_.processors.size());
  s_.slots.resize(network_.channels.size());
  s_.devices.resize(processes_.size());
  for (std::size_t p = 0; p < processes_.size(); ++p) {
    if (processes_[p].timing == nullptr) continue;
    const auto* frames = std::get_if<FrameDevice>(&processes_[p].timing->behaviour);
    if (frames == nullptr) continue;
    // Phases in [0, T): T itself is 0 with the first frame lost, which is a run as well.
    s_.devices[p].next =
        frames->phase ? draw({*frames->phase, *frames->phase}) : draw({Duration(0), frames->period - unit_});
  }
  std::vector<int> modules;
  for (std::size_t m = 0; m < network_.modules.size(); ++m) {
    const Module& module = network_.modules[m];
    if (module.body.empty() || module.executed_by.valid()) continue;
    Thread made;
    made.at = {{static_cast<int>(m), 0}};
    made.module = static_cast<int>(m);
    place(made, module.name, -1);
    const int index = static_cast<int>(s_.threads.size());
    known_threads_[{-1, made.at}] = index;
    names_[index] = module.name;
    made.status = Status::ready;
    s_.threads.push_back(made);
    modules.push_back(index);
  }
  any_order(modules, [this](int thread) { walk_on(thread); });
  dispatch();
  canonical(s_);
}

bool AllRuns::step() {
  if (s_.ended || s_.failed) return false;
  enum class What { work, limit, near, far, next, late, service };
  std::vector<std::pair<What, int>> first;
  int least = -1;
  const auto due = [&](What what, int which, int left) {
    if (left < 0) return;
    if (least >= 0 && left > least) return;
    if (left < least) first.clear();
    least = left;
    first.push_back({what, which});
  };
  for (std::size_t t = 0; t < s_.threads.size(); ++t) {
    const Thread& thread = s_.threads[t];
    if (thread.status == Status::running && thread.begun) due(What::work, static_cast<int>(t), thread.left);
    if (thread.status == Status::waiting) due(What::limit, static_cast<int>(t), thread.limit);
  }
  for (std::size_t c = 0; c < s_.slots.size(); ++c) {
    due(What::near, static_cast<int>(c), s_.slots[c].near);
    due(What::far, static_cast<int>(c), s_.slots[c].far);
  }
  for (std::size_t d = 0; d < s_.devices.size(); ++d) {
    const Device& device = s_.devices[d];
    // A frame ends before the next one starts.
    const bool frame = device.service >= 0 && processes_[d].timing != nullptr &&
                       std::holds_alternative<FrameDevice>(processes_[d].timing->behaviour);
    if (!frame || device.next < device.service) due(What::next, static_cast<int>(d), device.next);
    due(What::late, static_cast<int>(d), device.late);
    due(What::service, static_cast<int>(d), device.service);
  }
  if (first.empty()) return false;
  pass(least);
  const auto [what, which] =
      first[ix(first.size() == 1 ? 0 : decisions_->pick(static_cast<int>(first.size())))];
  switch (what) {
    case What::work:
      effect(which);
      break;
    case What::limit: {
      Thread& thread = s_.threads[ix(which)];
      say(who(which) + " gives up");
      thread.limit = -1;
      thread.gives_up = true;
      ready(which);
      break;
    }
    case What::near:
      s_.slots[ix(which)].near = -1;
      offer(which);
      break;
    case What::far:
      s_.slots[ix(which)].far = -1;
      offer(which);
      break;
    case What::next:
      if (std::holds_alternative<FrameDevice>(processes_[ix(which)].timing->behaviour)) {
        frame(which);
      } else {
        event(which);
      }
      break;
    case What::late:
      s_.devices[ix(which)].late = -1;
      occurs(which);
      break;
    case What::service:
      answer(which);
      break;
  }
  if (!s_.ended) dispatch();
  canonical(s_);
  return true;
}

void AllRuns::pass(int time) {
  now_ += time;
  for (Thread& thread : s_.threads) {
    if (thread.status == Status::running && thread.begun) thread.left -= time;
    if (thread.status == Status::waiting && thread.limit >= 0) thread.limit -= time;
    if (thread.age >= 0) thread.age = std::min(cap_, thread.age + time);
  }
  for (Slot& slot : s_.slots) {
    if (slot.near >= 0) slot.near -= time;
    if (slot.far >= 0) slot.far -= time;
  }
  for (Device& device : s_.devices) {
    if (device.next >= 0) device.next -= time;
    if (device.late >= 0) device.late -= time;
    if (device.service >= 0) device.service -= time;
  }
  s_.condition_age = std::min(cap_, s_.condition_age + time);
  for (int& age : s_.events) age = std::min(cap_, age + time);
}

// Threads.

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

void AllRuns::reach(int thread) {
  Thread& of = s_.threads[ix(thread)];
  of.begun = false;
  of.claim = -1;
  of.gives_up = of.withdrawn = false;
  const auto& content = node(of).content;
  if (std::holds_alternative<Fork>(content)) {
    begin_blocks(thread);
    return;
  }
  const auto* wait = std::get_if<Wait>(&content);
  if (wait == nullptr) {
    ready(thread);
    return;
  }
  for (ChannelId channel : wait->channels) {
    if (sender_process_[channel.index()] >= 0) open(sender_process_[channel.index()]);
  }
  for (std::size_t i = 0; i < wait->channels.size(); ++i) {
    const int channel = wait->channels[i].value;
    if (!available(channel, thread)) continue;
    s_.slots[ix(channel)].claimed = thread;
    of.claim = static_cast<int>(i);
    ready(thread);
    return;
  }
  if (wait->within && wait->within->count() == 0) {
    say(who(thread) + " gives up at once");
    of.gives_up = true;
    ready(thread);
    return;
  }
  release(thread);
  of.status = Status::waiting;
  of.limit = wait->within ? static_cast<int>(*wait->within / unit_) : -1;
}

void AllRuns::ready(int thread) {
  Thread& of = s_.threads[ix(thread)];
  of.begun = false;
  of.limit = -1;
  if (of.status == Status::running) return;
  of.status = Status::ready;
  s_.queues[ix(of.processor)].push_back(thread);
}

void AllRuns::unqueue(int thread) {
  for (auto& queue : s_.queues) std::erase(queue, thread);
}

void AllRuns::release(int thread) {
  Thread& of = s_.threads[ix(thread)];
  if (s_.running[ix(of.processor)] == thread) s_.running[ix(of.processor)] = -1;
  unqueue(thread);
}

void AllRuns::finished(int thread) {
  say(who(thread) + " ends");
  release(thread);
  const int parent = s_.threads[ix(thread)].parent;
  s_.threads[ix(thread)] = Thread{};
  if (parent >= 0) block_over(parent);
}

void AllRuns::begin_blocks(int thread) {
  release(thread);
  s_.threads[ix(thread)].status = Status::joining;
  const Node& fork = node(s_.threads[ix(thread)]);
  const auto [module, at] = s_.threads[ix(thread)].at.back();
  std::vector<int> blocks;
  for (std::size_t i = 0; i < fork.out.size(); ++i) {
    Thread made;
    // The block's own path: where its CONCURRENT stands, marked by -1, so that an END leads no further.
    std::vector<std::pair<int, int>> path = s_.threads[ix(thread)].at;
    path.push_back({static_cast<int>(i), -2});
    const auto [found, fresh] =
        known_threads_.try_emplace({thread, path}, static_cast<int>(known_threads_.size()));
    const int index = found->second;
    const std::string& name = network_.modules[ix(module)].threads[std::get<Fork>(fork.content).threads[i]];
    names_[index] = name;
    made.at = {{module, fork.out[i].value}};
    made.module = s_.threads[ix(thread)].module;
    made.parent = thread;
    made.age = s_.threads[ix(thread)].age;
    made.event = s_.threads[ix(thread)].event;
    std::set<int> executing;
    made.can_end = can_end(module, fork.out[i].value, executing);
    place(made, name, thread);
    made.status = Status::ready;
    if (s_.threads.size() <= ix(index)) s_.threads.resize(ix(index) + 1);
    s_.threads[ix(index)] = made;
    blocks.push_back(index);
  }
  s_.threads[ix(thread)].blocks = blocks;
  for (int block : blocks) {
    if (!s_.ended && s_.threads[ix(block)].status == Status::ready && !s_.threads[ix(block)].at.empty())
      walk_on(block);
  }
}

void AllRuns::block_over(int parent) {
  if (s_.threads[ix(parent)].status != Status::joining) return;
  const std::vector<int> blocks = s_.threads[ix(parent)].blocks;
  bool alive = false;
  bool goes_on = false;
  for (int block : blocks) {
    const Thread& of = s_.threads[ix(block)];
    if (of.status == Status::off) continue;
    alive = true;
    goes_on = goes_on || of.can_end;
  }
  if (!alive) {
    Thread& of = s_.threads[ix(parent)];
    of.status = Status::off;  // until it is ready again
    of.blocks.clear();
    if (of.cancelled) {
      stop(parent);
    } else {
      say(who(parent) + " goes on");
      proceed(parent, 0);
    }
    return;
  }
  if (goes_on || s_.threads[ix(parent)].cancelled) return;
  // All that could end have; some block has ended, so one could.
  std::vector<int> rest;
  for (int block : blocks) {
    if (s_.threads[ix(block)].status != Status::off && !s_.threads[ix(block)].cancelled)
      rest.push_back(block);
  }
  any_order(rest, [this](int block) {
    if (s_.threads[ix(block)].status != Status::off && !s_.threads[ix(block)].cancelled) cancel(block);
  });
}

void AllRuns::cancel(int thread) {
  Thread& of = s_.threads[ix(thread)];
  of.cancelled = true;
  if (of.status == Status::joining) {
    const std::vector<int> blocks = of.blocks;
    std::vector<int> rest;
    for (int block : blocks) {
      if (s_.threads[ix(block)].status != Status::off && !s_.threads[ix(block)].cancelled)
        rest.push_back(block);
    }
    any_order(rest, [this](int block) {
      if (s_.threads[ix(block)].status != Status::off && !s_.threads[ix(block)].cancelled) cancel(block);
    });
    return;
  }
  const bool finishes = of.begun && (of.status == Status::running || of.status == Status::ready);
  if (!finishes) stop(thread);
}

void AllRuns::stop(int thread) {
  say(who(thread) + " is stopped");
  release(thread);
  const Thread was = s_.threads[ix(thread)];
  s_.threads[ix(thread)].status = Status::off;
  std::vector<int> left;  // -1: the message that was its own; channels of its open requests
  const auto* wait = was.at.empty() ? nullptr : std::get_if<Wait>(&node(was).content);
  if (wait != nullptr && was.claim >= 0 && !was.withdrawn) left.push_back(-1);
  for (std::size_t c = 0; c < s_.slots.size(); ++c) {
    if (s_.slots[c].open > 0 && s_.slots[c].owner == thread) left.push_back(static_cast<int>(c));
  }
  s_.threads[ix(thread)] = Thread{};
  any_order(left, [&](int which) {
    if (which >= 0) {
      std::vector<int> freed;
      withdraw(which, freed);
      any_order(freed, [this](int channel) { emptied(channel); });
      return;
    }
    const int channel = wait->channels[ix(was.claim)].value;
    if (s_.slots[ix(channel)].claimed != thread) return;
    s_.slots[ix(channel)].claimed = -1;
    offer(channel);
  });
  if (was.parent >= 0 && !s_.ended) block_over(was.parent);
}

void AllRuns::dispatch() {
  for (std::size_t p = 0; p < environment_.processors.size(); ++p) {
    auto& queue = s_.queues[p];
    int best = -1;
    for (int thread : queue) {
      if (best < 0 || s_.threads[ix(thread)].priority > s_.threads[ix(best)].priority) best = thread;
    }
    int& running = s_.running[p];
    if (running >= 0 && best >= 0 && environment_.processors[p].preemptive &&
        s_.threads[ix(best)].priority > s_.threads[ix(running)].priority) {
      say(who(running) + " is preempted");
      s_.threads[ix(running)].status = Status::ready;
      queue.insert(queue.begin(), running);
      running = -1;
    }
    if (running < 0 && best >= 0) {
      std::erase(queue, best);
      running = best;
      s_.threads[ix(best)].status = Status::running;
    }
    if (running >= 0 && !s_.threads[ix(running)].begun) {
      Thread& of = s_.threads[ix(running)];
      of.begun = true;
      of.left = draw(cost_of(of));
      say(who(running) + " begins node " + std::to_string(of.at.back().second) + " for " +
          std::to_string(of.left));
    }
  }
}

// Statements.

void AllRuns::measure(int thread) {
  Thread& of = s_.threads[ix(thread)];
  if (wanted_.at.count(of.at.back()) == 0) return;
  if (wanted_.condition >= 0) {
    if (of.age >= 0) {
      greatest_ = std::max<std::int64_t>(greatest_, of.age);
      say("  age " + std::to_string(of.age));
    }
    return;
  }
  if (of.event < 0) return;
  const int answered = of.event;
  greatest_ = std::max<std::int64_t>(greatest_, s_.events[ix(answered)]);
  say("  response " + std::to_string(s_.events[ix(answered)]));
  if (answered > 0) s_.failed = true;
  s_.events.erase(s_.events.begin() + answered);
  const auto renumber = [answered](int& event) {
    if (event == answered) {
      event = -1;
    } else if (event > answered) {
      --event;
    }
  };
  for (Thread& each : s_.threads) renumber(each.event);
  for (Slot& each : s_.slots) {
    renumber(each.event);
    renumber(each.serving_event);
  }
}

bool AllRuns::look(int thread, int condition) {
  if (condition == wanted_.condition) s_.threads[ix(thread)].age = s_.condition_age;
  return (s_.conditions >> condition & 1U) != 0;
}

void AllRuns::mentioned(const Guard& guard, std::uint32_t& all) {
  if (guard.kind == Guard::Kind::equals) all |= 1U << guard.condition.index();
  for (const Guard& term : guard.terms) mentioned(term, all);
}

bool AllRuns::holds(const Guard& guard, std::uint32_t values) const {
  if (guard.kind == Guard::Kind::equals)
    return ((values >> guard.condition.index() & 1U) != 0) == guard.value;
  if (guard.kind == Guard::Kind::negation) return !holds(guard.terms.front(), values);
  int true_ones = 0;
  for (const Guard& term : guard.terms) true_ones += holds(term, values) ? 1 : 0;
  return guard.kind == Guard::Kind::any_of ? true_ones > 0
                                           : true_ones == static_cast<int>(guard.terms.size());
}

void AllRuns::effect(int thread) {
  Thread& of = s_.threads[ix(thread)];
  const Node& here = node(of);
  const auto& content = here.content;
  say(who(thread) + " does node " + std::to_string(of.at.back().second));
  if (const auto* wait = std::get_if<Wait>(&content)) {
    if (of.withdrawn) {
      if (of.cancelled) {
        stop(thread);
      } else {
        reach(thread);
      }
      return;
    }
    if (of.gives_up) {
      measure(thread);
      std::vector<int> freed;
      for (ChannelId channel : wait->channels) {
        if (request_of_[channel.index()] >= 0) withdraw(request_of_[channel.index()], freed);
      }
      const std::size_t branch = wait->channels.size();
      // A statement that a cancelled block finishes has its whole effect before it stops.
      const bool cancelled = of.cancelled;
      either(
          !freed.empty() && !cancelled, [&] { any_order(freed, [this](int channel) { emptied(channel); }); },
          [&] { proceed(thread, branch); });
      return;
    }
    const int channel = wait->channels[ix(of.claim)].value;
    take(channel, thread);
    const bool cancelled = of.cancelled;
    const auto branch = ix(of.claim);
    of.claim = -1;
    measure(thread);
    s_.slots[ix(channel)].full = false;
    s_.slots[ix(channel)].claimed = -1;
    either(
        !cancelled && somebody_sends(channel), [&] { emptied(channel); }, [&] { proceed(thread, branch); });
    return;
  }
  if (const auto* send = std::get_if<Send>(&content)) {
    Slot& slot = s_.slots[send->channel.index()];
    if (slot.unwanted > 0) {
      send_done(thread);
    } else if (!slot.full) {
      send_done(thread);
    } else if (of.cancelled) {
      stop(thread);
    } else {
      release(thread);
      of.status = Status::sending;
    }
    return;
  }
  if (std::holds_alternative<Complete>(content)) {
    measure(thread);
    s_.ended = true;
    return;
  }
  if (const auto* set = std::get_if<Set>(&content)) {
    const bool value = set->value ? *set->value : decisions_->pick(2) == 1;
    const std::uint32_t bit = 1U << set->condition.index();
    s_.conditions = value ? s_.conditions | bit : s_.conditions & ~bit;
    if (set->condition.value == wanted_.condition) s_.condition_age = 0;
    measure(thread);
    proceed(thread, 0);
    return;
  }
  if (const auto* read = std::get_if<Read>(&content)) {
    const std::uint32_t bit = 1U << read->condition.index();
    of.latched |= bit;
    if (look(thread, read->condition.value)) {
      of.latched_true |= bit;
    } else {
      of.latched_true &= ~bit;
    }
    measure(thread);
    proceed(thread, 0);
    return;
  }
  if (std::holds_alternative<Perform>(content)) {
    measure(thread);
    proceed(thread, 0);
    return;
  }
  // A test.
  std::vector<Guard> guards;
  const auto* until = std::get_if<Until>(&content);
  if (until != nullptr) {
    guards.push_back(*until->guard);
  } else {
    guards = std::get<Choose>(content).guards;
  }
  std::uint32_t all = 0;
  for (const Guard& guard : guards) mentioned(guard, all);
  std::uint32_t values = of.latched & of.latched_true;
  for (int condition = 0; condition < 32; ++condition) {
    if ((all >> condition & 1U) == 0 || (of.latched >> condition & 1U) != 0) continue;
    if (look(thread, condition)) values |= 1U << condition;
  }
  of.latched = of.latched_true = 0;
  measure(thread);
  for (std::size_t i = 0; i < guards.size(); ++i) {
    if (!holds(guards[i], values)) continue;
    proceed(thread, i);
    return;
  }
  if (until != nullptr) {
    proceed(thread, 1);
  } else {
    s_.ended = true;
  }
}

/// The effect is over: the thread goes on to what follows, or stops if it was cancelled.
void AllRuns::proceed(int thread, std::size_t out) {
  if (s_.ended) return;
  if (s_.threads[ix(thread)].cancelled) {
    stop(thread);
    return;
  }
  Thread& of = s_.threads[ix(thread)];
  if (std::holds_alternative<Fork>(node(of).content)) {
    of.at.back().second = node(of).mate.value;
  } else {
    leave_node(thread, out);
  }
  walk_on(thread);
}

// Messages.

bool AllRuns::available(int channel, int thread) const {
  const Slot& slot = s_.slots[ix(channel)];
  if (!slot.full || slot.claimed >= 0) return false;
  if (slot.from < 0) return true;
  return (slot.from == s_.threads[ix(thread)].processor ? slot.near : slot.far) < 0;
}

void AllRuns::put(int channel, int thread, int process, int carries) {
  Slot& slot = s_.slots[ix(channel)];
  if (process >= 0 && slot.full) {
    say(processes_[ix(process)].name + " overruns");
    if (channel == wanted_.event) s_.failed = true;
    return;
  }
  if (channel == wanted_.event) {
    if (s_.events.size() >= most_events) throw TooMuch("too many events without a response");
    s_.events.push_back(0);
    carries = static_cast<int>(s_.events.size()) - 1;
  }
  say((thread >= 0 ? who(thread) : processes_[ix(process)].name) + " puts " +
      network_.messages[network_.channels[ix(channel)].message.index()].name);
  slot.full = true;
  slot.claimed = -1;
  slot.event = carries;
  slot.near = slot.far = -1;
  slot.from = thread < 0 ? -1 : s_.threads[ix(thread)].processor;
  if (network_.channels[ix(channel)].answer.valid()) {
    ++slot.open;
    slot.owner = thread;
  }
  if (receiver_process_[ix(channel)] >= 0) return;
  if (thread < 0) return;
  const auto fly = [&](Interval latency) { return latency.worst.count() == 0 ? -1 : draw(latency); };
  slot.near = fly(environment_.latency.within_processor);
  slot.far = fly(environment_.latency.between_processors);
}

bool AllRuns::offered(int channel) const {
  for (std::size_t t = 0; t < s_.threads.size(); ++t) {
    const Thread& thread = s_.threads[t];
    if (thread.status != Status::waiting || !available(channel, static_cast<int>(t))) continue;
    for (ChannelId each : std::get<Wait>(node(thread).content).channels) {
      if (each.value == channel) return true;
    }
  }
  return false;
}

/// One of those that wait for the message, if any, stops waiting.
void AllRuns::offer(int channel) {
  std::vector<std::pair<int, int>> waiting;
  for (std::size_t t = 0; t < s_.threads.size(); ++t) {
    const Thread& thread = s_.threads[t];
    if (thread.status != Status::waiting || !available(channel, static_cast<int>(t))) continue;
    const auto& channels = std::get<Wait>(node(thread).content).channels;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      if (channels[i].value == channel) waiting.push_back({static_cast<int>(t), static_cast<int>(i)});
    }
  }
  if (waiting.empty()) return;
  const auto [thread, which] =
      waiting[ix(waiting.size() == 1 ? 0 : decisions_->pick(static_cast<int>(waiting.size())))];
  s_.slots[ix(channel)].claimed = thread;
  s_.threads[ix(thread)].claim = which;
  ready(thread);
}

bool AllRuns::somebody_sends(int channel) const {
  for (const Thread& thread : s_.threads) {
    if (thread.status == Status::sending && std::get<Send>(node(thread).content).channel.value == channel)
      return true;
  }
  return false;
}

/// The slot, empty now, is there for a sender that is blocked.
void AllRuns::emptied(int channel) {
  Slot& slot = s_.slots[ix(channel)];
  if (slot.full) return;
  slot.near = slot.far = -1;
  slot.from = -1;
  slot.event = -1;
  std::vector<int> senders;
  for (std::size_t t = 0; t < s_.threads.size(); ++t) {
    if (s_.threads[t].status == Status::sending &&
        std::get<Send>(node(s_.threads[t]).content).channel.value == channel)
      senders.push_back(static_cast<int>(t));
  }
  if (senders.empty()) return;
  send_done(senders[ix(senders.size() == 1 ? 0 : decisions_->pick(static_cast<int>(senders.size())))]);
}

/// The effect of a send, at once or of a sender that was blocked.
void AllRuns::send_done(int thread) {
  Thread& of = s_.threads[ix(thread)];
  if (of.status == Status::sending) of.status = Status::ready;  // and in no queue yet
  const int channel = std::get<Send>(node(of).content).channel.value;
  Slot& slot = s_.slots[ix(channel)];
  if (slot.unwanted > 0) {
    --slot.unwanted;
    say(who(thread) + " discards");
    measure(thread);
    proceed(thread, 0);
    if (!s_.ended && somebody_sends(channel)) emptied(channel);
    return;
  }
  put(channel, thread, -1, of.event);
  measure(thread);
  const int process = receiver_process_[ix(channel)];
  const bool cancelled = s_.threads[ix(thread)].cancelled;
  either(
      !cancelled && (process >= 0 ? somebody_sends(channel) : offered(channel)),
      [&] {
        if (process < 0) {
          offer(channel);
        } else {
          take_request(process, channel);
        }
      },
      [&] { proceed(thread, 0); });
}

void AllRuns::take(int channel, int thread) {
  Slot& slot = s_.slots[ix(channel)];
  if (thread >= 0 && slot.event >= 0) s_.threads[ix(thread)].event = slot.event;
  const int request = request_of_[ix(channel)];
  if (request < 0 || s_.slots[ix(request)].open == 0) return;
  if (--s_.slots[ix(request)].open == 0) s_.slots[ix(request)].owner = -1;
}

/// Withdraws all that is open of a request; `freed` gets the channels that are empty now.
void AllRuns::withdraw(int request, std::vector<int>& freed) {
  Slot& of = s_.slots[ix(request)];
  if (of.open == 0) return;
  const int answer = network_.channels[ix(request)].answer.value;
  int rest = of.open;
  const auto remove = [&](int channel) {
    Slot& slot = s_.slots[ix(channel)];
    say("dropped " + network_.messages[network_.channels[ix(channel)].message.index()].name);
    if (slot.claimed >= 0) s_.threads[ix(slot.claimed)].withdrawn = true;
    slot.claimed = -1;
    slot.full = false;
    freed.push_back(channel);
    --rest;
  };
  if (of.full) remove(request);
  if (rest > 0 && s_.slots[ix(answer)].full) remove(answer);
  s_.slots[ix(answer)].unwanted += rest;
  of.open = 0;
  of.owner = -1;
}

// The world.

void AllRuns::open(int process) {
  Device& device = s_.devices[ix(process)];
  const Process& of = processes_[ix(process)];
  const auto* event = of.timing == nullptr ? nullptr : std::get_if<EventDevice>(&of.timing->behaviour);
  if (event == nullptr || device.open) return;
  device.open = true;
  device.next = event->phase ? draw({*event->phase, *event->phase}) : draw({Duration(0), event->period});
}

void AllRuns::event(int process) {
  Device& device = s_.devices[ix(process)];
  const auto& event = std::get<EventDevice>(processes_[ix(process)].timing->behaviour);
  device.next =
      event.sporadic ? draw({event.period, event.period + 4 * unit_}) : draw({event.period, event.period});
  if (event.jitter.count() > 0) {
    device.late = draw({Duration(0), event.jitter});
    return;
  }
  occurs(process);
}

void AllRuns::occurs(int process) {
  const int channel = processes_[ix(process)].event;
  const bool lost = s_.slots[ix(channel)].full;
  put(channel, -1, process, -1);
  if (!lost) offer(channel);
}

void AllRuns::take_request(int process, int channel) {
  const Process& of = processes_[ix(process)];
  const bool serves = std::find(of.requests.begin(), of.requests.end(), channel) != of.requests.end();
  if (!serves) {
    take(channel, -1);
    s_.slots[ix(channel)].full = false;
    emptied(channel);
    return;
  }
  if (std::holds_alternative<RequestDevice>(of.timing->behaviour) && s_.devices[ix(process)].serving == 0)
    next_request(process);
}

/// An idle device that answers on request takes one of what waits.
void AllRuns::next_request(int process) {
  const Process& of = processes_[ix(process)];
  std::vector<int> waiting;
  for (std::size_t i = 0; i < of.requests.size(); ++i) {
    if (s_.slots[ix(of.requests[i])].full) waiting.push_back(static_cast<int>(i));
  }
  if (waiting.empty() || s_.devices[ix(process)].serving != 0) return;
  const int chosen =
      waiting[ix(waiting.size() == 1 ? 0 : decisions_->pick(static_cast<int>(waiting.size())))];
  const int channel = of.requests[ix(chosen)];
  s_.devices[ix(process)].serving = 1U << chosen;
  s_.devices[ix(process)].service = draw(std::get<RequestDevice>(of.timing->behaviour).answer);
  s_.slots[ix(channel)].serving_event = s_.slots[ix(channel)].event;
  s_.slots[ix(channel)].full = false;
  say(of.name + " takes a request");
  emptied(channel);
}

void AllRuns::frame(int process) {
  const Process& of = processes_[ix(process)];
  const auto& frames = std::get<FrameDevice>(of.timing->behaviour);
  Device& device = s_.devices[ix(process)];
  device.next = draw({frames.period, frames.period});
  std::vector<int> waiting;
  for (std::size_t i = 0; i < of.requests.size(); ++i) {
    if (s_.slots[ix(of.requests[i])].full) waiting.push_back(static_cast<int>(i));
  }
  if (waiting.empty()) return;
  device.service = draw({frames.collecting, frames.collecting});
  for (int i : waiting) {
    Slot& slot = s_.slots[ix(of.requests[ix(i)])];
    device.serving |= 1U << i;
    slot.serving_event = slot.event;
    slot.full = false;
  }
  any_order(waiting, [&](int i) { emptied(of.requests[ix(i)]); });
}

void AllRuns::answer(int process) {
  const Process& of = processes_[ix(process)];
  Device& device = s_.devices[ix(process)];
  std::vector<int> served;
  for (std::size_t i = 0; i < of.requests.size(); ++i) {
    if ((device.serving >> i & 1U) != 0) served.push_back(static_cast<int>(i));
  }
  device.service = -1;
  device.serving = 0;
  const bool on_request = std::holds_alternative<RequestDevice>(of.timing->behaviour);
  either(
      on_request,
      [&] {
        any_order(served, [&](int i) {
          Slot& request = s_.slots[ix(of.requests[ix(i)])];
          const int event = request.serving_event;
          request.serving_event = -1;
          const int channel = network_.channels[ix(of.requests[ix(i)])].answer.value;
          Slot& slot = s_.slots[ix(channel)];
          if (slot.unwanted > 0) {
            --slot.unwanted;
            return;
          }
          const bool lost = slot.full;
          put(channel, -1, process, event);
          if (!lost) offer(channel);
        });
      },
      [&] {
        if (on_request) next_request(process);
      });
}

// States.

/// What is the same in what can still happen is written in the same way.
void AllRuns::canonical(State& state) const {
  for (Thread& thread : state.threads) {
    if (thread.status == Status::off) continue;
    if (thread.status != Status::waiting) thread.limit = -1;
    if (wanted_.condition < 0) thread.age = -1;
    if (!thread.begun) thread.left = 0;
    thread.latched_true &= thread.latched;
  }
  if (wanted_.condition < 0) state.condition_age = 0;
  // Events that nobody carries are lost: how old they are does not matter, only that they came before.
  std::vector<bool> carried(state.events.size());
  const auto mark = [&](int event) {
    if (event >= 0) carried[ix(event)] = true;
  };
  for (const Thread& thread : state.threads) mark(thread.event);
  for (const Slot& slot : state.slots) {
    mark(slot.event);
    mark(slot.serving_event);
  }
  std::vector<int> kept;
  std::vector<int> number(state.events.size(), -1);
  for (std::size_t e = 0; e < state.events.size(); ++e) {
    const bool lost_before = !kept.empty() && kept.back() == cap_ + 1;
    if (!carried[e] && lost_before) continue;
    number[e] = static_cast<int>(kept.size());
    kept.push_back(carried[e] ? state.events[e] : cap_ + 1);
  }
  const auto renumber = [&](int& event) {
    if (event >= 0) event = number[ix(event)];
  };
  for (Thread& thread : state.threads) renumber(thread.event);
  for (Slot& slot : state.slots) {
    renumber(slot.event);
    renumber(slot.serving_event);
  }
  state.events = kept;
}

std::string AllRuns::key(const State& state) const {
  std::string key;
  const auto add = [&key](std::int64_t value) {
    key.push_back(static_cast<char>(value & 0xff));
    key.push_back(static_cast<char>(value >> 8 & 0xff));
  };
  for (std::size_t t = 0; t < state.threads.size(); ++t) {
    const Thread& thread = state.threads[t];
    if (thread.status == Status::off) continue;
    add(static_cast<int>(t));
    add(static_cast<int>(thread.status));
    add(static_cast<int>(thread.at.size()));
    for (const auto& [module, at] : thread.at) {
      add(module);
      add(at);
    }
    add(thread.left);
    add(thread.limit);
    add(thread.claim);
    add((thread.begun ? 1 : 0) + (thread.withdrawn ? 2 : 0) + (thread.gives_up ? 4 : 0) +
        (thread.cancelled ? 8 : 0));
    add(thread.latched);
    add(thread.latched_true);
    add(thread.age);
    add(thread.event);
  }
  add(-7);
  for (int running : state.running) add(running);
  for (const auto& queue : state.queues) {
    add(-8);
    for (int thread : queue) add(thread);
  }
  for (const Slot& slot : state.slots) {
    add(slot.full ? 1 : 0);
    add(slot.claimed);
    add(slot.from);
    add(slot.near);
    add(slot.far);
    add(slot.event);
    add(slot.open);
    add(slot.owner);
    add(slot.unwanted);
    add(slot.serving_event);
  }
  for (const Device& device : state.devices) {
    add(device.open ? 1 : 0);
    add(device.next);
    add(device.late);
    add(device.service);
    add(device.serving);
  }
  add(state.conditions);
  add(state.condition_age);
  for (int age : state.events) add(age);
  return key;
}

Seen AllRuns::enumerate(std::size_t most) {
  Seen seen;
  greatest_ = -1;
  struct Arrival {
    std::size_t from;
    std::vector<int> decided;
  };
  std::unordered_set<std::string> known;
  std::vector<Arrival> arrivals;
  std::deque<std::pair<State, std::size_t>> todo;
  std::optional<Arrival> best;  // of what was measured last as the greatest, or failed
  constexpr std::size_t start = static_cast<std::size_t>(-1);
  std::int64_t before = -1;
  const auto arrived = [&](std::size_t from, const Every& every) {
    if ((s_.failed && !seen.failed) || (greatest_ > before && !seen.failed))
      best = Arrival{from, every.decided()};
    before = greatest_;
    seen.failed = seen.failed || s_.failed;
    if (s_.ended || s_.failed || !known.insert(key(s_)).second) return;
    arrivals.push_back({from, every.decided()});
    todo.emplace_back(s_, arrivals.size() - 1);
  };
  try {
    Every every;
    decisions_ = &every;
    do {
      begin();
      arrived(start, every);
    } while (every.next());
    while (!todo.empty() && known.size() <= most) {
      const auto [from, index] = std::move(todo.front());
      todo.pop_front();
      Every each;
      decisions_ = &each;
      do {
        s_ = from;
        if (!step()) break;
        arrived(index, each);
      } while (each.next());
    }
    seen.complete = todo.empty() && !sporadic();
  } catch (const TooMuch&) {
    seen.complete = false;
  }
  seen.greatest = greatest_;
  seen.states = known.size();
  if (!best || !tell) return seen;
  std::vector<std::vector<int>> path{best->decided};
  for (std::size_t at = best->from; at != start; at = arrivals[at].from) path.push_back(arrivals[at].decided);
  story.clear();
  telling_ = true;
  for (std::size_t i = path.size(); i-- > 0;) {
    Again again(path[i]);
    decisions_ = &again;
    if (i + 1 == path.size()) {
      begin();
    } else {
      step();
    }
  }
  telling_ = false;
  return seen;
}

/// Whether a device may wait for ever: then not all runs can be tried.
bool AllRuns::sporadic() const {
  for (const DeviceTiming& timing : environment_.devices) {
    const auto* event = std::get_if<EventDevice>(&timing.behaviour);
    if (event != nullptr && event->sporadic) return true;
  }
  return false;
}

Seen AllRuns::walk(Decisions& decisions, int things) {
  Seen seen;
  greatest_ = -1;
  decisions_ = &decisions;
  telling_ = tell;
  try {
    begin();
    for (int i = 0; i < things && step(); ++i) {
    }
  } catch (const TooMuch&) {
  }
  seen.failed = s_.failed;
  seen.greatest = greatest_;
  return seen;
}

}  // namespace pal::test
