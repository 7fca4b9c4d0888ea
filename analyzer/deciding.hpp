// What the steps of a decision share: their time, and what they say of one requirement.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analyzer/analysis.hpp"

namespace pal::analyzer {

/// Classes that are explored in a moment, also where a bound says enough. A class of a skill with many
/// threads takes longer, about with their square.
std::size_t glance(const Problem& problem);

void tell(const Options& options, const Analysis& analysis);

/// Until so many percent of the time that is left are over.
Options share_of(const Options& options, double percent);

/// What the compositional analysis adds to an exact verdict.
void complete(Verdict& verdict, Verdict bound);

/// Looks for runs where nothing is decided, and where a bound is not known to be attained.
void search(const Problem& problem, const Requirement& requirement, const Options& options, Verdict& verdict);

/// Explores the requirements `open`, and puts what is found in the place of what is known by now if it says
/// more.
void explore(const Provers& provers, const Problem& problem, const Options& options,
             const std::vector<std::size_t>& open, const std::vector<Verdict>& bounds, Analysis& known);

/// A requirement of an analysis that is open, and all that is known.
struct OpenCase {
  const Provers& provers;
  const Problem& problem;
  std::size_t index;  // of the requirement
  const std::vector<Verdict>& bounds;
  Analysis& analysis;

  const Requirement& requirement() const { return problem.requirements[index]; }
  Verdict& verdict() const { return analysis.verdicts[index]; }
  bool is_open() const { return verdict().state == VerdictState::undecided; }
};

/// A way to decide a requirement: of an analysis, or of a what-if question.
template <class Case>
struct MethodFor {
  const char* name;
  bool proves;     // it may find that the requirement holds
  bool refutes;    // it may find that it fails
  double percent;  // of the time that is left
  void (*run)(const Case& open, const Options& options);
};
using DecidingMethod = MethodFor<OpenCase>;

/// In the order in which they are tried. `verdicts_only`: as Options has it.
std::span<const DecidingMethod> deciding_methods(bool verdicts_only);

/// Tries one method after the other till one decides. It ends between two of them once `options.stop` says
/// so.
template <class Case>
void decide(std::span<const MethodFor<Case>> methods, const Case& open, const Options& options) {
  for (const MethodFor<Case>& method : methods) {
    if (!open.is_open() || (options.stop && options.stop())) return;
    method.run(open, share_of(options, method.percent));
  }
}

/// Looks for runs that attain the bounds of what holds.
void look_whether_exact(const Problem& problem, const Options& options, Analysis& analysis);

}  // namespace pal::analyzer
