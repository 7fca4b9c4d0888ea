// How soon a thread can come back to where it was.
#pragma once

#include <vector>

#include "analyzer/compositional/causes/segment.hpp"

namespace pal::analyzer::compositional {

/// Whether a segment may run more than once in the life of a skill, whatever causes it.
bool recurrent(const Problem& problem, const Beginning& beginning);

/// The CONCURRENT that starts a block; -1: none.
int fork_of(const Problem& problem, int block);

/// Whether a block comes to its end, if it does, without going round: what it does is bounded by what it
/// waits for.
bool ends_straight(const Problem& problem, int block);

/// Least time between two beginnings of a segment of one thread.
Nanoseconds least_job_distance(const Problem& problem, const Beginning& beginning);

/// Whether a thread that goes on by itself, with rounds that begin so, surely has to wait when it comes home:
/// it gives up only after some time, or is there sooner after each request than the answer can be. It
/// need not keep up with others for that: what it asks, it asks while it has its processor. `owned`: its
/// steps.
bool waits_between_jobs(const Problem& problem, const Beginning& job, const std::vector<bool>& owned);

/// Least time between two effects of the steps `at` of one thread, by the shortest way; 0: its blocks begin
/// again and again.
Nanoseconds least_effect_distance(const Problem& problem, int thread, const std::vector<bool>& at);

}  // namespace pal::analyzer::compositional
