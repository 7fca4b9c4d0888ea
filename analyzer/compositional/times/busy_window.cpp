#include "analyzer/compositional/times/busy_window.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace pal::analyzer::compositional {
namespace {

constexpr int most_busy_steps = 20'000;
constexpr Nanoseconds longest_window = 1'000'000'000'000'000;
/// A transaction of more tasks on a processor takes its time.
constexpr std::size_t many_tasks = 32;

/// Where to begin looking for the least window in which `fixed`, `carried` and `share` of its length fit, and
/// perhaps more: not above it (M. Sjödin and H. Hansson, Improved response-time analysis calculations, 1998).
Nanoseconds least_window(Nanoseconds fixed, double share, double carried) {
  constexpr double rounding = 1e-9;
  const double least = (static_cast<double>(fixed) + carried) / (1 - share) * (1 - rounding);
  if (least >= static_cast<double>(longest_window)) return std::max(fixed, longest_window);
  return least > 0 ? std::max(fixed, static_cast<Nanoseconds>(least)) : fixed;
}

}  // namespace

TransactionId BusyWindows::add(Transaction transaction) {
  const TransactionId index(transactions_.size());
  by_processor_.resize(preemptive_.size());
  std::set<ProcessorId> processors;
  for (const TaskId t : transaction.tasks.ids()) {
    auto& groups = by_processor_[transaction.tasks[t].processor];
    const Task& task = transaction.tasks[t];
    const bool once = transaction.period == never;
    const double share =
        once || task.cost == 0 ? 0 : static_cast<double>(task.cost) / static_cast<double>(transaction.period);
    if (processors.insert(task.processor).second) {
      groups.push_back(
          {index, t, task.priority, true, transaction.period, task.cost, task.jitter, share, {}, {}});
    }
    groups.back().priority = std::max(groups.back().priority, task.priority);
    groups.back().tasks.push_back(t);
    groups.back().single = groups.back().tasks.size() == 1;
    if (task.cost != 0) groups.back().workers.push_back({t, share});
  }
  for (const ProcessorId processor : processors) {
    auto& groups = by_processor_[processor];
    const auto above = [](const Group& one, const Group& other) { return one.priority > other.priority; };
    const auto place = std::upper_bound(groups.begin(), groups.end() - 1, groups.back(), above);
    std::rotate(place, groups.end() - 1, groups.end());
  }
  return transactions_.push_back(std::move(transaction));
}

void BusyWindows::set_jitter(TransactionId transaction, TaskId task, Nanoseconds jitter, Nanoseconds most) {
  Transaction& of = transactions_[transaction];
  of.set_jitter(task, jitter, most);
  const Task& changed = of.tasks[task];
  auto& groups = by_processor_[changed.processor];
  const auto before = [&](const Group& group, int priority) {
    return group.priority != priority ? group.priority > priority : group.transaction < transaction;
  };
  const auto place = std::lower_bound(groups.begin(), groups.end(), changed.priority, before);
  if (place != groups.end() && place->transaction == transaction && place->first == task)
    place->jitter = changed.jitter;
}

Nanoseconds BusyWindows::of_scenario(const Group& group, TaskId scenario, const Asked& asked, int priority,
                                     Nanoseconds length, Shares* shares) const {
  const Transaction& of = transactions_[group.transaction];
  const Task& first = of.tasks[scenario];
  const auto released = [&](const auto& task, Nanoseconds due) {
    return asked.drifting ? releases(of.period, task.jitter, length) : count(of, task.jitter, due, length);
  };
  Tally tally(of, group.transaction, shares);
  for (const auto& [t, share] : group.workers) {
    const Task& task = of.tasks[t];
    if (t == asked.task || task.priority < priority) continue;
    if (!counts(asked.asker, group.transaction, t)) continue;
    const Nanoseconds due = phase(of, first, task.offset);
    Nanoseconds jobs = released(task, due);
    if (!asked.drifting && asked.precedes && follows(of, asked.task, t)) {
      // Those of earlier occurrences; job 1 is of the occurrence at `due - offset`.
      const Nanoseconds before = (asked.occurrence + task.offset - due) / of.period;
      jobs = std::min(jobs, std::max<Nanoseconds>(0, before + (task.jitter + due) / of.period));
    }
    tally.add(t, jobs);
  }
  return tally.total([&](const Alternatives& all) { return released(all, phase(of, first, all.offset)); });
}

bool BusyWindows::drifts(const Group& group, const Task* asker, int priority) const {
  const Transaction& of = transactions_[group.transaction];
  if (of.regular || of.period == never) return false;
  Nanoseconds soonest = never;
  Nanoseconds latest = 0;
  for (const auto& [t, share] : group.workers) {
    const Task& task = of.tasks[t];
    if (task.priority < priority || !counts(asker, group.transaction, t)) continue;
    const Nanoseconds offset =
        task.among < 0 ? task.offset : of.alternatives[static_cast<std::size_t>(task.among)].offset;
    soonest = std::min(soonest, offset);
    latest = std::max(latest, task.offset);
  }
  return latest > plus(soonest, of.period);
}

bool BusyWindows::drifts_from(const Group& group, TaskId task) const {
  const Transaction& of = transactions_[group.transaction];
  if (of.regular) return false;
  const Task& self = of.tasks[task];
  return std::any_of(group.workers.begin(), group.workers.end(), [&](const Worker& worker) {
    const TaskId t = worker.task;
    const Task& other = of.tasks[t];
    if (t == task || other.priority < self.priority || !counts(&self, group.transaction, t)) return false;
    return other.offset > self.offset + of.period ||
           self.offset + self.jitter > of.period + other.offset + other.jitter;
  });
}

/// Of the worst of a transaction's scenarios.
Nanoseconds BusyWindows::of_group(const Group& group, const Task* asker, int priority, Nanoseconds length,
                                  Shares* shares) const {
  const Transaction& of = transactions_[group.transaction];
  const bool alone = of.period == never || drifts(group, asker, priority);
  Nanoseconds most = 0;
  TaskId worst{};
  Tally one_by_one(of, group.transaction, shares);
  for (const auto& [t, share] : group.workers) {
    const Task& task = of.tasks[t];
    if (task.priority < priority || !counts(asker, group.transaction, t)) continue;
    if (alone) {
      one_by_one.add(t, releases(of.period, task.jitter, length));
      continue;
    }
    if (group.tasks.size() > many_tasks && stops()) return never;
    const Nanoseconds work = of_scenario(group, t, {asker}, priority, length);
    if (!worst.valid() || work > most) worst = t;
    most = std::max(most, work);
  }
  if (alone)
    return one_by_one.total([&](const Alternatives& all) { return releases(of.period, all.jitter, length); });
  if (shares != nullptr && worst.valid()) of_scenario(group, worst, {asker}, priority, length, shares);
  return most;
}

Nanoseconds BusyWindows::of_others(const std::vector<Group>& groups, TransactionId own, const Task* asker,
                                   int priority, Nanoseconds length, Shares* shares) const {
  Nanoseconds work = 0;
  for (const Group& group : groups) {
    if (group.priority < priority) break;
    if (group.transaction == own) continue;
    if (!group.single) {
      work = plus(work, of_group(group, asker, priority, length, shares));
      continue;
    }
    // The usual case: there is one scenario, whose phase cancels out.
    if (group.cost == 0 || !counts(asker, group.transaction, group.first)) continue;
    const Nanoseconds jobs = releases(group.period, group.jitter, length);
    const Nanoseconds share = work_of(jobs, group.cost);
    work = plus(work, share);
    if (shares != nullptr) shares->push_back({group.transaction, group.first, jobs, share});
  }
  return work;
}

BusyWindows::Foreign BusyWindows::foreign_of(TransactionId own, TaskId task) const {
  const Task& asker = transactions_[own].tasks[task];
  Foreign foreign;
  const std::vector<Group>& groups = by_processor_[asker.processor];
  foreign.alone.reserve(groups.size());
  std::vector<const Task*> counted;
  for (const Group& group : groups) {
    if (group.priority < asker.priority) break;
    const bool is_own = group.transaction == own;
    add_load(group, !is_own, asker, foreign.load);
    if (is_own) {
      foreign.own = &group;
    } else if (!group.single) {
      add_foreign(group, asker, counted, foreign);
    } else if (group.cost != 0 && counts(&asker, group.transaction, group.first)) {
      foreign.alone.push_back({group.period, group.jitter, group.cost});
    }
  }
  return foreign;
}

void BusyWindows::add_foreign(const Group& group, const Task& asker, std::vector<const Task*>& counted,
                              Foreign& foreign) const {
  const Transaction& of = transactions_[group.transaction];
  counted.clear();
  for (const auto& [t, share] : group.workers) {
    const Task& task = of.tasks[t];
    if (task.priority < asker.priority || !counts(&asker, group.transaction, t)) continue;
    if (task.among >= 0) return foreign.several.push_back(&group);
    counted.push_back(&task);
  }
  // The phase of a single one cancels out.
  if (counted.size() <= 1 || of.period == never || drifts(group, &asker, asker.priority)) {
    for (const Task* task : counted) foreign.alone.push_back({of.period, task->jitter, task->cost});
    return;
  }
  if (counted.size() > many_tasks) return foreign.several.push_back(&group);
  foreign.together.push_back({of.period, foreign.due.size(), counted.size()});
  for (const Task* first : counted) {
    for (const Task* task : counted) {
      const Nanoseconds due = phase(of, *first, task->offset);
      foreign.due.push_back({due, (task->jitter + due) / of.period, task->cost});
    }
  }
}

Nanoseconds BusyWindows::of_foreign(const Foreign& foreign, const Task& asker, Nanoseconds length) const {
  Nanoseconds work = 0;
  for (const Foreign::Alone& each : foreign.alone)
    work = plus(work, work_of(releases(each.period, each.jitter, length), each.cost));
  for (const Foreign::Together& each : foreign.together) {
    Nanoseconds most = 0;
    for (std::size_t scenario = 0; scenario < each.count; ++scenario) {
      Nanoseconds sum = 0;
      for (std::size_t i = 0; i < each.count; ++i) {
        const auto& [phase, piled, cost] = foreign.due[each.first + scenario * each.count + i];
        const Nanoseconds jobs = piled + (length >= phase ? (length - phase) / each.period + 1 : 0);
        sum = plus(sum, work_of(jobs, cost));
      }
      most = std::max(most, sum);
    }
    work = plus(work, most);
  }
  for (const Group* group : foreign.several)
    work = plus(work, of_group(*group, &asker, asker.priority, length, nullptr));
  return work;
}

Nanoseconds BusyWindows::of_siblings(TransactionId transaction, TaskId task, Nanoseconds length,
                                     Shares* shares) const {
  const Transaction& of = transactions_[transaction];
  const Task& self = of.tasks[task];
  Tally tally(of, transaction, shares);
  for (const auto& [t, share] : group_of(transaction, self.processor)->workers) {
    const Task& other = of.tasks[t];
    if (t == task || other.priority < self.priority) continue;
    if (counts(&self, transaction, t) && !comes_after(of, self, t, length)) tally.add(t, 1);
  }
  return tally.total([](const Alternatives&) { return Nanoseconds{1}; });
}

void BusyWindows::add_load(const Group& group, bool foreign, const Task& self, Load& load) const {
  const auto add = [&](bool once, double share, Nanoseconds cost, Nanoseconds jitter) {
    load.whole += share;
    if (!foreign) return;
    load.share += share;
    // A task that is alone has one release more than its share; of several not all need have it.
    if (once) {
      load.carried += static_cast<double>(cost);
    } else {
      load.carried += static_cast<double>(jitter) * share;
      if (!group.single) load.carried -= static_cast<double>(cost);
    }
  };
  if (group.single) {
    if (group.cost == 0 || !counts(&self, group.transaction, group.first)) return;
    const bool once = group.period == never;
    load.bounded = load.bounded && group.cost < never && (once || group.jitter < never);
    return add(once, group.share, group.cost, group.jitter);
  }
  struct Longest {
    double share = 0;
    Nanoseconds cost = 0;
  };
  const Transaction& of = transactions_[group.transaction];
  const bool once = of.period == never;
  std::vector<Longest> longest(of.alternatives.size());
  for (const auto& [t, share] : group.workers) {
    const Task& task = of.tasks[t];
    if (task.priority < self.priority || !counts(&self, group.transaction, t)) continue;
    load.bounded = load.bounded && task.cost < never && (once || task.jitter < never);
    if (task.among < 0) {
      add(once, share, task.cost, task.jitter);
      continue;
    }
    Longest& most = longest[static_cast<std::size_t>(task.among)];
    if (task.cost > most.cost) most = {share, task.cost};
  }
  for (const Longest& each : longest) add(once, each.share, each.cost, 0);
}

BusyWindows::Critical BusyWindows::critical_once(TransactionId transaction, TaskId task, Nanoseconds part,
                                                 Nanoseconds blocking, Since since,
                                                 const Foreign& foreign) const {
  const Task& self = transactions_[transaction].tasks[task];
  const bool preemptive = preemptive_[self.processor];
  const Nanoseconds fixed = blocking + (preemptive ? part : 0);
  Nanoseconds window = least_window(fixed, foreign.load.share, foreign.load.carried);
  for (int iteration = 0; iteration < most_busy_steps; ++iteration) {
    const Nanoseconds length = closed(window, preemptive);
    const Nanoseconds next =
        plus(fixed + of_siblings(transaction, task, length, nullptr), of_foreign(foreign, self, length));
    if (next <= window) {
      const Nanoseconds released = since == Since::release ? 0 : self.offset + self.jitter;
      return {released + window + (preemptive ? 0 : part), window, TaskId{}, 1};
    }
    if (next > longest_window) break;
    window = next;
  }
  return {never};
}

Nanoseconds BusyWindows::stretch(ProcessorId processor, int priority, Nanoseconds cost) const {
  if (!preemptive_[processor]) return cost;
  return window(processor, priority + 1, cost);
}

Nanoseconds BusyWindows::level(ProcessorId processor, int priority) const {
  return preemptive_[processor] ? window(processor, priority, 0) : busy(processor);
}

Nanoseconds BusyWindows::busy(ProcessorId processor) const {
  return window(processor, std::numeric_limits<int>::min(), 0);
}

std::vector<Share> BusyWindows::work(ProcessorId processor, Nanoseconds busy) const {
  Shares shares;
  of_others(by_processor_[processor], TransactionId{}, nullptr, std::numeric_limits<int>::min(), busy,
            &shares);
  return shares;
}

/// The least time in which `cost`, and all that is released in it with at least `priority`, is done.
Nanoseconds BusyWindows::window(ProcessorId processor, int priority, Nanoseconds cost) const {
  const auto& groups = by_processor_[processor];
  for (const Group& group : groups) {
    if (group.priority < priority) break;
    const Transaction& of = transactions_[group.transaction];
    for (TaskId t : group.tasks) {
      const Task& task = of.tasks[t];
      if (task.priority >= priority && (task.cost >= never || (task.jitter >= never && of.period != never)))
        return never;
    }
  }
  Nanoseconds length = cost;
  for (int iteration = 0; iteration < most_busy_steps; ++iteration) {
    const Nanoseconds next = plus(cost, of_others(groups, TransactionId{}, nullptr, priority, length));
    if (next <= length) return length;
    if (next > longest_window) break;
    length = next;
  }
  return never;
}

BusyWindows::Critical BusyWindows::critical(TransactionId transaction, TaskId task, Nanoseconds part,
                                            Nanoseconds blocking, Since since, const Foreign& foreign) const {
  const Transaction& of = transactions_[transaction];
  const Task& self = of.tasks[task];
  if (blocking >= never || self.jitter >= never) return {never};
  const bool preemptive = preemptive_[self.processor];
  const Load& load = foreign.load;
  if (!load.bounded || load.whole >= 1) return {never};
  if (of.period == never) return critical_once(transaction, task, part, blocking, since, foreign);

  const Group& own = *foreign.own;
  const bool drifting = drifts_from(own, task);
  Critical latest{-1};
  int iterations = 0;
  std::map<Nanoseconds, Nanoseconds> known;  // by length; few tasks seldom ask for one twice
  const auto others = [&](Nanoseconds length) {
    const auto found = [&] { return of_foreign(foreign, self, length); };
    if (own.tasks.size() <= many_tasks) return found();
    const auto [place, fresh] = known.emplace(length, 0);
    if (fresh) place->second = found();
    return place->second;
  };
  for (TaskId scenario : own.tasks) {
    const Task& first = of.tasks[scenario];
    if (first.priority < self.priority || (first.cost == 0 && scenario != task)) continue;
    if (scenario != task && (drifting || !counts(&self, transaction, scenario))) continue;
    const Nanoseconds due = phase(of, first, self.offset);
    const Nanoseconds piled = (self.jitter + due) / of.period;
    // Until the part is done (preemptive), or begins (not preemptive): the windows of later jobs last longer.
    Nanoseconds begun = 0;
    for (Nanoseconds job = 1 - piled;; ++job) {
      if (own.tasks.size() > many_tasks && stops()) return {never};
      const Asked asked{&self, task, true, due + (job - 1) * of.period - self.offset, drifting};
      const Asked all{&self, task, false, 0, drifting};
      const auto settle = [&](Nanoseconds fixed, const Asked& but) {
        Nanoseconds at = std::max(begun, least_window(fixed, load.share, load.carried));
        while (++iterations < most_busy_steps) {
          const Nanoseconds length = closed(at, preemptive);
          const Nanoseconds next =
              fixed + others(length) + of_scenario(own, scenario, but, self.priority, length);
          if (next <= at) return at;
          if (next > longest_window) break;
          at = next;
        }
        return never;
      };
      const Nanoseconds before = blocking + (job + piled - 1) * self.cost;
      begun = settle(before + (preemptive ? part : 0), asked);
      if (begun >= never) return {never};
      const Nanoseconds done = preemptive ? begun : begun + part;
      // What came while it ran is still to be done: the window goes on (R. I. Davis and others, 2007).
      const bool over = preemptive && part == self.cost && self.followers.empty();
      const Nanoseconds whole = over ? done : settle(before + self.cost, all);
      if (whole >= never) return {never};
      // The job is released when it is due or later, and not before the window begins.
      const Nanoseconds released = due + (job - 1) * of.period;
      const Nanoseconds finish =
          since == Since::release ? done - std::max<Nanoseconds>(0, released) : done - released + self.offset;
      if (finish > latest.finish) latest = {finish, begun, scenario, job};
      if (whole < due + job * of.period) break;
    }
  }
  return latest;
}

Nanoseconds BusyWindows::finish(TransactionId transaction, TaskId task, Nanoseconds part,
                                Nanoseconds blocking, Since since) const {
  return critical(transaction, task, part, blocking, since, foreign_of(transaction, task)).finish;
}

std::vector<Nanoseconds> BusyWindows::finishes(TransactionId transaction, TaskId task,
                                               const std::vector<Nanoseconds>& parts,
                                               Nanoseconds blocking) const {
  const Foreign foreign = foreign_of(transaction, task);
  std::vector<Nanoseconds> result;
  for (const Nanoseconds part : parts)
    result.push_back(critical(transaction, task, part, blocking, Since::occurrence, foreign).finish);
  return result;
}

FinishBreakdown BusyWindows::breakdown(TransactionId transaction, TaskId task, Nanoseconds part,
                                       Nanoseconds blocking, Since since) const {
  const Transaction& of = transactions_[transaction];
  const Task& self = of.tasks[task];
  const auto& groups = by_processor_[self.processor];
  const Critical worst = critical(transaction, task, part, blocking, since, foreign_of(transaction, task));
  const Nanoseconds length = closed(worst.length, preemptive_[self.processor]);
  FinishBreakdown breakdown;
  breakdown.blocking = blocking;
  of_others(groups, transaction, &self, self.priority, length, &breakdown.others);
  if (!worst.scenario.valid()) {
    of_siblings(transaction, task, length, &breakdown.others);
    return breakdown;
  }
  const Nanoseconds due = phase(of, of.tasks[worst.scenario], self.offset);
  const Nanoseconds earlier = worst.job - 1 + (self.jitter + due) / of.period;
  const Group& own = *group_of(transaction, self.processor);
  const Asked asked{&self, task, true, due + (worst.job - 1) * of.period - self.offset,
                    drifts_from(own, task)};
  of_scenario(own, worst.scenario, asked, self.priority, length, &breakdown.others);
  breakdown.others.push_back({transaction, task, earlier, earlier * self.cost});
  const Nanoseconds released = due + (worst.job - 1) * of.period;
  breakdown.done_before =
      since == Since::release ? std::max<Nanoseconds>(0, released) : released + self.jitter;
  return breakdown;
}

const BusyWindows::Group* BusyWindows::group_of(TransactionId transaction, ProcessorId processor) const {
  for (const Group& group : by_processor_[processor]) {
    if (group.transaction == transaction) return &group;
  }
  return nullptr;
}

}  // namespace pal::analyzer::compositional
