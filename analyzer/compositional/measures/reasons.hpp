// What a verdict says where there is no bound.
#pragma once

#include "analyzer/compositional/measures/statement_occurrences.hpp"

namespace pal::analyzer::compositional {

/// Why the nearest unbounded thread is unbounded, among `thread` itself and those that trigger it; empty:
/// none is.
std::string unbounded_reason_behind(const View& view, ThreadId thread);

/// `what`, followed by unbounded_reason_behind() the thread, if there is one.
std::string with_unbounded_reason(const std::string& what, const View& view, ThreadId thread);

/// Why the next occurrence of the statements of `occurrences` in a thread is unbounded. The text calls them
/// `statement`. `goes_on`: the thread is known to continue with its jobs.
std::string why_not_again(const View& view, ThreadId thread, const StatementOccurrences& occurrences,
                          bool goes_on, const std::string& statement = "it");

}  // namespace pal::analyzer::compositional
