// What is known of a thread's rounds, asked by several measures.
#pragma once

#include "analyzer/compositional/measures/measures.hpp"

namespace pal::analyzer::compositional {

/// Whether a node belongs to one of its thread's rounds, not to what the thread does before them.
bool in_job(const View& view, int node);

/// The one source of a thread's rounds; -1: it has none, or several.
int source_of_jobs(const View& view, int thread);

/// Whether a thread is a block that its parent starts in each of its rounds: these are its rounds, too.
bool starts_in_jobs(const View& view, int thread);

/// Whether a thread begins, and goes on with its rounds, however the run, as long as it is not cancelled.
bool goes_on(const View& view, int thread);

/// The one source of a thread's rounds that occurs again and again; -1: there is none, or there are several.
int recurring_source(const View& view, int thread);

/// Whether a node belongs to a round of that source.
bool in_recurring_job(const View& view, int node);

/// Whether every occurrence of the paced source of a thread's rounds brings one about, as long as the thread
/// is at home.
bool regular(const View& view, int thread);

/// Whether a thread's rounds come in the order of what its paced source brings about: in one way only. Of
/// several ways a later one may be the faster, and overtake: then the next round is not that of the next
/// occurrence.
bool in_order(const View& view, int thread);

/// Nodes of the step's thread that contain it.
std::vector<int> nodes_with(const View& view, int step);

/// The threads that own the steps of `at`.
std::set<int> owners(const View& view, const std::vector<bool>& at);

}  // namespace pal::analyzer::compositional
