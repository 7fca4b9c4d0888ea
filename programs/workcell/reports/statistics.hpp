// Summaries of distributions.
#pragma once

#include <string>
#include <vector>

namespace pal::workcell {

struct Distribution {
  std::size_t count = 0;
  double least = 0, median = 0, mean = 0, greatest = 0;
};

/// Of values in any order; all zero if there are none.
Distribution distribution(std::vector<double> values);

/// A bar of '#' a bin, one line each, between `low` and `high` in `bins` bins of equal width; the last
/// includes `high`. Contract: low < high, bins > 0.
std::string histogram(const std::vector<double>& values, double low, double high, int bins,
                      const std::string& unit);

}  // namespace pal::workcell
