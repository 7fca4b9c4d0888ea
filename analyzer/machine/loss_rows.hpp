// Rows of losses: how many of a long row are lost, by what is known of shorter ones.
#pragma once

#include <utility>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// The machine follows no longer rows. What it finds of this row bounds the longer ones.
constexpr int longest_followed_row = 100;

/// At most so many of `in` in a row are lost, where so many (second) of each shorter row (first) are.
int most_lost(int in, const std::vector<std::pair<int, int>>& shorter);

/// A bound on what the machine measures as a bound on what is required: it differs for rows that are too long
/// to be followed.
Nanoseconds bound_of_row(const Requirement& requirement, Nanoseconds followed);

}  // namespace pal::analyzer
