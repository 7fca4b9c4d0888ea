// What a verdict says where there is no bound.
#pragma once

#include "analyzer/compositional/measures/statement_occurrences.hpp"

namespace pal::analyzer::compositional {

/// The trouble of the nearest thread among those that bring about what `thread` does, itself first; empty:
/// none of them is in trouble.
std::string unbounded_reason_behind(const View& view, int thread);

/// `what`, and what that comes from, if unbounded_reason_behind() the thread is known.
std::string with_unbounded_reason(const std::string& what, const View& view, int thread);

/// Why it is not known when a thread comes to the statements of `occurrences` again, which are called
/// `statement`; `goes_on`: it is known to go on with its rounds.
std::string why_not_again(const View& view, int thread, const StatementOccurrences& occurrences, bool goes_on,
                          const std::string& statement = "it");

}  // namespace pal::analyzer::compositional
