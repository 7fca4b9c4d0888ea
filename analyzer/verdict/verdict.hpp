// The result of an analysis for a requirement.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"
#include "analyzer/runs/witness.hpp"
#include "analyzer/verdict/told.hpp"
#include "pal/support/source.hpp"
#include "pal/support/time.hpp"

namespace pal::analyzer {

/// never: no run has anything to measure, so the requirement says nothing.
enum class VerdictState { holds, fails, undecided, never };

/// The analysis that a verdict comes from: the exploration of all runs, or the bounds from the parts.
enum class Method { exact, compositional };

/// A piece of the time that a bound is made of.
struct Reason {
  enum class Kind { other, waits_for_message, waits_for_room };
  Nanoseconds from = 0;
  Nanoseconds to = 0;
  Kind kind = Kind::other;
  std::string actor;      // thread or device
  std::string what;       // "waits at WTM( motion request from MC1 )"
  std::string statement;  // "WTM( motion request from MC1 )"; empty: none
  std::string file;
  int line = 0;  // 0: no place in a text
  /// For a wait: what those waited for did meanwhile, without gaps from its beginning to its end, each with
  /// what is inside it. Empty: there is nothing to tell.
  std::vector<Reason> inside;

  bool waits() const { return kind != Kind::other; }
};

/// A number of the addition that makes up a bound.
struct Addend {
  Nanoseconds amount = 0;  // negative: taken away
  std::string actor;       // thread or device; "": of none
  std::string what;
  std::string file;
  int line = 0;                // 0: no place in a text
  std::vector<Addend> inside;  // of a wait: what it was spent on; they add up to its amount
};

/// The cost of a decision.
struct Statistics {
  std::size_t states = 0;       // of the skill, times aside
  std::size_t classes = 0;      // sets of times at a state (and for loads points of the grid)
  double seconds = 0;           // by Options::clock
  std::size_t peak_memory = 0;  // bytes, by Options::peak_memory

  /// Sums; the greater peak.
  Statistics& operator+=(const Statistics& other);
};

/// Events of a device that no thread takes in some run: so many of `in` in a row.
struct LostEvents {
  DeviceId device{};
  int lost = 0;
  int in = 1;
};

/// A value that grows with each turn of a loop, without bound (analyzer/runs/growing_loop.hpp).
struct LoopGrowth {
  LoopId loop;          // none: it grows, but not in one loop of one thread
  Witness first_turns;  // the beginning of the verdict's run, which is long
  std::string phase;    // "DURING REPEAT OF …", which leaves the loop out; empty: none is known that helps
};

struct Verdict {
  using State = VerdictState;
  std::string requirement;
  Requirement::Measure measure = Requirement::Measure::age;
  State state = State::undecided;
  Method method = Method::exact;
  Duration limit{};       // loss: a number
  bool at_least = false;  // no run may fall below the limit, and none falls below the bound
  /// Least value that no run exceeds, as far as is known; load: nanoseconds of work in a second, rounded up;
  /// loss: a number. Nothing: unbounded, or not known to be bounded.
  std::optional<Duration> bound;
  /// A run that was replayed attains the bound (load: comes as near to it as one likes).
  bool exact = false;
  /// Load: what an unending run was shown to have, in nanoseconds of work in a second, rounded up.
  std::optional<Duration> attained_load;
  /// The exact analysis met one of its limits before it had seen all runs.
  bool gave_up = false;
  /// The run in which the requirement comes nearest to failing, or fails first.
  std::optional<Witness> witness;
  /// Then there is no bound, the requirement fails, and `reasons` are those of the first turns.
  std::optional<LoopGrowth> loop_growth = {};
  /// For people: one paragraph.
  Told explanation;
  /// Without gaps from the birth of what is measured to its use; the lengths add up to the witness's value.
  std::vector<Reason> reasons;
  /// They add up to the bound, to the nanosecond. Empty if there is no bound, or if it is a number (of
  /// losses). Also empty if the bound was found by looking at all runs and none is known to attain it.
  std::vector<Addend> addends;
  /// Of a verdict that holds: events that get lost in some runs, and so delay nobody. Where they are kept,
  /// the bound may be greater.
  std::vector<LostEvents> taken_as_lost = {};
  SourceSpan where;
  Statistics statistics;

  /// What is allowed, with its unit. `worse` compares bounds and values.
  Limit allowed() const;
};

/// Undecided, with nothing known yet.
Verdict open_verdict(const Requirement& requirement);

/// The greatest value (the least, of a requirement that says at least) that a run was shown to attain, if the
/// verdict knows one. Load: nanoseconds of work in a second, rounded up.
std::optional<Duration> attained(const Verdict& verdict);

/// "holds", "fails", "undecided", "never".
const char* name(Verdict::State state);
/// "age", "response", "load", "reaction", "interval", "loss", "duration", "busy".
const char* name(Requirement::Measure measure);
/// "exact", "compositional".
const char* name(Method method);

}  // namespace pal::analyzer
