#include "programs/workcell/reports/range_profiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "sim/report/profile_plot.hpp"
#include "skills_pal/sensing/edge.hpp"
#include "skills_pal/sensing/nearest_point.hpp"

namespace pal::workcell {
namespace {

constexpr std::size_t most_shown = 9;
constexpr std::size_t count = skills::sensing::most_points;
// x, z and valid of each point, then when the scan began (docs/workcell/range-finder.md).
constexpr std::size_t message_size = 3 * count + 1;
constexpr double half_fan = 20 * 3.14159265358979323846 / 180;

bool is_profile(const sim::MessageLog& messages, const sim::LoggedMessage& message) {
  const auto& device = messages.devices()[message.device];
  return device.name == "range-finder" && device.ports[message.port].message == "profile" &&
         message.fields.size() == message_size;
}

/// The first and the last profile and some between, at equal steps; fewer if there are fewer.
std::vector<sim::LoggedMessage> some_profiles(const sim::MessageLog& messages) {
  std::size_t all = 0;
  messages.for_each([&](const auto& message) { all += is_profile(messages, message) ? 1 : 0; });
  const std::size_t shown = std::min(all, most_shown);
  std::vector<sim::LoggedMessage> result;
  std::size_t number = 0;
  messages.for_each([&](const auto& message) {
    if (!is_profile(messages, message)) return;
    const std::size_t i = result.size();
    if (i < shown && number == (shown == 1 ? 0 : i * (all - 1) / (shown - 1))) result.push_back(message);
    ++number;
  });
  return result;
}

/// What skills_pal/sensing looks at, which copies nothing.
struct Figures {
  std::span<const double> y, z;
  std::array<bool, count> valid{};

  explicit Figures(const sim::LoggedMessage& message)
      : y(std::span(message.fields).first(count)), z(std::span(message.fields).subspan(count, count)) {
    for (std::size_t i = 0; i < count; ++i) valid[i] = message.fields[2 * count + i] != 0;
  }
  skills::sensing::Profile profile() const { return {y, z, valid}; }
};

/// A point without a range has no place: it is shown where its ray passes at the mean depth of the others.
void add_points(sim::RangeProfile& shown, const skills::sensing::Points& points, const Figures& figures) {
  double depth = 0;
  for (std::size_t i = 0; i < points.count; ++i) depth += points.z[i] / static_cast<double>(points.count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = half_fan * (2 * static_cast<double>(i) / (count - 1) - 1);
    shown.points.push_back(figures.valid[i] ? sim::ProfilePoint{figures.y[i], figures.z[i], true}
                                            : sim::ProfilePoint{std::tan(angle) * depth, 0, false});
  }
}

void add_edge(sim::RangeProfile& shown, const skills::sensing::Points& points,
              const skills::sensing::Edge& edge) {
  const std::size_t window = skills::sensing::EdgeOptions{}.window;
  const auto* const place =
      std::lower_bound(points.index.data(), points.index.data() + points.count, edge.index);
  const auto at = static_cast<std::size_t>(place - points.index.data());
  const double begin = points.y[at - std::min(at, window)];
  const double end = points.y[std::min(at + window, points.count - 1)];
  shown.lines.push_back({begin, edge.left.at(begin), edge.y, edge.left.at(edge.y)});
  shown.lines.push_back({edge.y, edge.right.at(edge.y), end, edge.right.at(end)});
  shown.marks.push_back({"edge", edge.y, edge.z});
}

skills::sensing::EdgeOptions in_the_middle() {
  skills::sensing::EdgeOptions options;
  options.expected = 0;
  return options;
}

sim::RangeProfile interpreted(const sim::LoggedMessage& message, const std::string& title) {
  const Figures figures(message);
  sim::RangeProfile shown{title, {}, {}, {}};
  const skills::sensing::Points points = skills::sensing::valid_points(figures.profile());
  add_points(shown, points, figures);
  const auto nearest = skills::sensing::find_nearest_point(figures.profile());
  if (nearest) shown.title += fmt::format(", nearest {:.1f} mm", nearest->z);
  // Two labels may lie on one another: the edge tells more.
  if (const auto edge = skills::sensing::find_edge(figures.profile(), in_the_middle()))
    add_edge(shown, points, *edge);
  else if (nearest)
    shown.marks.push_back({"nearest", nearest->y, nearest->z});
  return shown;
}

std::string time_of(const sim::LoggedMessage& message) {
  return fmt::format("{:.2f} s", std::chrono::duration<double>(message.time).count());
}

}  // namespace

std::vector<sim::Plot> range_plots(const sim::MessageLog& messages, const std::string& title) {
  const auto some = some_profiles(messages);
  if (some.empty()) return {};
  std::vector<sim::RangeProfile> shown;
  for (const auto& message : some) shown.push_back(interpreted(message, time_of(message)));
  return {sim::profile_plot(interpreted(some.back(), title + ", " + time_of(some.back()))),
          sim::profiles_plot(shown, title)};
}

}  // namespace pal::workcell
