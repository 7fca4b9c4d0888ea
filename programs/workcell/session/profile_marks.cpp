#include "programs/workcell/session/profile_marks.hpp"

#include <algorithm>
#include <array>

#include "skills_pal/sensing/edge.hpp"
#include "skills_pal/sensing/nearest_point.hpp"

namespace pal::workcell {
namespace {

namespace sensing = skills::sensing;

server::ProfileMark along(const char* name, const sensing::Line& line, double from, double to) {
  return {name, {{from, line.at(from)}, {to, line.at(to)}}, line.angle(), "deg"};
}

}  // namespace

std::vector<server::ProfileMark> profile_marks(const server::Profile& profile) {
  std::vector<server::ProfileMark> marks;
  const std::size_t count = std::min(profile.y.size(), sensing::most_points);
  if (count < 2) return marks;
  // The whole scan again, since an edge may lie where points have no range.
  std::array<double, sensing::most_points> y{}, z{};
  std::array<bool, sensing::most_points> valid{};
  std::size_t scanned = 0, given = 0;
  auto gap = profile.missing.begin();
  for (; scanned < std::min(profile.scanned, sensing::most_points); ++scanned) {
    if (gap != profile.missing.end() && scanned >= gap->second) ++gap;
    if (gap != profile.missing.end() && scanned >= gap->first) continue;
    if (given == count) break;
    y[scanned] = profile.y[given];
    z[scanned] = profile.z[given++];
    valid[scanned] = true;
  }
  const sensing::Profile scan{std::span(y).first(scanned), std::span(z).first(scanned),
                              std::span(valid).first(scanned)};
  const auto [first, last] = std::ranges::minmax(profile.y);
  sensing::EdgeOptions options;
  options.expected = 0;
  if (const auto edge = sensing::find_edge(scan, options)) {
    constexpr double seen_of_a_line = 60;  // mm
    marks.push_back(along("left", edge->left, std::max(first, edge->y - seen_of_a_line), edge->y));
    marks.push_back(along("right", edge->right, edge->y, std::min(last, edge->y + seen_of_a_line)));
    marks.push_back({"edge", {{edge->y, edge->z}}, edge->y, "mm"});
  } else {
    const sensing::Points points = sensing::valid_points(scan);
    if (points.count >= 2) {
      const double noise = sensing::noise_of(points);
      marks.push_back(along("surface", sensing::fit_line(points, {0, points.count}, noise), first, last));
    }
  }
  if (const auto nearest = sensing::find_nearest_point(scan))
    marks.push_back({"nearest", {{nearest->y, nearest->z}}, nearest->z, "mm"});
  return marks;
}

}  // namespace pal::workcell
