// Requirements without a verdict, and why they have none. What was not checked is told in every form of a
// report, and never counts as met.
#pragma once

#include <string>
#include <vector>

#include "programs/pal/session/proof.hpp"

namespace pal::program {

/// A requirement that was not checked. Without a skill, or a skill without requirements: what would have had
/// one.
struct Unchecked {
  std::string skill;        // empty: there is none
  std::string environment;  // empty: there is none
  std::string requirement;  // empty: the skill has none
  const char* measure = "";
  Duration limit{};    // loss: a number; load: nanoseconds of work in a second
  std::string reason;  // "no environment was given"
  std::string hint;
  SourceSpan where;
  bool left_out = false;  // by --changed-since: no fault, but not checked all the same
};

/// Why something may have no proof.
enum class Unproved {
  nowhere,        // only if there is no environment
  wrong,          // the specification has errors; then only requirements are listed
  not_asked_for,  // --without-times
  ended_by_user,  // Ctrl-C
};

/// Everything in the session that got no verdict from `proofs`, in the order of skills, environments and
/// requirements.
std::vector<Unchecked> unchecked(const Session& session, const std::vector<Proof>& proofs, Unproved unproved);

/// That it was not checked, and why (PAL0892).
PartialDiagnostic finding_of(const Unchecked& unchecked);

/// Adds this finding for each of them.
void report_unchecked(const std::vector<Unchecked>& list, Session& session);

/// Whether any requirement has a verdict.
bool has_verdicts(const std::vector<Proof>& proofs);

}  // namespace pal::program
