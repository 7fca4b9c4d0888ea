// Unending runs that keep a processor busy, looked for among single runs.
#pragma once

#include <functional>
#include <optional>

#include "analyzer/load/recurrence.hpp"
#include "analyzer/load/turn.hpp"

namespace pal::analyzer {

/// Runs that stay in `recurrence` by chance, the actions of `processor` as long as they may be, the rest as
/// short or as long; stretches of them that begin and end in one state are repeated. Ends with the first
/// whose load is `enough`, or when enough was tried: then the greatest load found, if any. What is not found
/// says nothing.
std::optional<UnendingRun> search_unending(const Machine& machine, const ZoneGraph& graph,
                                           const Recurrence& recurrence, int processor,
                                           const std::function<bool(const Fraction&)>& enough,
                                           const std::function<bool()>& stop);

}  // namespace pal::analyzer
