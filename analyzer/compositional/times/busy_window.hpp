// Busy windows of transactions with offsets and jitter, under fixed priorities: the arithmetic of the
// compositional analysis, without anything of PAL.
//
// J. C. Palencia and M. González Harbour, Schedulability analysis for tasks with static and dynamic offsets,
// RTSS 1998. This is the approximation of section 4: one candidate for each foreign transaction, all
// candidates of one's own. What follows a job within its own transaction does not delay it. Source: the same
// authors, Exploiting precedence relations in the schedulability analysis of distributed real-time systems,
// RTSS 1999.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "analyzer/compositional/times/transaction.hpp"

namespace pal::analyzer::compositional {

/// What the finish of a job counts from.
enum class Since {
  occurrence,  // of its transaction
  release,     // of the job
};

/// What the finish of a job is made of: `latest` release (if it counts from the occurrence), its own work,
/// and these.
struct FinishBreakdown {
  std::vector<Share> others;    // work that goes first, the task's own earlier jobs included
  Nanoseconds blocking = 0;     // by lower priority
  Nanoseconds done_before = 0;  // the part of all that which is over when the job is released, at its latest
                                // or (if it counts from the release) at its earliest
};

/// Whether what is released at the very instant at which a window ends counts in it. PAL leaves the order of
/// the two open, so it does. Textbooks leave it out: there the end comes first. Processors that are not
/// preemptive, chains taken as one, and levels keep closed windows, which bound both.
enum class WindowEnds { closed, half_open };

class BusyWindows {
 public:
  /// `preemptive` by processor. Once `stop` says so, nothing has a bound.
  explicit BusyWindows(std::vector<bool> preemptive, std::function<bool()> stop = {},
                       WindowEnds ends = WindowEnds::closed)
      : preemptive_(std::move(preemptive)), stop_(std::move(stop)), ends_(ends) {}

  /// From here on nothing is asked whether to stop.
  void go_on() { stop_ = {}; }

  /// Adds a transaction; its tasks' jitter, and what counts for them, may change later, nothing else.
  TransactionId add(Transaction transaction);
  void set_jitter(TransactionId transaction, TaskId task, Nanoseconds jitter, Nanoseconds most);
  void set_without(TransactionId transaction, TaskId task,
                   std::vector<std::pair<TransactionId, TaskId>> without) {
    transactions_[transaction].tasks[task].without = std::move(without);
  }
  void set_separations(TransactionId transaction, TaskId task, std::vector<Separation> separations) {
    transactions_[transaction].tasks[task].separations = std::move(separations);
  }
  const Transaction& transaction(TransactionId id) const { return transactions_[id]; }

  /// How long after the occurrence, or the release, the first `part` of the task's cost is done at the
  /// latest. `blocking` is the longest time for which work of lower priority keeps the processor. `never`: no
  /// bound.
  ///
  /// Work of the same priority counts as if it went first. What is released at the very instant at which the
  /// work ends comes before that end, unless windows are half-open.
  Nanoseconds finish(TransactionId transaction, TaskId task, Nanoseconds part, Nanoseconds blocking,
                     Since since = Since::occurrence) const;
  /// finish() of each of several parts: what else counts is found once for all of them.
  std::vector<Nanoseconds> finishes(TransactionId transaction, TaskId task,
                                    const std::vector<Nanoseconds>& parts, Nanoseconds blocking) const;

  /// Adds up to finish(), with `part` and, since the occurrence, the latest release; for a finish that is
  /// bounded.
  FinishBreakdown breakdown(TransactionId transaction, TaskId task, Nanoseconds part, Nanoseconds blocking,
                            Since since = Since::occurrence) const;

  /// How long after the release of the first of `chain` the first `part` of the last one's cost is done at
  /// the latest. Tasks of one transaction and one processor; each is released when the one before it has done
  /// a part of its work. `never`: there is no bound, or the next occurrence may come before the busy window
  /// ends.
  ///
  /// All of them work at the least of their priorities, and others delay them once together (J. Schlatow and
  /// R. Ernst, Response-time analysis for task chains in communicating threads, RTAS 2016).
  Nanoseconds joint_finish(TransactionId transaction, const std::vector<TaskId>& chain,
                           Nanoseconds part) const;
  /// What else than the chain's own work adds up to a joint_finish() that is bounded.
  std::vector<Share> joint_breakdown(TransactionId transaction, const std::vector<TaskId>& chain,
                                     Nanoseconds part) const;

  /// How long `cost` takes at most for a thread of `priority` that has the processor. When it begins, nothing
  /// of higher priority is left to do.
  Nanoseconds stretch(ProcessorId processor, int priority, Nanoseconds cost) const;

  /// How long a thread of `priority` that is ready may take at most to do what it has begun.
  Nanoseconds level(ProcessorId processor, int priority) const;

  /// The longest that a processor has something to do without a pause, and the work that adds up to it.
  Nanoseconds busy(ProcessorId processor) const;
  std::vector<Share> work(ProcessorId processor, Nanoseconds busy) const;

 private:
  struct Worker {
    TaskId task{};
    double share = 0;  // of the processor that it needs; 0: of a transaction that occurs once
  };

  /// Tasks of one transaction on one processor. Windows go through all groups of a processor, and mostly a
  /// group has one task: what is asked of that one stands together, at the beginning.
  struct Group {
    TransactionId transaction;
    TaskId first{};
    int priority;  // the greatest of them
    bool single = true;
    Nanoseconds period = 0;
    Nanoseconds cost = 0;  // of the first task, as are jitter and share
    Nanoseconds jitter = 0;
    double share = 0;
    std::vector<TaskId> tasks{};
    std::vector<Worker> workers{};  // those that take time
  };

  /// What counts in a window of a task, other than its own transaction: at least `share` of its length, and
  /// `carried` more.
  struct Load {
    double share = 0;
    double carried = 0;
    double whole = 0;  // share, and that of the own transaction
    bool bounded = true;
  };

  /// The job that is asked about, and what is known to come after it. These are its followers of the
  /// occurrence at `occurrence`, counted from the beginning of the window, and of later ones.
  struct Asked {
    const Task* asker = nullptr;  // whose `without` does not count
    TaskId task{};
    bool precedes = false;
    Nanoseconds occurrence = 0;
    bool drifting = false;  // drifts_from() the task
  };

  /// The window and the job in it that finishes last.
  struct Critical {
    Nanoseconds finish = 0;
    Nanoseconds length = 0;  // until the part is done (preemptive), or begins (not preemptive)
    TaskId scenario{};       // task whose release begins the window; -1: its transaction occurs once
    Nanoseconds job = 0;
  };
  using Shares = std::vector<Share>;

  /// Work in a window; if `shares` is given, also what it is made of.
  Nanoseconds of_scenario(const Group& group, TaskId scenario, const Asked& asked, int priority,
                          Nanoseconds length, Shares* shares = nullptr) const;
  Nanoseconds of_group(const Group& group, const Task* asker, int priority, Nanoseconds length,
                       Shares* shares) const;
  /// Of all transactions but `own`, without what does not count for `asker`, if that is given.
  Nanoseconds of_others(const std::vector<Group>& groups, TransactionId own, const Task* asker, int priority,
                        Nanoseconds length, Shares* shares = nullptr) const;
  /// What counts in windows of a task: found once, and asked for again and again.
  struct Foreign {
    /// A task whose releases do not depend on those of others.
    struct Alone {
      Nanoseconds period = 0;
      Nanoseconds jitter = 0;
      Nanoseconds cost = 0;
    };
    /// A task in the window that begins with the release of one of its transaction.
    struct Due {
      Nanoseconds phase = 0;
      Nanoseconds piled = 0;  // released before the window
      Nanoseconds cost = 0;
    };
    /// Tasks of one transaction: from `first` in `due`, `count` for each of `count` scenarios.
    struct Together {
      Nanoseconds period = 0;
      std::size_t first = 0;
      std::size_t count = 0;
    };
    Load load;
    const Group* own = nullptr;  // the task's own
    std::vector<Alone> alone;
    std::vector<Together> together;
    std::vector<Due> due;
    std::vector<const Group*> several;  // what is too much to be found once, or has alternatives
  };
  Foreign foreign_of(TransactionId own, TaskId asker) const;
  /// Adds the tasks of one of several. `counted` is room for them.
  void add_foreign(const Group& group, const Task& asker, std::vector<const Task*>& counted,
                   Foreign& foreign) const;
  /// The same as of_others() for the asker.
  Nanoseconds of_foreign(const Foreign& foreign, const Task& asker, Nanoseconds length) const;
  /// Whether tasks can come nearer together than occurrences a period apart allow. This needs occurrences
  /// that are sometimes further apart. And one of the tasks must come more than a period later after its
  /// occurrence than another. Then each counts by itself.
  bool drifts(const Group& group, const Task* asker, int priority) const;
  /// The same of others and a task of their own transaction, whose jobs count from their occurrences.
  bool drifts_from(const Group& group, TaskId task) const;
  void add_load(const Group& group, bool foreign, const Task& self, Load& load) const;
  /// Tasks of a transaction that occurs once, which may come before the end of a window of one of them.
  Nanoseconds of_siblings(TransactionId transaction, TaskId task, Nanoseconds length, Shares* shares) const;
  Critical critical(TransactionId transaction, TaskId task, Nanoseconds part, Nanoseconds blocking,
                    Since since, const Foreign& foreign) const;
  Critical critical_once(TransactionId transaction, TaskId task, Nanoseconds part, Nanoseconds blocking,
                         Since since, const Foreign& foreign) const;
  const Group* group_of(TransactionId transaction, ProcessorId processor) const;

  /// A chain of tasks, taken as one.
  struct JointTasks {
    TransactionId transaction{};
    std::vector<TaskId> tasks;
    int priority = 0;      // the least of them
    Nanoseconds cost = 0;  // of all
  };
  JointTasks joint_tasks(TransactionId transaction, std::vector<TaskId> chain) const;
  /// Work of other tasks of its transaction in a window; unless `in_whole`, until the last task of the chain
  /// is done.
  Nanoseconds of_own(const JointTasks& joint, Nanoseconds length, bool in_whole,
                     std::vector<Share>* shares) const;
  Nanoseconds joint_window(const JointTasks& joint, Nanoseconds fixed, bool in_whole) const;
  Nanoseconds window(ProcessorId processor, int priority, Nanoseconds cost) const;

  /// The closed window with the same releases as one of this length.
  Nanoseconds closed(Nanoseconds length, bool preemptive) const {
    const bool half_open = ends_ == WindowEnds::half_open && preemptive;
    return half_open ? std::max<Nanoseconds>(length, 1) - 1 : length;
  }

  bool stops() const { return stop_ && stop_(); }

  Table<ProcessorId, bool> preemptive_;
  std::function<bool()> stop_;
  WindowEnds ends_;
  Table<TransactionId, Transaction> transactions_;
  Table<ProcessorId, std::vector<Group>> by_processor_;  // the greatest priority first
};

}  // namespace pal::analyzer::compositional
