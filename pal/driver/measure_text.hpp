// Measures and their figures in words, as every report has them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "analyzer/problem/problem.hpp"
#include "analyzer/verdict/verdict.hpp"
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
/// The same to the last digit: of what is required, and of what adds up. "0.125 %".
std::string whole_text(analyzer::Requirement::Measure measure, Duration value);

/// The bound of a verdict, or what is known in place of one: "7.35 ms", "<= 9 ms" (a bound that no run is
/// known to attain; of a least value ">="), ">= 5 ms" (no bound, and a run that attains this), "no bound",
/// "unbounded", "never".
std::string bound_text(const analyzer::Verdict& verdict);

/// What a run attains where there is no bound; nothing of a run that attains nothing: any run does.
std::optional<Duration> worth_telling(const analyzer::Verdict& verdict);

}  // namespace pal::driver
