#include "programs/workcell/reports/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "programs/workcell/reports/statistics.hpp"
#include "sim/contact_stiffness.hpp"

namespace pal::workcell {
namespace {

double in_milliseconds(runtime::Time time) {
  return static_cast<double>(time.count()) / 1e6;
}

bool touched(const SweepRun& run) {
  return !run.fault && run.completion == 0;
}

}  // namespace

bool Comparison::agrees() const {
  return std::abs(resting_difference - predicted) <= 0.25 * std::abs(predicted);
}

std::optional<Comparison> compare(const std::vector<SweepRun>& first, const std::vector<SweepRun>& second,
                                  const sim::Scene& scene, double speed) {
  Comparison result;
  result.speed = speed;
  double rest_first = 0, rest_second = 0;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    if (!touched(first[i]) || !touched(second[i]) || !first[i].age || !second[i].age) continue;
    ++result.pairs;
    result.age_difference += in_milliseconds(*second[i].age - *first[i].age);
    result.peak_difference += second[i].peak_force - first[i].peak_force;
    rest_first += first[i].resting_force;
    rest_second += second[i].resting_force;
    if (second[i].peak_force > first[i].peak_force) ++result.second_higher;
  }
  if (result.pairs == 0) return std::nullopt;
  const auto pairs = static_cast<double>(result.pairs);
  result.age_difference /= pairs;
  result.peak_difference /= pairs;
  rest_first /= pairs;
  rest_second /= pairs;
  result.resting_difference = rest_second - rest_first;
  // At least 2 N apart, so that there is something to measure where the two orders press alike.
  const double low = std::min(rest_first, rest_second);
  result.stiffness = sim::contact_stiffness(scene, low, std::max(low + 2, std::max(rest_first, rest_second)));
  result.predicted = speed * result.age_difference * 1e-3 * result.stiffness;
  return result;
}

std::string describe(const std::string& skill, const std::vector<SweepRun>& runs, double low, double high) {
  std::vector<double> overshoots;
  for (const SweepRun& run : runs)
    if (touched(run)) overshoots.push_back(run.overshoot);
  const Distribution figures = distribution(overshoots);
  std::string text = fmt::format("{}: overshoot past the threshold, {} of {} runs touched\n", skill,
                                 overshoots.size(), runs.size());
  if (overshoots.empty()) return text;
  text += fmt::format("  least {:.1f} N, median {:.1f} N, mean {:.1f} N, greatest {:.1f} N\n", figures.least,
                      figures.median, figures.mean, figures.greatest);
  runtime::Time greatest{};
  for (const SweepRun& run : runs)
    greatest = std::max(greatest, run.greatest_age.value_or(runtime::Time::zero()));
  text += fmt::format("  greatest age of pc-force at any motion of any run: {:.2f} ms\n",
                      in_milliseconds(greatest));
  return text + histogram(overshoots, low, high, 12, "N");
}

std::string describe(const Comparison& comparison, const std::string& first, const std::string& second) {
  std::string text;
  text += fmt::format("{} against {}, means over {} pairs of runs\n", second, first, comparison.pairs);
  text += fmt::format("  the last motion was decided on a force that was older by {:.1f} ms\n",
                      comparison.age_difference);
  text += fmt::format("  predicted: {:g} mm/s x {:.1f} ms x {:.2f} N/mm = {:.1f} N more\n", comparison.speed,
                      comparison.age_difference, comparison.stiffness, comparison.predicted);
  text += fmt::format(
      "  measured:  {:.1f} N more at rest, {:.1f} N more at the peak; higher peak in {} of {} pairs\n",
      comparison.resting_difference, comparison.peak_difference, comparison.second_higher, comparison.pairs);
  text += comparison.agrees() ? "  the arm presses as the ages predict (at rest, within a quarter)\n"
                              : "  the arm does not press as the ages predict (at rest, within a quarter)\n";
  return text;
}

}  // namespace pal::workcell
