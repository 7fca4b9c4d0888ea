// The parts of a bound without a run, for `pal check --explain`.
#pragma once

#include "analyzer/compositional/measures/measures.hpp"
#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer::compositional {

/// The addends of a bound; they add up to the nanosecond. They are the actions, interference, waits and
/// messages on the way to its latest instants. Each has its place in the text. The earliest instants that the
/// bound subtracts are negative addends. Empty if there are too many to read.
std::vector<Addend> breakdown_of(const View& view, const Sum& bound);

}  // namespace pal::analyzer::compositional
