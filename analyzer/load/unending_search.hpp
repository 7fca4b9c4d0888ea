// Unending runs that keep a processor busy, looked for among single runs.
#pragma once

#include <functional>
#include <optional>

#include "analyzer/load/recurrence.hpp"
#include "analyzer/load/turn.hpp"

namespace pal::analyzer {

/// Random runs that stay in `recurrence`, with the actions of `processor` as long as they may be, and the
/// others as short or as long. Stretches of them that begin and end in one state are repeated. The search
/// ends with the first run whose load is `enough`, or after enough tries; then the result is the greatest
/// load found, if any. If none is found, that proves nothing.
std::optional<UnendingRun> search_unending(const Machine& machine, const ZoneGraph& graph,
                                           const Recurrence& recurrence, ProcessorId processor,
                                           const std::function<bool(const Fraction&)>& enough,
                                           const std::function<bool()>& stop);

}  // namespace pal::analyzer
