// Typed indices of what a designer asks about.
#pragma once

#include <vector>

#include "pal/support/id.hpp"

namespace pal::analyzer {

/// In Problem::requirements.
using RequirementId = Id<struct ProblemRequirementTag>;
using RequirementIds = std::vector<RequirementId>;

/// In Environment::processors, and on into those that were added.
using ProcessorId = Id<struct EnvironmentProcessorTag>;

/// Of a change that somebody may make to the text of a program; who knows the texts numbers them.
using ProgramChangeId = Id<struct ProgramChangeTag>;

/// In Remedies::candidates.
using CandidateId = Id<struct RemedyCandidateTag>;

}  // namespace pal::analyzer
