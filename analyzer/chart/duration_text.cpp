// Times as people read them in a chart.
#include "analyzer/chart/chart.hpp"

namespace pal::analyzer::chart {

namespace {

// `value` / 10^digits in decimal, without trailing zeros.
std::string decimal(std::int64_t value, std::size_t digits) {
  std::string text = std::to_string(value);
  if (text.size() <= digits) text.insert(0, digits + 1 - text.size(), '0');
  text.insert(text.size() - digits, ".");
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

// The environments speak of milliseconds, so do charts, from a hundredth of one to a second.
std::string duration_text(std::int64_t ns) {
  if (ns < 0) return "\u2212" + duration_text(-ns);
  if (ns == 0) return "0 ms";
  if (ns < 1'000) return std::to_string(ns) + " ns";
  if (ns < 10'000) return decimal(ns, 3) + " \u00b5s";
  if (ns < 1'000'000'000) return decimal(ns, 6) + " ms";
  return decimal(ns, 9) + " s";
}

std::string rounded_duration_text(std::int64_t ns) {
  if (ns < 0) return "\u2212" + rounded_duration_text(-ns);
  return duration_text(ns < 100'000 ? ns : (ns + 500) / 1'000 * 1'000);
}

}  // namespace pal::analyzer::chart
