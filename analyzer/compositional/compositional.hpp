// Compositional analysis: bounds that no run exceeds, without exploring runs. For systems that are too large
// for the exact analysis; what it is built on is in docs/internals/compositional.md.
#pragma once

#include "analyzer/compositional/causes/withheld.hpp"
#include "analyzer/exact/exact.hpp"

namespace pal::analyzer::compositional {

/// One verdict a requirement: `holds` or `undecided`, never `fails`, never exact, without a witness. Takes
/// time that grows about as the number of steps, as long as chains and processors do not grow with it.
/// `options.max_states` is not used. Statistics count segments as states. `half_open`: with half-open windows
/// (WindowEnds). `set_aside`: for tests.
Analysis analyze(const Problem& problem, const Options& options = {}, bool half_open = false,
                 const SetAside& set_aside = {});

}  // namespace pal::analyzer::compositional
