// A segment: what a thread does between two waits.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "analyzer/compositional/causes/ids.hpp"
#include "analyzer/compositional/causes/saturating.hpp"

namespace pal::analyzer::compositional {

/// How a segment begins.
struct Beginning {
  enum class Kind { entry, arm, give_up, joined };
  Kind kind = Kind::entry;
  ThreadId thread{};
  StepId step{};  // the wait, or the fork
  int arm = -1;   // of the wait: which of its channels

  auto operator<=>(const Beginning&) const = default;
};

struct Segment {
  struct Passed {
    StepId step{};
    Nanoseconds best = 0;   // processor time from the segment's beginning to the step's effect, on the
    Nanoseconds worst = 0;  // shortest and on the longest way
  };
  struct Arrival {
    StepId step{};  // a wait or a fork that ends the segment
    Nanoseconds best = 0;
    Nanoseconds worst = 0;
  };
  Beginning beginning;
  std::vector<Passed> steps;  // each before those that follow it
  std::vector<Arrival> waits;
  std::vector<Arrival> forks;
  bool ends = false;      // may end its thread
  bool spins = false;     // has a loop without a wait: its time has no bound
  Nanoseconds worst = 0;  // longest way through
};

/// By step of the problem: whether a run of the segment may come to it after `first`.
Table<StepId, bool> steps_after(const Problem& problem, const Segment& segment, StepId first);

/// Whether a run of the segment may pass one of these of its steps after another, or one of them twice.
bool any_in_row(const Problem& problem, const Segment& segment, const std::vector<StepId>& steps);

/// A test that ends the skill if no guard holds.
inline bool may_match_nothing(const Step& step) {
  return step.kind == Step::Kind::test && step.next.size() == step.guards.size();
}

/// Whether a run of the segment may end its thread, or the skill.
bool may_end(const Problem& problem, const Segment& segment);

/// All segments of a problem, made when asked for.
class Segments {
 public:
  explicit Segments(const Problem& problem);

  SegmentId find(const Beginning& beginning);
  const Segment& operator[](SegmentId id) const { return segments_[id]; }
  IdRange<SegmentId> ids() const { return segments_.ids(); }
  std::size_t size() const { return segments_.size(); }
  /// The thread that a step belongs to; none: none reaches it.
  ThreadId owner(StepId step) const { return owner_[step]; }

 private:
  Segment make(const Beginning& beginning) const;

  const Problem& problem_;
  Table<StepId, ThreadId> owner_;
  std::map<Beginning, SegmentId> known_;
  Table<SegmentId, Segment> segments_;
};

}  // namespace pal::analyzer::compositional
