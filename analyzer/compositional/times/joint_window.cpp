// The busy window of a chain of tasks, taken as one.
#include <algorithm>

#include "analyzer/compositional/times/busy_window.hpp"

namespace pal::analyzer::compositional {

Nanoseconds BusyWindows::of_own(const JointTasks& joint, Nanoseconds length, bool in_whole,
                                std::vector<Share>* shares) const {
  const Transaction& of = transactions_[joint.transaction];
  const Task& first = of.tasks[joint.tasks.front()];
  Tally tally(of, joint.transaction, shares);
  for (TaskId t : group_of(joint.transaction, first.processor)->tasks) {
    const Task& task = of.tasks[t];
    if (task.priority < joint.priority || task.cost == 0) continue;
    if (std::find(joint.tasks.begin(), joint.tasks.end(), t) != joint.tasks.end()) continue;
    Nanoseconds jobs = releases(of.period, task.jitter, length);
    if (!in_whole && task.jitter < never && !task.piles_up && follows(of, joint.tasks.back(), t)) {
      // Those of earlier occurrences that are released in the window: it begins no earlier than `length`
      // before the first task is due.
      const Nanoseconds late = task.offset + task.jitter + length - first.offset;
      jobs = std::min(jobs, std::max<Nanoseconds>(0, late / of.period));
    }
    tally.add(t, jobs);
  }
  return tally.total([&](const Alternatives& all) { return releases(of.period, all.jitter, length); });
}

Nanoseconds BusyWindows::joint_window(const JointTasks& joint, Nanoseconds fixed, bool in_whole) const {
  const Transaction& of = transactions_[joint.transaction];
  const Task& first = of.tasks[joint.tasks.front()];
  const auto& groups = by_processor_[first.processor];
  Nanoseconds length = fixed;
  while (length < of.period - first.jitter) {
    if (stops()) return never;
    const Nanoseconds next =
        plus(plus(fixed, of_others(groups, joint.transaction, nullptr, joint.priority, length)),
             of_own(joint, length, in_whole, nullptr));
    if (next <= length) return length;
    length = next;
  }
  return never;
}

BusyWindows::JointTasks BusyWindows::joint_tasks(TransactionId transaction, std::vector<TaskId> chain) const {
  JointTasks joint{transaction, std::move(chain), 0, 0};
  const auto& tasks = transactions_[transaction].tasks;
  joint.priority = tasks[joint.tasks.front()].priority;
  for (TaskId t : joint.tasks) {
    joint.priority = std::min(joint.priority, tasks[t].priority);
    joint.cost = plus(joint.cost, tasks[t].cost);
  }
  return joint;
}

Nanoseconds BusyWindows::joint_finish(TransactionId transaction, const std::vector<TaskId>& chain,
                                      Nanoseconds part) const {
  const Transaction& of = transactions_[transaction];
  const Task& first = of.tasks[chain.front()];
  const JointTasks joint = joint_tasks(transaction, chain);
  const bool known =
      of.period < never && first.jitter < of.period && !first.piles_up && preemptive_[first.processor];
  if (!known || joint.cost >= never) return never;
  // The chain of the next occurrence must not come before the processor has nothing of this level to do.
  if (joint_window(joint, joint.cost, true) >= never) return never;
  const Nanoseconds rest = of.tasks[chain.back()].cost - part;
  return joint_window(joint, joint.cost - rest, false);
}

std::vector<Share> BusyWindows::joint_breakdown(TransactionId transaction, const std::vector<TaskId>& chain,
                                                Nanoseconds part) const {
  const JointTasks joint = joint_tasks(transaction, chain);
  const Nanoseconds length = joint_finish(transaction, chain, part);
  const auto& tasks = transactions_[transaction].tasks;
  const ProcessorId processor = tasks[chain.front()].processor;
  Shares shares;
  of_others(by_processor_[processor], transaction, nullptr, joint.priority, length, &shares);
  of_own(joint, length, false, &shares);
  return shares;
}

}  // namespace pal::analyzer::compositional
