// The arithmetic of a bound, as a person would write it down.
#pragma once

#include "analyzer/compositional/measures/measures.hpp"
#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer::compositional {

/// What adds up to a bound, to the nanosecond: actions, interference, waits and messages on the way to the
/// latest instants that it is made of, each with its place in the text; what is known of the earliest
/// instants is taken away. Nothing if there are more than a person would read.
std::vector<Addend> breakdown_of(const View& view, const Sum& bound);

}  // namespace pal::analyzer::compositional
