#include "analyzer/problem/problem.hpp"

#include <algorithm>

#include "analyzer/problem/flow.hpp"
#include "analyzer/problem/problem_builder.hpp"
#include "pal/pan/threads.hpp"
#include "pal/pan/times.hpp"
#include "pal/support/finding.hpp"
#include "pal/support/nearest.hpp"

namespace pal::analyzer {

using namespace pan;

namespace {

constexpr int most_threads = 20'000;
constexpr int most_conditions = 64;
constexpr int most_channels = 40'000;
constexpr int most_explored_threads = 100;
constexpr int most_explored_channels = 120;
constexpr int most_simulated_threads = 2'000;
constexpr int most_simulated_channels = 4'000;
constexpr std::size_t most_requests = 128;  // of a device
constexpr ProcessorId first_processor(0);

const std::string& party(const Problem& problem, DeviceId device, ModuleId module) {
  return device.valid() ? problem.devices[device].name : problem.module_names[module];
}

}  // namespace

Limit Requirement::allowed() const {
  return {at_least ? Limit::Sense::at_least : Limit::Sense::at_most, {unit_of(measure), limit}};
}

Figure::Unit unit_of(Requirement::Measure measure) {
  using Measure = Requirement::Measure;
  return measure == Measure::load   ? Figure::Unit::share
         : measure == Measure::loss ? Figure::Unit::count
                                    : Figure::Unit::time;
}

bool Requirement::is_event(ChannelId channel) const {
  return std::find(events.begin(), events.end(), channel) != events.end();
}

const std::string& sender_name(const Problem& problem, ChannelId channel) {
  const Channel& of = problem.channels[channel];
  return party(problem, of.sender_device, of.sender_module);
}

const std::string& receiver_name(const Problem& problem, ChannelId channel) {
  const Channel& of = problem.channels[channel];
  return party(problem, of.receiver_device, of.receiver_module);
}

bool is_in(const Problem& problem, StepId step, LoopId loop) {
  const ProgramLoop& of = problem.loops[loop];
  const auto within = [&of](ModuleId module, NodeId node) {
    return module == of.module && node > of.repeat && node <= of.until;
  };
  const Step& at = problem.steps[step];
  if (!at.statement.valid()) return false;
  const Statement& statement = problem.statements[at.statement];
  if (within(statement.source_module, statement.source_node)) return true;
  for (CallId c = at.call; c.valid(); c = problem.calls[c].outer) {
    if (within(problem.calls[c].source_module, problem.calls[c].source_node)) return true;
  }
  return false;
}

LoopId innermost_loop(const Problem& problem, StepId step) {
  const Step& at = problem.steps[step];
  if (!at.statement.valid()) return {};
  const auto around = [&problem](ModuleId module, NodeId node) {
    LoopId innermost;
    for (const LoopId l : problem.loops.ids()) {
      const ProgramLoop& loop = problem.loops[l];
      // Of the loops around a statement the one that begins last is the innermost.
      if (module == loop.module && node > loop.repeat && node <= loop.until) innermost = l;
    }
    return innermost;
  };
  const Statement& statement = problem.statements[at.statement];
  LoopId found = around(statement.source_module, statement.source_node);
  for (CallId c = at.call; c.valid() && !found.valid(); c = problem.calls[c].outer)
    found = around(problem.calls[c].source_module, problem.calls[c].source_node);
  return found;
}

std::optional<Problem> ProblemBuilder::build() {
  const std::size_t before = diagnostics_.errors();
  problem_.skill = network_.skill.name;
  problem_.environment = environment_.name;
  const std::vector<Completion>& completions = network_.skill.completions;
  const auto error = std::find_if(completions.begin(), completions.end(), [](const Completion& completion) {
    return completion.kind == Completion::Kind::error;
  });
  if (error != completions.end()) problem_.error_code = error->code;
  for (const Condition& condition : network_.conditions) problem_.conditions.push_back(condition.name);
  for (const Module& module : network_.modules) problem_.module_names.push_back(module.name);
  processors();
  known_names();
  loops();
  common_times();
  channels();
  devices();
  compile(network_, *this, sources_, diagnostics_, problem_);
  latencies();
  requirements();
  limits();
  if (diagnostics_.errors() != before) return std::nullopt;
  endless_waits();
  overload();
  return std::move(problem_);
}

void ProblemBuilder::loops() {
  for (std::size_t m = 0; m < network_.modules.size(); ++m) {
    const std::vector<Node>& nodes = network_.modules[m].body.nodes;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (!std::holds_alternative<pan::Loop>(nodes[n].content)) continue;
      ProgramLoop made{ModuleId(m), NodeId(n), nodes[n].mate, {}, 0, nodes[n].where};
      if (sources_ != nullptr && made.where.valid()) {
        made.file = sources_->name(made.where.file);
        made.line = sources_->line_column(made.where.file, made.where.begin).line;
      }
      problem_.loops.push_back(std::move(made));
    }
  }
}

Range ProblemBuilder::activity(const Activity& activity) {
  const std::string& module = network_.modules[activity.module.index()].name;
  auto found = times_.find({activity.name, module});
  if (found == times_.end()) found = times_.find({activity.name, ""});
  if (found != times_.end()) return {found->second->time.best.count(), found->second->time.worst.count()};
  if (untimed_.insert(activity.name + " OF " + module).second) {
    auto& finding = diagnostics_.report(Finding::activity_without_time, environment_.where, environment_.name,
                                        activity.name, module);
    finding.note(activity.where, Remark::the_activity);
    const auto is_of_another = [&](const ActivityTime& time) {
      return std::none_of(network_.activities.begin(), network_.activities.end(),
                          [&](const Activity& known) { return known.name == time.activity; });
    };
    for (const ActivityTime& time : environment_.activities) {
      if (is_of_another(time) && nearest(activity.name, {time.activity}))
        finding.note(time.where, Remark::meant_here, activity.name);
    }
  }
  return {};
}

const Placement* ProblemBuilder::placement_of(std::string thread) const {
  for (;;) {
    const auto found = placements_.find(thread);
    if (found != placements_.end()) return found->second;
    const auto slash = thread.find('/');
    if (slash == std::string::npos) return nullptr;
    thread.erase(0, slash + 1);
  }
}

void ProblemBuilder::place(Thread& thread, ThreadId runner) {
  const Placement* placement = placement_of(thread.name);
  if (placement == nullptr && runner.valid()) {
    const Thread& where = problem_.threads[runner];
    thread.processor = where.processor;
    thread.priority = where.priority;
    return;
  }
  if (placement == nullptr) {
    auto& finding =
        diagnostics_.report(Finding::thread_not_placed, environment_.where, environment_.name, thread.name);
    const auto is_other_module = [&](const Placement& placed) {
      return std::none_of(network_.modules.begin(), network_.modules.end(), [&](const Module& module) {
        return module.name == module_of_thread(placed.thread);
      });
    };
    for (const Placement& other : environment_.placements) {
      if (is_other_module(other) && nearest(thread.name, {other.thread}))
        finding.note(other.where, Remark::meant_here, thread.name);
    }
    thread.processor = first_processor;
    return;
  }
  const auto processor = processor_.find(placement->processor);
  thread.processor = processor == processor_.end() ? first_processor : processor->second;
  thread.priority = placement->priority;
}

void ProblemBuilder::processors() {
  for (const Processor& processor : environment_.processors) {
    const bool added = processor_.emplace(processor.name, ProcessorId(problem_.processors.size())).second;
    if (!added) {
      diagnostics_.report(Finding::item_given_twice, processor.where, "processor " + processor.name);
      continue;
    }
    problem_.processors.push_back(processor);
  }
  if (problem_.processors.empty()) {
    diagnostics_.report(Finding::environment_without_processor, environment_.where, environment_.name);
  }
}

/// An environment serves several skills, so it may name modules, devices and activities that this one lacks.
/// What this one needs and misses is found where it is needed. Nothing may be said twice.
void ProblemBuilder::known_names() {
  std::set<std::string> threads;
  for (const SkillThread& thread : threads_of(network_, most_threads)) {
    threads.insert(thread.name);
    // A block may be placed by the end of its name.
    for (auto slash = thread.name.find('/'); slash != std::string::npos;
         slash = thread.name.find('/', slash + 1)) {
      threads.insert(thread.name.substr(slash + 1));
    }
  }
  std::set<std::string> modules;
  for (const Module& module : network_.modules) {
    if (module.body.empty()) continue;
    modules.insert(module.name);
    if (module.executed_by.valid()) executed_.insert(module.name);
  }
  std::set<std::string> placed;
  for (const Placement& placement : environment_.placements) {
    if (!processor_.contains(placement.processor)) {
      diagnostics_.report(Finding::unknown_processor, placement.where, placement.processor);
    }
    if (!placed.insert(placement.thread).second) {
      diagnostics_.report(Finding::item_given_twice, placement.where, "the place of " + placement.thread);
    }
    if (executed_.contains(placement.thread)) {
      // No edit: for another skill in this environment it may be one.
      diagnostics_.report(Finding::placed_no_thread, placement.where, placement.thread);
    } else if (modules.contains(module_of_thread(placement.thread)) && !threads.contains(placement.thread)) {
      const bool within = placement.thread.find('/') != std::string::npos;
      diagnostics_.report(either<Finding::no_such_block_within, Finding::no_such_block>(within),
                          placement.where, network_.skill.name, placement.thread);
    }
  }
  std::set<std::pair<std::string, std::string>> timed;
  for (const ActivityTime& time : environment_.activities) {
    if (!timed.insert({time.activity, time.module}).second) {
      diagnostics_.report(Finding::item_given_twice, time.where, "the time of " + time.activity);
    }
    interval(time.time, time.where, "activity " + time.activity);
  }
}

void ProblemBuilder::time(Duration value, SourceSpan where, const std::string& what, bool positive) {
  if (value.count() < 0) {
    diagnostics_.report(Finding::time_negative, where, what);
  } else if (positive && value.count() == 0) {
    diagnostics_.report(Finding::time_zero, where, what);
  } else if (value.count() > longest_time) {
    diagnostics_.report(Finding::time_too_long, where, what);
  }
}

void ProblemBuilder::interval(const Interval& value, SourceSpan where, const std::string& what) {
  time(value.best, where, what);
  time(value.worst, where, what);
  if (value.best > value.worst) {
    diagnostics_.report(Finding::best_longer_than_worst, where, what);
  }
}

void ProblemBuilder::common_times() {
  const Costs& costs = environment_.costs;
  interval(costs.send, environment_.where, "a send");
  interval(costs.receive, environment_.where, "a receive");
  interval(costs.set, environment_.where, "a set");
  interval(costs.read, environment_.where, "a read");
  interval(costs.test, environment_.where, "a test");
  interval(environment_.latency.within_processor, environment_.where, "a message within a processor");
  interval(environment_.latency.between_processors, environment_.where, "a message between processors");
  for (const Module& module : network_.modules) {
    for (const Node& node : module.body.nodes) {
      const auto* wait = std::get_if<Wait>(&node.content);
      if (wait != nullptr && wait->within) time(*wait->within, node.where, "this wait");
    }
  }
}

void ProblemBuilder::channels() {
  for (const pan::Channel& channel : network_.channels) {
    Channel made;
    made.sender_device = device_of(network_, channel.sender);
    made.receiver_device = device_of(network_, channel.receiver);
    if (!made.sender_device.valid()) made.sender_module = std::get<ModuleId>(channel.sender);
    if (!made.receiver_device.valid()) {
      made.receiver_module = std::get<ModuleId>(channel.receiver);
    }
    if (channel.answer.valid()) made.answer = channel.answer;
    made.message = network_.messages[channel.message.index()].name;
    problem_.channels.push_back(std::move(made));
  }
  for (const ChannelId c : problem_.channels.ids()) {
    const ChannelId answer = problem_.channels[c].answer;
    if (answer.valid()) problem_.channels[answer].answers = c;
  }
}

void ProblemBuilder::latencies() {
  const Interval& within = environment_.latency.within_processor;
  const Interval& between = environment_.latency.between_processors;
  problem_.within_processor = {within.best.count(), within.worst.count()};
  problem_.between_processors = {between.best.count(), between.worst.count()};
  const Table<ChannelId, std::set<ProcessorId>> takers_of = takers();
  for (const ChannelId c : problem_.channels.ids()) {
    const std::set<ProcessorId>& processors = takers_of[c];
    problem_.channels[c].receiver_processors.assign(processors.begin(), processors.end());
  }
}

Table<ChannelId, std::set<ProcessorId>> ProblemBuilder::takers() const {
  Table<ChannelId, std::set<ProcessorId>> found(problem_.channels.size());
  for (const Thread& thread : problem_.threads) {
    for (const StepId s : steps_of(problem_, thread)) {
      const Step& step = problem_.steps[s];
      if (step.kind != Step::Kind::wait) continue;
      for (ChannelId c : step.channels) found[c].insert(thread.processor);
    }
  }
  return found;
}

void ProblemBuilder::limits() {
  const bool fits = static_cast<int>(problem_.threads.size()) <= most_threads &&
                    static_cast<int>(problem_.conditions.size()) <= most_conditions &&
                    static_cast<int>(problem_.channels.size()) <= most_channels &&
                    problem_.steps.size() < most_steps;
  if (!fits) {
    diagnostics_.report(Finding::skill_too_large, network_.skill.where, network_.skill.name);
  }
}

std::optional<Problem> make_problem(const Network& network, const Environment& environment,
                                    Diagnostics& diagnostics, const SourceManager* sources) {
  const Environment whole = with_times_of(network, environment);
  return ProblemBuilder(network, whole, diagnostics, sources).build();
}

bool fits_exploration(const Problem& problem) {
  return static_cast<int>(problem.threads.size()) <= most_explored_threads &&
         static_cast<int>(problem.channels.size()) <= most_explored_channels;
}

bool fits_simulation(const Problem& problem) {
  return static_cast<int>(problem.threads.size()) <= most_simulated_threads &&
         static_cast<int>(problem.channels.size()) <= most_simulated_channels &&
         std::all_of(problem.devices.begin(), problem.devices.end(),
                     [](const Device& device) { return device.requests.size() <= most_requests; });
}

}  // namespace pal::analyzer
