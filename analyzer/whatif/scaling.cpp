#include "analyzer/whatif/scaling.hpp"

#include <algorithm>
#include <cassert>

namespace pal::analyzer::whatif {
namespace {

/// The model allows no longer time (problem.cpp).
constexpr Nanoseconds longest_time = 1'000'000'000'000'000;

Interval& figure(pan::Environment& environment, const std::string& name) {
  Interval* found = find_figure(environment, name);
  assert(found != nullptr);
  return *found;
}

}  // namespace

Scaling::Scaling(const pan::Environment& environment, std::vector<std::string> names)
    : environment_(environment), names_(std::move(names)) {
  pan::Environment copy = environment;
  for (const std::string& name : names_) longest_ = std::max(longest_, figure(copy, name).worst.count());
}

Nanoseconds Scaling::most() const {
  return longest_time - longest_;
}

pan::Environment Scaling::by(Nanoseconds extra) const {
  assert(extra >= 0 && extra <= most());
  pan::Environment grown = environment_;
  for (const std::string& name : names_) {
    Interval& time = figure(grown, name);
    time.worst += Duration(share(time.worst.count(), extra));
    time.worst = std::min(time.worst, Duration(longest_time));
  }
  return grown;
}

Nanoseconds Scaling::share(Nanoseconds worst, Nanoseconds extra) const {
  __extension__ using Wide = __int128;
  if (names_.size() == 1 || longest_ == 0) return extra;
  return static_cast<Nanoseconds>((static_cast<Wide>(worst) * extra + longest_ - 1) / longest_);
}

}  // namespace pal::analyzer::whatif
