// What a verdict says where there is no bound.
#pragma once

#include "analyzer/compositional/measures/statement_occurrences.hpp"

namespace pal::analyzer::compositional {

/// Why the nearest unbounded thread is unbounded, among `thread` itself and those that trigger it; empty:
/// none is.
Why unbounded_reason_behind(const View& view, ThreadId thread);

/// `what`, followed by unbounded_reason_behind() the thread, if there is one.
Why with_unbounded_reason(Why what, const View& view, ThreadId thread);

/// Why what several threads come to, or none, has no next one; empty: one thread comes to it.
Why why_not_one(const View& view, const std::set<ThreadId>& threads);

/// Why the next occurrence of the statements of `occurrences` in a thread is unbounded. The text calls them
/// `statement`. `goes_on`: the thread is known to continue with its jobs.
Why why_not_again(const View& view, ThreadId thread, const StatementOccurrences& occurrences, bool goes_on,
                  const std::string& statement = "it");

}  // namespace pal::analyzer::compositional
