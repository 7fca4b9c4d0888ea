#include "analyzer/machine/loss_rows.hpp"

#include <algorithm>
#include <cstdint>

namespace pal::analyzer {
namespace {

/// Longer rows are cut into equal ones, instead of in the best way.
constexpr int longest_cut = 20'000;

}  // namespace

int most_lost(int in, const std::vector<std::pair<int, int>>& shorter) {
  if (in > longest_cut) {
    int least = in;
    for (const auto& [row, lost] : shorter) {
      const std::int64_t rows = static_cast<std::int64_t>(in / row) * lost;
      least = static_cast<int>(std::min<std::int64_t>(least, rows + std::min(lost, in % row)));
    }
    return least;
  }
  std::vector<int> most(static_cast<std::size_t>(in) + 1);
  for (int length = 1; length <= in; ++length) {
    int& here = most[static_cast<std::size_t>(length)];
    here = length;
    for (const auto& [row, lost] : shorter)
      here = std::min(here, row >= length ? lost : lost + most[static_cast<std::size_t>(length - row)]);
  }
  return most.back();
}

Nanoseconds bound_of_row(const Requirement& requirement, Nanoseconds followed) {
  const bool longer =
      requirement.measure == Requirement::Measure::loss && requirement.in > longest_followed_row;
  if (!longer) return followed;
  return most_lost(requirement.in, {{longest_followed_row, static_cast<int>(followed)}});
}

}  // namespace pal::analyzer
