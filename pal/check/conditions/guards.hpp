// What a guard reads, and whether it holds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "pal/pan/network.hpp"

namespace pal::check::conditions {

/// A test with more conditions than this is not tried with all values: 10 conditions have 2^10.
constexpr std::size_t most_read_at_once = 10;

/// `read` gives the value of a condition.
template <class Read>
bool holds(const pan::Guard& guard, const Read& read) {
  const auto inner = [&](const pan::Guard& term) { return holds(term, read); };
  switch (guard.kind) {
    case pan::Guard::Kind::equals:
      return read(guard.condition) == guard.value;
    case pan::Guard::Kind::all_of:
      return std::all_of(guard.terms.begin(), guard.terms.end(), inner);
    case pan::Guard::Kind::any_of:
      return std::any_of(guard.terms.begin(), guard.terms.end(), inner);
    case pan::Guard::Kind::negation:
      return !inner(guard.terms.front());
  }
  return false;
}

/// Adds the conditions of a guard, each once, in the order of the text.
void conditions_of(const pan::Guard& guard, std::vector<pan::ConditionId>& result);

}  // namespace pal::check::conditions
