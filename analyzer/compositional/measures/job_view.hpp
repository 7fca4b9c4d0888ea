// Properties of a thread's jobs that several measures need.
#pragma once

#include "analyzer/compositional/measures/measures.hpp"

namespace pal::analyzer::compositional {

/// Whether a node belongs to a job of its thread. What a thread does before its first job does not.
bool in_job(const View& view, NodeId node);

/// Whether a thread is a block that its parent starts in each of its jobs. Each start is then a job of the
/// block.
bool starts_in_jobs(const View& view, ThreadId thread);

/// Whether a thread begins and continues with its jobs in every run, as long as it is not cancelled.
bool goes_on(const View& view, ThreadId thread);

/// The recurring source of a thread's jobs; none: there is none, or there are several.
SourceId recurring_source(const View& view, ThreadId thread);

/// Whether a node belongs to a job of the recurring source.
bool in_recurring_job(const View& view, NodeId node);

/// Whether every occurrence of the recurring source triggers a job, as long as the thread is idle.
bool regular(const View& view, ThreadId thread);

/// Whether a thread's jobs come in the order of the occurrences of its recurring source. They do if there is
/// only one path from the source to the job. On one of several paths a later occurrence may overtake an
/// earlier one.
bool in_order(const View& view, ThreadId thread);

/// Nodes of the step's thread that contain it.
std::vector<NodeId> nodes_with(const View& view, StepId step);

/// The threads that own the steps of `at`.
std::set<ThreadId> owners(const View& view, const Table<StepId, bool>& at);

}  // namespace pal::analyzer::compositional
