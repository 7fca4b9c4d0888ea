// Which threads always come home.
#pragma once

#include "analyzer/compositional/measures/measures.hpp"

namespace pal::analyzer::compositional {

/// What goes on, whatever the run; `steady`: as long as no block has left its rounds.
Endurance::Threads threads_that_endure(const Problem& problem, const Forest& forest,
                                       const ThreadBehaviours& behaviours, const Times& times, bool steady);

/// Whether a thread is a block, once in a skill's life, which may end in any of its rounds.
bool may_leave(const Problem& problem, int thread);

}  // namespace pal::analyzer::compositional
