// Measures and their figures in words, as every report has them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "analyzer/problem/problem.hpp"
#include "analyzer/verdict/verdict.hpp"
#include "pal/support/time.hpp"

namespace pal::program {

/// "age of pc-force at TXM( motion to MC1 ) in SM1", "response from tick of alter to TXM( correction to alter
/// )", …
std::string measure_text(const analyzer::Problem& problem, std::size_t requirement);

/// "age of pc-force", "interval", …: the name of a length of time in a chart; empty for a loss and a load.
std::string short_measure_text(const analyzer::Problem& problem, std::size_t requirement);

/// A length of time ("7.35 ms"), the percentage of a load ("41.2 %"), or the number of a loss ("none"). The
/// percentage of a bound is rounded up.
std::string text(analyzer::Figure figure);
/// The same to the last digit, for limits and for the parts of a bound: "0.125 %".
std::string whole_text(analyzer::Figure figure);

/// A value of what is measured, with its unit.
analyzer::Figure figure_of(analyzer::Requirement::Measure measure, Duration value);

/// The bound of a verdict, or what is known instead of one:
/// - "7.35 ms": a run attains it;
/// - "<= 9 ms": a bound that no run is known to attain (">=" for a least value);
/// - ">= 5 ms": no bound, and a run that attains this;
/// - "unbounded": it is known that there is no bound;
/// - "no bound", "never".
std::string bound_text(const analyzer::Verdict& verdict);

/// What a run attains where there is no bound. Nothing if that is 0, which any run attains.
std::optional<Duration> worth_telling(const analyzer::Verdict& verdict);

}  // namespace pal::program
