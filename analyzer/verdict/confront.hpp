// What a single run makes of a verdict.
#pragma once

#include "analyzer/problem/problem.hpp"
#include "analyzer/runs/witness.hpp"
#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

/// Whether the run that the verdict knows attains its bound.
bool attains(const Verdict& verdict);

/// What a run that was found by chance makes of a verdict: that it fails, that its bound is attained, or an
/// example.
void confront(const Problem& problem, const Requirement& requirement, Witness found, Verdict& verdict);

}  // namespace pal::analyzer
