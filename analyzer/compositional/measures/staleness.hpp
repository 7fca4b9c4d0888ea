// How long ago the value was set that a thread reads.
#pragma once

#include "analyzer/compositional/measures/statement_occurrences.hpp"

namespace pal::analyzer::compositional {

/// Greatest time since the set (or since time 0) whose value `reader` may read of `condition`.
Bound value_age(const View& view, ConditionId condition, ThreadId reader);

/// Whether `thread` continues with its jobs for as long as `reader` does.
bool outlasts(const View& view, ThreadId thread, ThreadId reader);

/// Until when `reader` may read what was set in the previous job, counted from the nominal instant of a job
/// of `setter`. Usually it is until the next set. In one case it is earlier, at the release of the setting
/// segment. There the reader runs on the same preemptive processor, and only when the setter has nothing to
/// do (M. Dürr and others, 2019).
const Sum& replaced(const View& view, const StatementOccurrences& sets, ThreadId setter, ThreadId reader);

}  // namespace pal::analyzer::compositional
