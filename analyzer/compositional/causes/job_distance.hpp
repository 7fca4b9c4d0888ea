// Least times between jobs of a thread, and between effects of its steps.
#pragma once

#include <vector>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// Whether a segment may run more than once in the life of a skill.
bool recurrent(const Problem& problem, const Beginning& beginning);

/// The CONCURRENT that starts a block, if there is one.
StepId fork_of(const Problem& problem, ThreadId block);

/// Whether a block has no loop, so that its length is bounded by its actions and waits.
bool ends_straight(const Problem& problem, ThreadId block);

/// Least time between the starts of two jobs of one thread that begin in this way.
Nanoseconds least_job_distance(const Problem& problem, const Beginning& beginning);

/// Whether a free-running thread, whose jobs begin so, always has to wait between two jobs. It has to if its
/// time-out takes time, or if it is idle after each request before the answer can arrive. Interference does
/// not matter: the thread sends the request while it has its processor. `owned`: its steps.
bool waits_between_jobs(const Problem& problem, const Beginning& job, const Table<StepId, bool>& owned);

/// Least time between two effects of the steps `at` of one thread, on the shortest path; 0 if its blocks
/// start repeatedly.
Nanoseconds least_effect_distance(const Problem& problem, ThreadId thread, const Table<StepId, bool>& at);

}  // namespace pal::analyzer::compositional
