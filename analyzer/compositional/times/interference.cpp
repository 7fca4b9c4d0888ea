#include "analyzer/compositional/times/interference.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "analyzer/compositional/causes/job_distance.hpp"

namespace pal::analyzer::compositional {
namespace {

constexpr int most_window_steps = 1'000;

std::vector<bool> preemptive(const Problem& problem) {
  std::vector<bool> all;
  for (const pan::Processor& processor : problem.processors) all.push_back(processor.preemptive);
  return all;
}

}  // namespace

Interference::Interference(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes,
                           const std::function<bool()>& stop, WindowEnds ends)
    : context_(context),
      windows_(preemptive(context.problem), stop, ends),
      task_(nodes.size()),
      nodes_of_(context.forest.sources.size()),
      threads_on_(context.problem.processors.size()),
      burst_(context.problem.threads.size()),
      order_(std::make_shared<const Order>(order_of(context, stop))),
      excluded_(context, order_, stop),
      since_cause_(context, order_) {
  Table<SourceId, Transaction> transactions(context.forest.sources.size());
  for (const SourceId s : transactions.ids()) {
    transactions[s].period = context.forest.sources[s].period;
    transactions[s].regular = context.forest.sources[s].regular;
  }
  for (const NodeId n : nodes.ids()) {
    const Thread& thread = context.thread_of(n);
    auto& tasks = transactions[context.node(n).source].tasks;
    task_[n] = TaskId(tasks.size());
    nodes_of_[transaction_of(n)].push_back(n);
    tasks.push_back({thread.processor, thread.priority, context.segment(n).worst, nodes[n].earliest, 0});
  }
  for (const NodeId n : nodes.ids()) precede(context, n, transactions);
  for (const std::vector<NodeId>& alternatives : context.behaviours.alternatives) {
    std::vector<TaskId> tasks;
    for (NodeId n : alternatives) tasks.push_back(task_[n]);
    const SourceId source = context.node(alternatives.front()).source;
    transactions[source].exclude(std::move(tasks), piled_up(alternatives));
  }
  for (Transaction& transaction : transactions) windows_.add(std::move(transaction));
  for (const ThreadId t : context.problem.threads.ids())
    threads_on_[context.problem.threads[t].processor].push_back(t);
  for (const ThreadId t : context.problem.threads.ids()) pauses_.push_back(pauses(t));
}

/// A thread that asks for what begins its next job may find it there when it returns to its idle wait, and go
/// on.
bool Interference::pauses(ThreadId thread) const {
  const Thread& of = context_.thread_at(thread);
  if (context_.problem.processors[of.processor].preemptive) return true;
  Table<StepId, bool> owned;
  for (NodeId n : context_.behaviour_of(thread).job_starts) {
    const Source& source = context_.source(n);
    if (source.kind != Source::Kind::loop || source.thread != thread || context_.node(n).cause.valid())
      continue;
    owned.resize(context_.problem.steps.size());
    for (const StepId s : owned.ids()) owned[s] = context_.forest.segments.owner(s) == thread;
    if (!waits_between_jobs(context_.problem, context_.segment(n).beginning, owned)) return false;
  }
  return true;
}

/// Enters the node with the causes on its processor that are done before it begins.
void Interference::precede(const AnalysisContext& context, NodeId node,
                           Table<SourceId, Transaction>& transactions) const {
  Transaction& of = transactions[context.node(node).source];
  if (of.period == never) return;
  const TaskId task = task_[node];
  const Task& self = of.tasks[task];
  for (NodeId at = node; context.node(at).cause.valid(); at = context.node(at).cause) {
    const TaskId cause = task_[context.node(at).cause];
    Task& before = of.tasks[cause];
    if (before.processor != self.processor || before.priority > self.priority) continue;
    if (ends_with_cause(context.problem, context.forest, at)) before.followers.push_back(task);
  }
}

void Interference::exclude(NodeId node, bool done_before_next, bool in_turn) {
  const std::vector<NodeId> excluded = excluded_.of(node, done_before_next, in_turn);
  std::vector<std::pair<TransactionId, TaskId>> without;
  for (const NodeId other : excluded) without.emplace_back(transaction_of(other), task_[other]);
  std::sort(without.begin(), without.end());
  windows_.set_without(transaction_of(node), task_[node], std::move(without));
  if (context_.source(node).period == never) separate(node, {excluded.begin(), excluded.end()});
}

/// What comes of the same cause as a node that comes once may come too late to delay it.
void Interference::separate(NodeId node, const std::set<NodeId>& excluded) {
  const Thread& mine = context_.thread_of(node);
  std::vector<Separation> separations;
  for (const NodeId other : excluded_.nodes_on(mine.processor)) {
    if (context_.node(other).source != context_.node(node).source || context_.segment(other).worst == 0)
      continue;
    if (other == node || context_.thread_of(other).priority < mine.priority || excluded.contains(other))
      continue;
    const NodeId cause = since_cause_.common(node, other);
    if (!cause.valid() || cause == other || !since_cause_.counts_from(cause, node)) continue;
    separations.push_back({task_[other], task_[cause], since_cause_.least(cause, other)});
  }
  // Tasks have the order of their nodes.
  windows_.set_separations(transaction_of(node), task_[node], std::move(separations));
}

void Interference::find_order(const Table<ThreadId, bool>& done_before_next,
                              const Table<SourceId, bool>& in_turn, const std::function<bool()>& stop) {
  for (const NodeId n : task_.ids()) {
    if (stop && stop()) return;
    const ThreadId thread = context_.forest.thread_of(n);
    const SourceId source = context_.node(n).source;
    const bool known = !done_before_next_.empty() && done_before_next_[thread] == done_before_next[thread] &&
                       in_turn_[source] == in_turn[source];
    if (!known) exclude(n, done_before_next[thread], in_turn[source]);
  }
  done_before_next_ = done_before_next;
  in_turn_ = in_turn;
}

Nanoseconds Interference::greatest_jitter(NodeId node) const {
  const Source& of = context_.source(node);
  if (of.period == never) return never;
  return plus(of.jitter, work_of(2 * context_.node(node).depth + 2, of.period));
}

Nanoseconds Interference::piled_up(const std::vector<NodeId>& alternatives) const {
  const Source& of = context_.source(alternatives.front());
  if (of.period == never) return never;
  std::set<ThreadId> threads;
  std::set<ChannelId> slots;  // by channel
  std::set<ChannelId> asked;  // by channel: a device may be serving its request
  for (NodeId n : alternatives) {
    for (NodeId at = n; at.valid(); at = context_.node(at).cause) {
      threads.insert(context_.forest.thread_of(at));
      if (context_.node(at).release != Node::Release::message) continue;
      const ChannelId channel = context_.sent_channel(at);
      slots.insert(channel);
      if (!context_.node(at).device.valid()) continue;
      asked.insert(channel);
      slots.insert(context_.problem.channels[channel].answer);
    }
  }
  // And the slot of the event, or of the message, that begins the occurrence.
  const auto places = static_cast<Nanoseconds>(threads.size() + slots.size() + asked.size() + 1);
  return plus(of.jitter, work_of(places, of.period));
}

void Interference::announce(NodeId node, const NodeTimes& times) {
  const Nanoseconds jitter = times.latest >= never ? never : times.latest - times.earliest;
  windows_.set_jitter(transaction_of(node), task_[node], jitter, greatest_jitter(node));
}

/// A thread that was blocked in a send may find an earlier answer when it returns to its idle wait. Then it
/// goes on for one job more.
void Interference::find_bursts(const Table<NodeId, NodeTimes>& nodes,
                               const Table<ThreadId, bool>& done_before_next,
                               const Table<ThreadId, bool>& blocked) {
  burst_.assign(context_.problem.threads.size(), 0);
  for (const ThreadId t : burst_.ids()) {
    const ProcessorId processor = context_.problem.threads[t].processor;
    if (context_.problem.processors[processor].preemptive) continue;
    const Nanoseconds found = burst(t, nodes, done_before_next[t] && pauses_[t]);
    burst_[t] = blocked[t] ? plus(found, found) : found;
  }
}

/// Work of a thread, if `jobs_of` says of a transaction how often what it releases with a jitter comes.
template <class JobsOf>
Nanoseconds Interference::work_of_thread(ThreadId thread, const JobsOf& jobs_of) const {
  std::map<TransactionId, Tally> tallies;  // by transaction
  for (NodeId n : context_.behaviour_of(thread).nodes) {
    if (context_.segment(n).worst == 0) continue;
    const TransactionId transaction = transaction_of(n);
    const Transaction& of = windows_.transaction(transaction);
    const TaskId task = task_[n];
    tallies.try_emplace(transaction, of, transaction, nullptr)
        .first->second.add(task, jobs_of(of, of.tasks[task].jitter));
  }
  Nanoseconds work = 0;
  for (auto& [transaction, tally] : tallies) {
    const Transaction& of = windows_.transaction(transaction);
    work = plus(work, tally.total([&](const Alternatives& all) { return jobs_of(of, all.jitter); }));
  }
  return work;
}

/// A thread goes on without a pause as long as it finds messages.
Nanoseconds Interference::burst(ThreadId thread, const Table<NodeId, NodeTimes>& nodes,
                                bool done_before_next) const {
  const Nanoseconds once =
      work_of_thread(thread, [](const Transaction&, Nanoseconds) { return Nanoseconds{1}; });
  if (once == 0 || done_before_next) return once;
  Nanoseconds late = 0;
  for (NodeId n : context_.behaviour_of(thread).nodes) {
    const NodeTimes& times = nodes[n];
    late = std::max(late, times.finish >= never ? never : times.finish - times.earliest);
  }
  Nanoseconds length = once;
  for (int iteration = 0; iteration < most_window_steps; ++iteration) {
    const Nanoseconds next = work_of_thread(thread, [&](const Transaction& of, Nanoseconds jitter) {
      return releases(of.period, jitter, plus(length, late));
    });
    if (next <= length) return length;
    length = next;
  }
  return never;
}

ThreadId Interference::blocking_thread(NodeId node) const {
  const Thread& mine = context_.thread_of(node);
  if (context_.problem.processors[mine.processor].preemptive) return ThreadId{};
  ThreadId longest{};
  for (ThreadId t : threads_on_[mine.processor]) {
    if (context_.thread_at(t).priority >= mine.priority) continue;
    if (!longest.valid() || burst_[t] > burst_[longest]) longest = t;
  }
  return longest;
}

Nanoseconds Interference::blocking(NodeId node) const {
  const ThreadId thread = blocking_thread(node);
  return !thread.valid() ? 0 : burst_[thread];
}

Nanoseconds Interference::finish(NodeId node, Nanoseconds part, Nanoseconds blocking, Since since) const {
  return windows_.finish(transaction_of(node), task_[node], part, blocking, since);
}

std::vector<Nanoseconds> Interference::finishes(NodeId node, const std::vector<Nanoseconds>& parts,
                                                Nanoseconds blocking) const {
  return windows_.finishes(transaction_of(node), task_[node], parts, blocking);
}

FinishBreakdown Interference::breakdown(NodeId node, Nanoseconds part, Since since) const {
  return windows_.breakdown(transaction_of(node), task_[node], part, blocking(node), since);
}

std::vector<TaskId> Interference::tasks_of(const std::vector<NodeId>& nodes) const {
  std::vector<TaskId> tasks;
  for (NodeId n : nodes) tasks.push_back(task_[n]);
  return tasks;
}

Nanoseconds Interference::joint_finish(const std::vector<NodeId>& chain, Nanoseconds part) const {
  return windows_.joint_finish(transaction_of(chain.front()), tasks_of(chain), part);
}

std::vector<Share> Interference::joint_breakdown(const std::vector<NodeId>& chain, Nanoseconds part) const {
  return windows_.joint_breakdown(transaction_of(chain.front()), tasks_of(chain), part);
}

Nanoseconds stops_within(const Problem& problem, const BusyWindows& windows, ThreadId block) {
  const Thread& of = problem.threads[block];
  Nanoseconds longest = windows.level(of.processor, of.priority);
  for (const ThreadId t : problem.threads.ids()) {
    if (problem.threads[t].parent == block) longest = std::max(longest, stops_within(problem, windows, t));
  }
  return longest;
}

}  // namespace pal::analyzer::compositional
