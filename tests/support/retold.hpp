// Problems that mean the same as others.
#pragma once

#include <random>
#include <string>

#include "analyzer/problem/problem.hpp"

namespace pal::test {

/// Tells a problem in another way, at random. It may number everything again, split a statement in two, or
/// write statements twice. It may give a lone thread another kind of processor, or add something that has
/// nothing to do with the rest. No measure changes. Says what was done.
std::string retell(analyzer::Problem& problem, std::mt19937_64& engine);

}  // namespace pal::test
