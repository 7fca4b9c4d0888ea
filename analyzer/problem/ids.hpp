// Typed indices of the things that a problem is made of.
#pragma once

#include "pal/pan/ids.hpp"
#include "pal/support/id.hpp"

namespace pal::analyzer {

/// In Problem::statements.
using StatementId = Id<struct StatementTag>;

}  // namespace pal::analyzer
