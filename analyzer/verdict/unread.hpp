// Requirements on values that nobody reads.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// Of an age or a reaction of a condition: no thread that comes to one of the statements, and none whose
/// block it is, ever reads the condition. Then no run measures anything, whatever its times. False of others.
bool is_unread(const Problem& problem, const Requirement& requirement);

}  // namespace pal::analyzer
