#include "pal/support/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace pal {

namespace {

// Twice the number of slips, so that a letter in the wrong case can count as half of one.
using Cost = std::size_t;
constexpr Cost slip = 2;

Cost replace(char a, char b) {
  if (a == b) return 0;
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return lower(a) == lower(b) ? slip / 2 : slip;
}

// Damerau's distance in its restricted form (optimal string alignment).
Cost distance(std::string_view a, std::string_view b) {
  std::vector<Cost> before_last(b.size() + 1);
  std::vector<Cost> last(b.size() + 1);
  std::vector<Cost> current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j * slip;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i * slip;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      current[j] =
          std::min({last[j] + slip, current[j - 1] + slip, last[j - 1] + replace(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], before_last[j - 2] + slip);
      }
    }
    std::swap(before_last, last);
    std::swap(last, current);
  }
  return last[b.size()];
}

}  // namespace

std::optional<std::string> nearest(std::string_view name, const std::vector<std::string>& candidates) {
  // Names of this length are not misspellings, and comparing hostile ones would take long.
  constexpr std::size_t longest = 200;
  if (name.size() > longest) return std::nullopt;
  // Less than a third would find nothing for names such as LS1.
  const Cost limit = std::max<Cost>(slip, name.size() * slip / 3);
  std::optional<std::string> best;
  Cost best_cost = limit + 1;
  for (const auto& candidate : candidates) {
    if (candidate.size() > longest || candidate == name) continue;
    const auto longer = std::max(candidate.size(), name.size()) - std::min(candidate.size(), name.size());
    if (longer * slip >= best_cost) continue;
    const auto cost = distance(name, candidate);
    if (cost < best_cost) {
      best_cost = cost;
      best = candidate;
    }
  }
  return best;
}

}  // namespace pal
