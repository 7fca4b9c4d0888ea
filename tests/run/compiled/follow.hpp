// Whether what `pal simulate` runs by can make the run that the runtime made.
#pragma once

#include <string>

#include "analyzer/problem/problem.hpp"
#include "pal/runtime/cost_policy.hpp"
#include "pal/trace/trace.hpp"

namespace pal::test {

/// Lets the simulator's machine follow `run` event by event. At each instant it must bring about just what
/// the run has there, with timers that are due. `costs`: of statements and messages, as the run was made;
/// devices take any time that they may. Orders and outcomes that the skill leaves open are looked for. Gives
/// where the machine cannot follow; empty: it could to the end. `run` has the tables of `problem`.
std::string not_followed(const analyzer::Problem& problem, const trace::Trace& run,
                         runtime::CostPolicy costs);

}  // namespace pal::test
