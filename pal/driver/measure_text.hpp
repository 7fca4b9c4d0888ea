// Measures and their figures in words, as every report has them.
#pragma once

#include <cstddef>
#include <string>

#include "analyzer/problem.hpp"
#include "pal/support/time.hpp"

namespace pal::driver {

/// "age of pc-force at TXM( motion to MC1 ) in SM1", "response from tick of alter to TXM( correction to alter
/// )", …
std::string measure_text(const analyzer::Problem& problem, std::size_t requirement);

/// "age of pc-force", "interval", …: what a length of time in a chart is; empty for a loss and a load.
std::string short_measure_text(const analyzer::Problem& problem, std::size_t requirement);

/// A length of time, of a load its percentage, of a loss its number: "7.35 ms", "41.2 %", "none". A bound's
/// percentage is rounded up.
std::string figure_text(analyzer::Requirement::Measure measure, Duration value);

}  // namespace pal::driver
