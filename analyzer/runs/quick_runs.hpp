// A few runs by chance with worst times: cheap, and often enough to break a requirement.
#pragma once

#include <functional>
#include <optional>

#include "analyzer/runs/witness.hpp"

namespace pal::analyzer {

/// How a run breaks a requirement: by what it measures, or by what has only grown by its end.
enum class Break { none, measured, grown };

/// Whether one of the runs breaks `requirement`; `none` says nothing. Loads and losses are not looked at,
/// nor skills that do not fit a simulation.
Break simulated_break(const Problem& problem, const Requirement& requirement,
                      const std::function<bool()>& stop);

/// How many events of simulated runs are worth their time where `classes` classes may be explored.
std::size_t events_for(std::size_t classes);

/// A run up to where it breaks `requirement`; nothing: none of these does. Looked at are the run for which
/// simulated_break says so, some hundreds with times at their extremes, and a few in which loops go on for
/// long. The last ones have half of `events` for themselves; the others together have at most `events`
/// events.
std::optional<Witness> simulated_witness(const Problem& problem, const Requirement& requirement,
                                         const std::function<bool()>& stop, std::size_t events);

}  // namespace pal::analyzer
