// What runs of a skill show of its requirements, however they were made. The run checker measures them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/run_checker/check_run.hpp"

namespace pal::program {

struct KnownRun {
  trace::Trace trace;
  analyzer::Nanoseconds end = 0;  // nothing more happens up to then
  bool completed = false;         // the skill ended
  bool still = false;             // nothing happens after the end, ever
  bool stands = false;            // time stood still at the end: it may be for ever
};

/// What the runs show of one requirement.
struct Seen {
  std::size_t values = 0;  // how many were measured
  /// The greatest value, also of those that still grew at the end of a run; or the least, if the requirement
  /// says at least. For a load: the nanoseconds in a second that a processor was busy, over a whole run.
  std::optional<analyzer::run_checker::Measured> extreme;
  bool grows = false;            // the extreme did
  bool extreme_is_open = false;  // … and need not count
  std::size_t run = 0;           // that shows it
  std::size_t breaking = 0;      // runs with a value beyond the limit, or with an event that has no response
  std::size_t unanswered = 0;    // runs with an event that has no response
  /// Runs that break nothing, and end with a value beyond the limit that still grows. It need not count,
  /// because the skill may end before it is measured, or a message may be withdrawn.
  std::size_t open = 0;
};

/// Collects the results of run after run. A load is a fraction in the long run, so no single run breaks it.
class Survey {
 public:
  explicit Survey(const analyzer::Problem& problem);

  /// False: `stop`, which is called now and then, returned true, and nothing of this run counts.
  bool add(const KnownRun& run, std::size_t number, const std::function<bool()>& stop = {});

  /// By requirement.
  const std::vector<Seen>& seen() const { return seen_; }
  std::size_t completed() const { return completed_; }
  /// Runs that are not runs of the skill, each with the rule that it breaks.
  const std::vector<std::string>& refused() const { return refused_; }

 private:
  bool measure(std::size_t requirement, const KnownRun& run, std::size_t number,
               const std::function<bool()>& stop);
  void measure_load(std::size_t requirement, const KnownRun& run, std::size_t number);

  const analyzer::Problem& problem_;
  std::vector<Seen> seen_;
  std::size_t completed_ = 0;
  std::vector<std::string> refused_;
};

/// The requirement that is shown by default: the first that a run breaks, else the one that a run comes
/// nearest to breaking. Nothing if nothing was measured.
std::optional<std::size_t> most_interesting(const analyzer::Problem& problem, const std::vector<Seen>& seen);

}  // namespace pal::program
