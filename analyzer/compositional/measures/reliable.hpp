// Which threads always return to their idle wait.
#pragma once

#include "analyzer/compositional/measures/measures.hpp"

namespace pal::analyzer::compositional {

/// The threads that make progress in every run; `steady`: as long as no block has left its loop.
Endurance::Threads threads_that_endure(const Problem& problem, const Forest& forest,
                                       const ThreadBehaviours& behaviours, const Times& times, bool steady);

/// Whether a thread is a block that starts once in a skill's life and may end in any of its jobs.
bool may_leave(const Problem& problem, ThreadId thread);

}  // namespace pal::analyzer::compositional
