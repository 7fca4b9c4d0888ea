// Requirements on values that no thread reads.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// True for an age or a reaction of a condition that is never read. No thread that comes to one of the
/// statements reads it, and no parent of such a block. Then no run measures anything, whatever its times.
/// False for other measures.
bool is_unread(const Problem& problem, const Requirement& requirement);

}  // namespace pal::analyzer
