// Problems that mean the same as others.
#pragma once

#include <random>
#include <string>

#include "analyzer/problem/problem.hpp"

namespace pal::test {

/// Tells a problem in another way, by chance: everything numbered otherwise, statements in two parts,
/// statements that stand twice, another kind of processor for a single thread, something that has nothing to
/// do with the rest. No measure changes. Says what was done.
std::string retell(analyzer::Problem& problem, std::mt19937_64& engine);

}  // namespace pal::test
