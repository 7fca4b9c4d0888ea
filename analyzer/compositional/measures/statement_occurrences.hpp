// When statements come in one thread, round after round.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "analyzer/compositional/causes/exclusive.hpp"
#include "analyzer/compositional/measures/job_view.hpp"

namespace pal::analyzer::compositional {

/// The ways on from a place: until one of the statements has had its effect, or none can come any more.
struct Way {
  Sum latest;             // from the nominal instant of the source, of those ways that get there
  Sum released;           // the same, of the release of the segment in which they get there
  bool ends_job = false;  // some way ends the job first
  bool lost = false;      // nothing is known of some way
};

/// The effects of the statements `at` in one thread, as long as it comes home from every round.
class StatementOccurrences {
 public:
  StatementOccurrences(const View& view, int thread, const std::vector<bool>& at);

  const std::vector<StepEffect>& in_jobs() const { return in_jobs_; }
  const std::vector<StepEffect>& before_jobs() const { return before_jobs_; }

  /// After a pass.
  Way after(StepEffect effect);
  /// From where the thread begins.
  Way from_entry();
  /// Whether each round passes one, or goes where none can come any more, and rounds come at bounded
  /// inter-arrival times.
  bool in_every_job() const { return in_every_job_; }
  /// Whether some way through a round comes home without one, where rounds come at bounded inter-arrival
  /// times.
  bool may_skip() const { return may_skip_; }
  /// With in_every_job: latest pass of a round, from the nominal instant of its source.
  const Sum& latest() const { return latest_; }
  /// With in_every_job: latest release of the segment in which a round passes one. From then on the thread
  /// has something to do until it does.
  const Sum& released() const { return released_; }
  /// Greatest distance of nominal instants of rounds, and of the first from time 0; unbounded: not known.
  const Sum& gap() const { return gap_; }
  const Sum& first() const { return first_; }
  /// With in_every_job: from the nominal instant of a round that has passed one until the next has, by
  /// `effect` of its own, or the skill has ended.
  Sum next_or_end(const Sum& effect) const;
  /// With in_every_job: from time 0 until the first round has passed one, by `effect`, or the skill has
  /// ended.
  Sum first_or_end(const Sum& effect) const;

 private:
  Way from(int node, int step);
  /// The same, if it is known of the steps that follow; of a circle of steps it is not.
  Way way_from(int node, int step);
  Way beyond_wait(int node, int wait);
  Way begun(int node);
  /// The first step of a node's segment behind the wait that begins it; nothing: that wait is one of the
  /// statements.
  std::optional<int> opening(int node) const;
  bool surely_occurs(int node) const;
  void find_ends(int source);
  void merge(Way& into, const Way& other) const;

  const View& view_;
  int thread_;
  const std::vector<bool>& at_;
  std::vector<bool> reachable_;  // by step: one of the statements can still come
  bool begins_again_;            // a block of a CONCURRENT that comes again
  std::vector<StepEffect> in_jobs_;
  std::vector<StepEffect> before_jobs_;
  std::map<std::pair<int, int>, Way> known_;
  bool in_every_job_ = false;
  bool may_skip_ = false;
  Sum latest_;
  Sum released_;
  /// Latest end of the skill, or of a thread, in a round, and in one in which this thread has not surely
  /// passed one; before the first round.
  Sum ended_;
  Sum ended_before_;
  Sum ended_at_start_;
  Sum gap_ = Sum::unbounded();
  Sum first_ = Sum::unbounded();
};

}  // namespace pal::analyzer::compositional
