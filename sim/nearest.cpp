#include "sim/nearest.hpp"

#include <algorithm>
#include <numeric>

namespace pal::sim {
namespace {

// Levenshtein's distance, one row at a time.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string> nearest_name(const std::string& wanted, const std::vector<std::string>& names) {
  const std::size_t least = wanted.size() < 4 ? 1 : 2;
  std::size_t best = std::max(least, wanted.size() / 3) + 1;
  std::optional<std::string> result;
  for (const std::string& name : names) {
    const std::size_t changes = distance(wanted, name);
    if (changes >= best) continue;
    best = changes;
    result = name;
  }
  return result;
}

}  // namespace pal::sim
