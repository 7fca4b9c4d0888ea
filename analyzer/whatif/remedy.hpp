// Which few changes make requirements hold that do not, each tried.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "analyzer/analysis.hpp"
#include "analyzer/whatif/candidates.hpp"
#include "analyzer/whatif/ids.hpp"
#include "analyzer/whatif/short_enough.hpp"

namespace pal::analyzer::whatif {

/// One change that was tried, alone or with others: of the environment, or of the program.
struct Candidate {
  Changes changes;
  ProgramChangeId program;  // valid: this one, and `changes` is empty
};

/// Changes that were tried together, and what became of each requirement.
struct Remedy {
  std::vector<CandidateId> made;
  std::vector<Verdict> after;  // by RequirementId
};

struct Remedies {
  std::vector<Verdict> before;  // by RequirementId
  std::vector<Candidate> candidates;
  /// With each of these everything holds; all have the same number of changes, the least that does.
  std::vector<Remedy> found;
  /// Where none is found: the one that comes nearest and breaks nothing that holds, if any comes nearer than
  /// things are.
  std::optional<Remedy> nearest;
  /// By requirement that does not hold.
  std::vector<ShortEnough> short_enough;
  std::size_t tried = 0;
  bool complete = true;  // the time sufficed for all that was meant to be tried
};

struct RemedyOptions {
  std::size_t most_changes = 3;  // together
  std::size_t most_found = 5;    // enough to choose from
};

/// The skill with these changes of its text; null: they cannot be made, or what comes out is wrong. The
/// network must live until find_remedies() returns.
using NetworkOf = std::function<const pan::Network*(const std::vector<ProgramChangeId>&)>;

/// Tries `programs` changes of the text, numbered from 0, and changes of the environment. First it tries each
/// alone, then those that help most in twos, then in threes. A requirement that says nothing afterwards and
/// did say something before counts as one that does not hold. Nothing is tried if everything holds as it is.
Remedies find_remedies(const pan::Network& network, const pan::Environment& environment, std::size_t programs,
                       const NetworkOf& network_of, const Options& options, const RemedyOptions& how = {});

}  // namespace pal::analyzer::whatif
