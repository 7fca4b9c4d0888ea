#include "analyzer/compositional/demand.hpp"

#include <algorithm>

#include "analyzer/compositional/precedence.hpp"

namespace pal::analyzer::compositional {
namespace {

constexpr int most_rounds = 1'000;

std::vector<bool> preemptive(const Problem& problem) {
  std::vector<bool> all;
  for (const pan::Processor& processor : problem.processors) all.push_back(processor.preemptive);
  return all;
}

}  // namespace

Demand::Demand(const Ground& ground, const std::vector<NodeTimes>& nodes)
    : ground_(ground),
      windows_(preemptive(ground.problem)),
      task_(nodes.size()),
      threads_on_(ground.problem.processors.size()),
      burst_(ground.problem.threads.size()) {
  std::vector<Transaction> transactions(ground.forest.sources.size());
  for (std::size_t s = 0; s < transactions.size(); ++s)
    transactions[s].period = ground.forest.sources[s].period;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int n = static_cast<int>(i);
    const Thread& thread = ground.thread_of(n);
    auto& tasks = transactions[static_cast<std::size_t>(ground.node(n).source)].tasks;
    task_[i] = static_cast<int>(tasks.size());
    tasks.push_back({thread.processor,
                     thread.priority,
                     ground.segment(n).worst,
                     nodes[i].earliest,
                     0,
                     {},
                     {},
                     ground.forest.thread_of(n)});
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) precede(ground, static_cast<int>(n), transactions);
  const std::vector<std::vector<int>> later = come_later(ground);
  for (std::size_t n = 0; n < nodes.size(); ++n) exclude(static_cast<int>(n), later[n], transactions);
  for (Transaction& transaction : transactions) windows_.add(std::move(transaction));
  for (std::size_t t = 0; t < ground.problem.threads.size(); ++t)
    threads_on_[static_cast<std::size_t>(ground.problem.threads[t].processor)].push_back(static_cast<int>(t));
}

/// Enters the node with the causes on its processor that are done before it begins.
void Demand::precede(const Ground& ground, int node, std::vector<Transaction>& transactions) const {
  Transaction& of = transactions[static_cast<std::size_t>(ground.node(node).source)];
  if (of.period == never) return;
  const int task = task_[static_cast<std::size_t>(node)];
  const Task& self = of.tasks[static_cast<std::size_t>(task)];
  for (int at = node; ground.node(at).cause >= 0; at = ground.node(at).cause) {
    const int cause = task_[static_cast<std::size_t>(ground.node(at).cause)];
    Task& before = of.tasks[static_cast<std::size_t>(cause)];
    if (before.processor != self.processor || before.priority > self.priority) continue;
    if (ends_with_cause(ground, at)) before.followers.push_back(task);
  }
}

/// Enters with the node what cannot delay it.
void Demand::exclude(int node, const std::vector<int>& later, std::vector<Transaction>& transactions) const {
  const auto task_of = [&](int n) -> Task& {
    return transactions[static_cast<std::size_t>(ground_.node(n).source)]
        .tasks[static_cast<std::size_t>(task_[static_cast<std::size_t>(n)])];
  };
  Task& self = task_of(node);
  for (int other : later) {
    if (task_of(other).processor == self.processor)
      self.later.emplace_back(ground_.node(other).source, task_[static_cast<std::size_t>(other)]);
  }
  std::sort(self.later.begin(), self.later.end());
}

Nanoseconds Demand::greatest_jitter(int node) const {
  const Source& of = ground_.source(node);
  if (of.period == never) return never;
  return of.jitter + (2 * ground_.node(node).depth + 2) * of.period;
}

void Demand::announce(int node, const NodeTimes& times) {
  const Nanoseconds jitter = times.latest >= never ? never : times.latest - times.earliest;
  windows_.set_jitter(ground_.node(node).source, task_[static_cast<std::size_t>(node)],
                      std::min(jitter, greatest_jitter(node)));
}

void Demand::find_bursts(const std::vector<NodeTimes>& nodes, const std::vector<bool>& home_again) {
  burst_.assign(ground_.problem.threads.size(), 0);
  for (std::size_t t = 0; t < burst_.size(); ++t) {
    const int processor = ground_.problem.threads[t].processor;
    if (!ground_.problem.processors[static_cast<std::size_t>(processor)].preemptive)
      burst_[t] = burst(static_cast<int>(t), nodes, home_again[t]);
  }
}

/// A thread goes on without a pause as long as it finds messages.
Nanoseconds Demand::burst(int thread, const std::vector<NodeTimes>& nodes, bool home_again) const {
  const ThreadConduct& of = ground_.conduct_of(thread);
  Nanoseconds once = 0;
  Nanoseconds late = 0;
  for (int n : of.nodes) {
    const NodeTimes& times = nodes[static_cast<std::size_t>(n)];
    once += ground_.segment(n).worst;
    late = std::max(late, times.finish >= never ? never : times.finish - times.earliest);
  }
  if (once == 0 || home_again) return once;
  Nanoseconds length = once;
  for (int round = 0; round < most_rounds; ++round) {
    Nanoseconds next = 0;
    for (int n : of.nodes) {
      const Transaction& transaction = windows_.transaction(ground_.node(n).source);
      const Task& task = transaction.tasks[static_cast<std::size_t>(task_[static_cast<std::size_t>(n)])];
      const Nanoseconds count = BusyWindows::releases(transaction, task, plus(length, late));
      if (ground_.segment(n).worst > 0 && count >= never) return never;
      next += count * ground_.segment(n).worst;
    }
    if (next <= length) return length;
    length = next;
  }
  return never;
}

int Demand::blocking_thread(int node) const {
  const Thread& mine = ground_.thread_of(node);
  if (ground_.problem.processors[static_cast<std::size_t>(mine.processor)].preemptive) return -1;
  int longest = -1;
  for (int t : threads_on_[static_cast<std::size_t>(mine.processor)]) {
    if (ground_.thread_at(t).priority >= mine.priority) continue;
    if (longest < 0 || burst_[static_cast<std::size_t>(t)] > burst_[static_cast<std::size_t>(longest)])
      longest = t;
  }
  return longest;
}

Nanoseconds Demand::blocking(int node) const {
  const int thread = blocking_thread(node);
  return thread < 0 ? 0 : burst_[static_cast<std::size_t>(thread)];
}

Nanoseconds Demand::finish(int node, Nanoseconds part, Nanoseconds blocking) const {
  return windows_.finish(ground_.node(node).source, task_[static_cast<std::size_t>(node)], part, blocking);
}

Account Demand::account(int node, Nanoseconds part) const {
  return windows_.account(ground_.node(node).source, task_[static_cast<std::size_t>(node)], part,
                          blocking(node));
}

int Demand::node_of(int transaction, int task) const {
  for (std::size_t n = 0; n < task_.size(); ++n) {
    if (ground_.node(static_cast<int>(n)).source == transaction && task_[n] == task)
      return static_cast<int>(n);
  }
  return -1;
}

Nanoseconds stops_within(const Problem& problem, const BusyWindows& windows, int block) {
  const Thread& of = problem.threads[static_cast<std::size_t>(block)];
  Nanoseconds longest = windows.level(of.processor, of.priority);
  for (std::size_t t = 0; t < problem.threads.size(); ++t) {
    if (problem.threads[t].parent == block)
      longest = std::max(longest, stops_within(problem, windows, static_cast<int>(t)));
  }
  return longest;
}

}  // namespace pal::analyzer::compositional
