// Requirements on values that no thread reads.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// For an age or a reaction of a condition: no thread that comes to one of the statements, and no parent of
/// such a block, ever reads the condition. Then no run measures anything, whatever its times. False for other
/// measures.
bool is_unread(const Problem& problem, const Requirement& requirement);

}  // namespace pal::analyzer
