// A verdict on a program whose lines have moved, and which is otherwise the same.
#pragma once

#include <optional>

#include "analyzer/problem/problem.hpp"
#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

/// The verdict on a requirement of `from`, with the lines of `to`. The two differ in nothing but lines and
/// places, and perhaps in other requirements; the caller answers for that. Nothing: their statements differ.
/// `where` stays as it is.
std::optional<Verdict> moved(const Verdict& verdict, const Problem& from, const Problem& to);

}  // namespace pal::analyzer
