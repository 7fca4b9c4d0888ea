// One CONCURRENT a thread.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer::compositional {

/// The same skill, in which each block is begun by one CONCURRENT. A thread that executes a module in several
/// places begins the same blocks in each; here it has blocks of its own for each place. They are never there
/// at the same time, so the runs are the same. What is required of a step is required of its copies.
Problem clone_shared_blocks(const Problem& problem);

}  // namespace pal::analyzer::compositional
