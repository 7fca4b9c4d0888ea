// Verdicts on values that grow with each turn of a loop.
#pragma once

#include <functional>

#include "analyzer/problem/problem.hpp"
#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

/// Of a verdict without a bound: if a run shows that its value grows with each turn of a loop, the
/// requirement fails, and the verdict says so. Whether it does.
bool set_loop_growth(const Problem& problem, const Requirement& requirement,
                     const std::function<bool()>& stop, Verdict& verdict);

}  // namespace pal::analyzer
