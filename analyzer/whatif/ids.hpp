// Typed indices of what a designer asks about.
#pragma once

#include <vector>

#include "analyzer/problem/ids.hpp"

namespace pal::analyzer::whatif {

using RequirementIds = std::vector<RequirementId>;

/// Of a change that may be made to the text of a program. The owner of the texts numbers them.
using ProgramChangeId = Id<struct ProgramChangeTag>;

/// In Remedies::candidates.
using CandidateId = Id<struct RemedyCandidateTag>;

}  // namespace pal::analyzer::whatif
