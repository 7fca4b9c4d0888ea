#include "analyzer/compositional/times/transaction.hpp"

#include <algorithm>

namespace pal::analyzer::compositional {

void Transaction::exclude(std::vector<TaskId> among, Nanoseconds piled) {
  const int index = static_cast<int>(alternatives.size());
  Alternatives made{std::move(among), piled, never, 0};
  for (TaskId t : made.tasks) {
    Task& task = tasks[t];
    task.among = index;
    made.offset = std::min(made.offset, task.offset);
  }
  alternatives.push_back(std::move(made));
  for (TaskId t : alternatives.back().tasks) set_jitter(t, tasks[t].jitter, never);
}

void Transaction::set_jitter(TaskId task, Nanoseconds jitter, Nanoseconds most) {
  Task& of = tasks[task];
  of.jitter = std::min(jitter, most);
  of.piles_up = jitter > most;
  if (of.among < 0) return;
  Alternatives& all = alternatives[static_cast<std::size_t>(of.among)];
  all.jitter = 0;
  bool piles_up = false;
  for (TaskId t : all.tasks) {
    const Task& each = tasks[t];
    const Nanoseconds late = each.piles_up ? 0 : each.jitter;
    all.jitter = std::max(all.jitter, plus(each.offset - all.offset, late));
    piles_up = piles_up || each.piles_up;
  }
  if (piles_up) all.jitter = plus(all.jitter, all.piled);
}

bool follows(const Transaction& of, TaskId before, TaskId task) {
  const auto& followers = of.tasks[before].followers;
  return std::binary_search(followers.begin(), followers.end(), task);
}

bool comes_after(const Transaction& of, const Task& self, TaskId other, Nanoseconds length) {
  const auto found =
      std::lower_bound(self.separations.begin(), self.separations.end(), other,
                       [](const Separation& separation, TaskId task) { return separation.task < task; });
  if (found == self.separations.end() || found->task != other) return false;
  const Task& cause = of.tasks[found->cause];
  if (cause.jitter >= never || self.jitter >= never) return false;
  const Nanoseconds since = self.offset + self.jitter - cause.offset - cause.jitter;
  return found->least > plus(std::max<Nanoseconds>(0, since), length);
}

void Tally::add_alternative(const Task& added, const Share& share) {
  auto among = std::find_if(among_.begin(), among_.end(),
                            [&](const Among& each) { return each.alternatives == added.among; });
  if (among == among_.end()) {
    among = among_.insert(among_.end(), Among());
    among->alternatives = added.among;
  }
  among->shares.push_back(share);
  among->work = plus(among->work, share.work);
  if (added.cost <= among->cost) return;
  among->cost = added.cost;
  among->longest = share;
}

void Tally::together(const Among& of, Nanoseconds jobs) {
  const Nanoseconds work = work_of(jobs, of.cost);
  if (work < of.work) return count({transaction_, of.longest.task, jobs, work});
  for (const Share& share : of.shares) count(share);
}

}  // namespace pal::analyzer::compositional
