// What is proved of a requirement against runs that were made without the analyzer.
#pragma once

#include <string>

#include "analyzer/verdict/verdict.hpp"
#include "tests/support/runs/all_runs.hpp"

namespace pal::test {

/// `seen` of the requirement, up to `cap` of `unit`, against its verdict; what contradicts, or nothing.
std::string contradiction(const Wanted& wanted, const Seen& seen, const analyzer::Verdict& verdict,
                          Duration unit, int cap);

}  // namespace pal::test
