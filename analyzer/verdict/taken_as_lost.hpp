// What a verdict counts as lost: events that no thread takes delay nobody.
#pragma once

#include <functional>
#include <vector>

#include "analyzer/problem/problem.hpp"
#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

/// Devices whose events get lost in runs that were made, each with the greatest number in a row of
/// LostEvents::in. `never_lost`: those that are known to lose none; empty: none is known. Devices whose
/// losses a requirement limits are left out, because that says it. If none is found, that proves nothing.
std::vector<LostEvents> lost_events(const Problem& problem, const Table<DeviceId, bool>& never_lost,
                                    const std::function<bool()>& stop);

/// Puts those of `lost` that may have an influence on a requirement beside each verdict that holds. The
/// events that it measures itself are not among them: their loss is measured.
void set_taken_as_lost(const Problem& problem, const std::vector<LostEvents>& lost,
                       std::vector<Verdict>& verdicts);

}  // namespace pal::analyzer
