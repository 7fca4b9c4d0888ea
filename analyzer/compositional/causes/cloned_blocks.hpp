// Clones of blocks that several CONCURRENT statements share.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer::compositional {

/// The same skill with a clone of each shared block, so that each block is started by one CONCURRENT only. A
/// thread that executes a module in several places shares its blocks between them. The clones never run at
/// the same time, so the runs are the same. A requirement on a step also holds for its clones.
Problem clone_shared_blocks(const Problem& problem);

}  // namespace pal::analyzer::compositional
