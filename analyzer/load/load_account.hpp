// The parts of a load.
#pragma once

#include <vector>

#include "analyzer/load/load.hpp"

namespace pal::analyzer {

/// The statements that keep the processor busy in a turn of the unending run that attains `load`, in
/// nanoseconds of work a second. They add up to per_second(load.most); the rounding goes to the longest.
/// Nothing if no run is known to attain it.
std::vector<Addend> load_account(const Problem& problem, ProcessorId processor, const LoadBound& load);

}  // namespace pal::analyzer
