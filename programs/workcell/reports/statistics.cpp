#include "programs/workcell/reports/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace pal::workcell {

Distribution distribution(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  Distribution result;
  result.count = values.size();
  result.least = values.front();
  result.greatest = values.back();
  result.median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return result;
}

std::string histogram(const std::vector<double>& values, double low, double high, int bins,
                      const std::string& unit) {
  const double width = (high - low) / bins;
  std::vector<int> counts(static_cast<std::size_t>(bins), 0);
  for (const double value : values) {
    const int bin = std::clamp(static_cast<int>((value - low) / width), 0, bins - 1);
    ++counts[static_cast<std::size_t>(bin)];
  }
  std::string text;
  for (int bin = 0; bin < bins; ++bin) {
    const int count = counts[static_cast<std::size_t>(bin)];
    text += fmt::format("  {:6.1f} to {:6.1f} {} |{:<30}{}\n", low + bin * width, low + (bin + 1) * width,
                        unit, std::string(static_cast<std::size_t>(std::min(count, 30)), '#'),
                        count > 0 ? fmt::format(" {}", count) : "");
  }
  return text;
}

}  // namespace pal::workcell
