// Tasks that one thing releases again and again, and how much work they bring to a window.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "analyzer/compositional/causes/saturating.hpp"

namespace pal::analyzer::compositional {

/// In BusyWindows.
using TransactionId = Id<struct TransactionTag>;

/// In Transaction::tasks.
using TaskId = Id<struct TaskTag>;

/// A task of the same transaction that is released no sooner than `least` after `cause`. What passes from the
/// release of `cause` until that of the task whose separation this is, is at most what passes between their
/// latest instants.
struct Separation {
  TaskId task{};
  TaskId cause{};
  Nanoseconds least = 0;
};

/// Work that each occurrence of its transaction releases at most once, between `offset` and `offset + jitter`
/// after the occurrence.
struct Task {
  ProcessorId processor{0};
  int priority = 0;
  Nanoseconds cost = 0;
  Nanoseconds offset = 0;
  Nanoseconds jitter = 0;
  /// Tasks of its transaction that come only after it is done, of the same occurrence; ascending.
  std::vector<TaskId> followers{};
  /// Transactions and tasks whose work does not count in its windows; ascending.
  std::vector<std::pair<TransactionId, TaskId>> without{};
  /// If its transaction occurs once: tasks that may come after its own work; ascending.
  std::vector<Separation> separations{};
  int among = -1;         // of its transaction's alternatives; -1: none
  bool piles_up = false;  // it may come later: its jitter says how many can have piled up on the way
};

/// Tasks on one processor, of one priority. Each occurrence releases at most one of them.
struct Alternatives {
  std::vector<TaskId> tasks;
  Nanoseconds piled = 0;   // what the jitter counts besides if one of them piles up
  Nanoseconds offset = 0;  // of the soonest
  Nanoseconds jitter = 0;  // from then to the latest release of any
};

/// Occurrences are at least `period` apart; `never`: there is one.
struct Transaction {
  Nanoseconds period = 0;
  bool regular = false;  // exactly so far apart
  Table<TaskId, Task> tasks;
  std::vector<Alternatives> alternatives;

  /// Makes alternatives of tasks that are none yet. `piled`: a period for each that can have piled up on the
  /// way to any of them.
  void exclude(std::vector<TaskId> tasks, Nanoseconds piled);
  /// `most`: what the jitter counts as if it is greater.
  void set_jitter(TaskId task, Nanoseconds jitter, Nanoseconds most);
};

/// Whether a task's work counts in windows of `asker`.
inline bool counts(const Task* asker, TransactionId transaction, TaskId task) {
  return asker == nullptr || asker->without.empty() ||
         !std::binary_search(asker->without.begin(), asker->without.end(), std::pair{transaction, task});
}

/// Whether `task` comes, in one occurrence, only after `before` is done.
bool follows(const Transaction& of, TaskId before, TaskId task);

/// Whether `other`, of a transaction that occurs once, is released later than `length` after `self`.
bool comes_after(const Transaction& of, const Task& self, TaskId other, Nanoseconds length);

/// A window begins with `scenario`'s release after its whole jitter. In this window, when the next release of
/// what is released from `offset` on is due: in (0, period].
inline Nanoseconds phase(const Transaction& of, const Task& scenario, Nanoseconds offset) {
  const Nanoseconds since = (scenario.offset + scenario.jitter - offset) % of.period;
  return of.period - (since < 0 ? since + of.period : since);
}

/// Releases in the closed window: those that piled up before it, and those due in it.
inline Nanoseconds count(const Transaction& of, Nanoseconds jitter, Nanoseconds phase, Nanoseconds length) {
  if (jitter >= never) return never;
  const Nanoseconds piled = (jitter + phase) / of.period;
  return piled + (length >= phase ? (length - phase) / of.period + 1 : 0);
}

/// The same, whenever the window begins.
inline Nanoseconds releases(Nanoseconds period, Nanoseconds jitter, Nanoseconds length) {
  if (period == never) return 1;
  if (length >= never || jitter >= never) return never;
  return (length + jitter) / period + 1;
}

/// What a task brings to a window.
struct Share {
  TransactionId transaction{};
  TaskId task{};
  Nanoseconds jobs = 0;
  Nanoseconds work = 0;
};

/// Adds up what the tasks of a transaction bring to a window. Alternatives bring no more than if each
/// occurrence brought the longest of them.
class Tally {
 public:
  /// `shares`: where to add what it is made of, or null.
  Tally(const Transaction& of, TransactionId transaction, std::vector<Share>* shares)
      : of_(of), transaction_(transaction), shares_(shares) {}

  void add(TaskId task, Nanoseconds jobs) {
    const Task& added = of_.tasks[task];
    const Share share{transaction_, task, jobs, work_of(jobs, added.cost)};
    if (added.among < 0) return count(share);
    add_alternative(added, share);
  }

  /// `jobs_of`: how often alternatives, taken as one, are released in the window.
  template <class JobsOf>
  Nanoseconds total(const JobsOf& jobs_of) {
    for (const Among& each : among_)
      together(each, jobs_of(of_.alternatives[static_cast<std::size_t>(each.alternatives)]));
    return work_;
  }

 private:
  /// What counts of alternatives, one by one.
  struct Among {
    int alternatives = -1;
    std::vector<Share> shares;
    Nanoseconds work = 0;
    Share longest;  // the task whose cost is the greatest
    Nanoseconds cost = 0;
  };

  void count(const Share& share) {
    work_ = plus(work_, share.work);
    if (shares_ != nullptr) shares_->push_back(share);
  }
  void add_alternative(const Task& added, const Share& share);
  void together(const Among& of, Nanoseconds jobs);

  const Transaction& of_;
  TransactionId transaction_;
  std::vector<Share>* shares_;
  std::vector<Among> among_;
  Nanoseconds work_ = 0;
};

}  // namespace pal::analyzer::compositional
