// When the statements of a requirement take effect in one thread, job after job.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "analyzer/compositional/causes/exclusive.hpp"
#include "analyzer/compositional/measures/job_view.hpp"

namespace pal::analyzer::compositional {

/// The paths onward from a place, until one of the statements takes effect or none is reachable.
struct Way {
  Sum latest;             // after the nominal instant of the source, over the paths that reach a statement
  Sum released;           // the same for the release of the segment that contains it
  bool ends_job = false;  // some path ends the job first
  bool lost = false;      // some path is unbounded
};

/// The effects of the statements `at` in one thread that returns to its idle wait after every job.
class StatementOccurrences {
 public:
  StatementOccurrences(const View& view, ThreadId thread, const Table<StepId, bool>& at);

  const std::vector<StepEffect>& in_jobs() const { return in_jobs_; }
  const std::vector<StepEffect>& before_jobs() const { return before_jobs_; }

  /// After an effect.
  Way after(StepEffect effect);
  /// From the entry of the thread.
  Way from_entry();
  /// Whether each job has one, or leads to where none is reachable, and the inter-arrival time of jobs is
  /// bounded.
  bool in_every_job() const { return in_every_job_; }
  /// Whether some path through a job has none, and the inter-arrival time of jobs is bounded.
  bool may_skip() const { return may_skip_; }
  /// With in_every_job: latest effect in a job after the nominal instant of its source.
  const Sum& latest() const { return latest_; }
  /// With in_every_job: latest release of the segment with the effect. The thread is busy from then until the
  /// effect.
  const Sum& released() const { return released_; }
  /// Greatest inter-arrival time of jobs, between nominal instants, and of the first from time 0.
  const Sum& gap() const { return gap_; }
  const Sum& first() const { return first_; }
  /// With in_every_job: from the nominal instant of one job to the effect in the next one, or to the end of
  /// the skill. The effect comes by `effect` after its own nominal instant.
  Sum next_or_end(const Sum& effect) const;
  /// With in_every_job: from time 0 to the effect in the first job, or to the end of the skill.
  Sum first_or_end(const Sum& effect) const;

 private:
  Way from(NodeId node, StepId step);
  /// The same from the results of the steps that follow. Unbounded in a cycle of steps.
  Way way_from(NodeId node, StepId step);
  Way beyond_wait(NodeId node, StepId wait);
  Way begun(NodeId node);
  /// The first step of a node's segment behind the wait that begins it; nothing: that wait is one of the
  /// statements.
  std::optional<StepId> opening(NodeId node) const;
  void find_ends(SourceId source);
  void merge(Way& into, const Way& other) const;

  const View& view_;
  ThreadId thread_;
  const Table<StepId, bool>& at_;
  Table<StepId, bool> reachable_;  // by step: one of the statements can still come
  bool begins_again_;              // a block of a CONCURRENT that comes again
  std::vector<StepEffect> in_jobs_;
  std::vector<StepEffect> before_jobs_;
  std::map<std::pair<NodeId, StepId>, Way> known_;
  bool in_every_job_ = false;
  bool may_skip_ = false;
  Sum latest_;
  Sum released_;
  /// Latest end of the skill or of a thread: in a job; before the first job.
  Sum ended_;
  Sum ended_at_start_;
  Sum gap_ = Sum::unbounded();
  Sum first_ = Sum::unbounded();
};

}  // namespace pal::analyzer::compositional
