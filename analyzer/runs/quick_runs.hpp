// A few random runs with worst times: cheap, and often enough to break a requirement.
#pragma once

#include <functional>
#include <optional>

#include "analyzer/runs/witness.hpp"

namespace pal::analyzer {

/// How a run breaks a requirement: by a measured value, or by one that has only grown by its end.
enum class Break { none, measured, grown };

/// Whether one of the runs breaks `requirement`; `none` proves nothing. Loads and losses are not checked, nor
/// skills that do not fit a simulation.
Break simulated_break(const Problem& problem, const Requirement& requirement,
                      const std::function<bool()>& stop);

/// The run for which simulated_break says so, or one of some hundreds with times at their extremes, up to
/// where it breaks `requirement`. Nothing if there is none, or only a run of very many events.
std::optional<Witness> simulated_witness(const Problem& problem, const Requirement& requirement,
                                         const std::function<bool()>& stop);

}  // namespace pal::analyzer
