#include "skills_pal/sensing/edge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pal::skills::sensing {
namespace {

// How much better two lines must be than one. A test holds that 1000 planes and 1000 waves show no edge.
constexpr double clear = 12;
constexpr double overshadowing = 3;                       // times as clear
constexpr double on_the_line = 3.5;                       // deviations
constexpr double spacing_slack = 1.5;                     // points
constexpr double steepest = 75 * std::numbers::pi / 180;  // of what the range finder gives a point
constexpr std::size_t beside_the_place = 2;  // points by which the search may miss the end of a surface

struct Point {
  double y = 0;
  double z = 0;
};

class Search {
 public:
  /// `points`: those of the profile that count.
  Search(const Profile& profile, const Points& points, const EdgeOptions& options)
      : profile_(profile), points_(points), options_(options), noise_(noise_of(points)), sums_(points) {}

  std::optional<Edge> best() const {
    std::optional<Edge> best;
    double best_rank = 0;
    for (std::size_t place = options_.least_side; place + options_.least_side <= points_.count; ++place) {
      const double here = clearness(place);
      if (here < clear || !is_peak(place, here) || overshadowed(place, here)) continue;
      const std::optional<Edge> edge = measure(place);
      if (!edge) continue;
      const double rank = options_.expected ? -std::abs(edge->y - *options_.expected) : here;
      if (!best || rank > best_rank) {
        best = edge;
        best_rank = rank;
      }
    }
    return best;
  }

 private:
  std::size_t side(std::size_t place) const {
    return std::min({options_.window, place, points_.count - place});
  }

  // What the second line takes off the squares, each of its three figures, in terms of what noise alone
  // leaves.
  double clearness(std::size_t place) const {
    const std::size_t n = side(place);
    const double two = sums_.residual({place - n, place}) + sums_.residual({place, place + n});
    const double one = sums_.residual({place - n, place + n});
    const auto freedom = static_cast<double>(2 * n - 4);
    return (one - two) / 3 / std::max(two / freedom, noise_ * noise_);
  }

  bool is_peak(std::size_t place, double here) const {
    const std::size_t reach = options_.least_side;
    const std::size_t first = std::max(options_.least_side, place > reach ? place - reach : 0);
    const std::size_t last = std::min(points_.count - options_.least_side, place + reach);
    for (std::size_t other = first; other <= last; ++other) {
      const double there = clearness(other);
      if (there > here || (there == here && other < place)) return false;
    }
    return true;
  }

  // One of the two sides holds a much clearer edge: neither line is that of a surface.
  bool overshadowed(std::size_t place, double here) const {
    const std::size_t reach = side(place);
    for (std::size_t other = std::max(options_.least_side, place - reach);
         other <= std::min(points_.count - options_.least_side, place + reach); ++other)
      if (clearness(other) > overshadowing * here) return true;
    return false;
  }

  // What the search looked at on either side. The points at the edge itself may belong to both.
  Stretch seed_left(std::size_t place) const { return {place - side(place), place - 1}; }
  Stretch seed_right(std::size_t place) const { return {place + 1, place + side(place)}; }

  // From the edge outwards.
  Line line_left(std::size_t place) const {
    const Stretch seed = seed_left(place);
    return grow_line(points_, seed, {place - std::min(place, options_.longest_side), seed.end}, noise_).line;
  }

  Line line_right(std::size_t place) const {
    const Stretch seed = seed_right(place);
    const std::size_t last = std::min(points_.count, place + options_.longest_side);
    return grow_line(points_, seed, {seed.begin, last}, noise_).line;
  }

  // Without the growing, which follows a curved surface too far.
  bool turns(std::size_t place) const {
    const double left = fit_line(points_, seed_left(place), noise_).angle();
    const double right = fit_line(points_, seed_right(place), noise_).angle();
    return std::abs(left - right) >= options_.least_angle;
  }

  std::optional<Edge> measure(std::size_t place) const {
    Edge edge;
    edge.left = line_left(place);
    edge.right = line_right(place);
    edge.index = points_.index[place - 1];
    if (meet(edge, place) || end(edge, place)) return edge;
    return std::nullopt;
  }

  // Two lines that meet where the search saw the edge.
  bool meet(Edge& edge, std::size_t place) const {
    const double turn = edge.left.slope - edge.right.slope;
    if (!turns(place) || turn == 0) return false;
    const double y0 = points_.y[place - 1];
    const double y1 = points_.y[place];
    const double middle = (y0 + y1) / 2;
    const double y = middle + (edge.right.at(middle) - edge.left.at(middle)) / turn;
    const double slack = spacing_slack * (y1 - y0) + on_the_line * noise_ / std::abs(turn);
    if (y < y0 - slack || y > y1 + slack) return false;
    edge.kind = EdgeKind::crease;
    edge.y = y;
    edge.z = edge.left.at(y);
    return true;
  }

  // A surface that ends before another one: between the last ray that met it and the next one.
  bool end(Edge& edge, std::size_t place) const {
    const double middle = (points_.y[place - 1] + points_.y[place]) / 2;
    const double step = edge.right.at(middle) - edge.left.at(middle);
    if (std::abs(step) < std::max(options_.least_step, on_the_line * noise_)) return false;
    edge.kind = EdgeKind::step;
    if (step > 0) {
      const std::size_t last = last_on(edge.left, place);
      edge.index = points_.index[last];
      edge.y = points_.y[last] + spacing({place - side(place), last}) / 2;
    } else {
      const std::size_t first = first_on(edge.right, place);
      const std::optional<Point> wall = wall_before(edge.left, first);
      const double apart = spacing({first, place + side(place) - 1});
      const Point seen{points_.y[first], points_.z[first]};
      edge.index = points_.index[first] - (wall ? 2 : 1);
      edge.y = seen.y - (0.5 + (wall ? lost_after(*wall, seen, apart) : 0)) * apart;
    }
    edge.z = edge.beside().at(edge.y);
    return true;
  }

  bool lies_on(const Line& line, std::size_t i) const {
    return std::abs(points_.z[i] - line.at(points_.y[i])) < on_the_line * noise_;
  }

  // Where the surface that was seen before `place` ends. A point on the wall below it may have come along.
  std::size_t last_on(const Line& surface, std::size_t place) const {
    for (std::size_t i = place + beside_the_place; i-- > place - 1 - beside_the_place;)
      if (lies_on(surface, i)) return i;
    return place - 1;
  }

  std::size_t first_on(const Line& surface, std::size_t place) const {
    for (std::size_t i = place - beside_the_place; i <= place + beside_the_place; ++i)
      if (lies_on(surface, i)) return i;
    return place;
  }

  // The range finder gives no point where it met something steep on the way from the point before. Going on
  // to a nearer surface it makes an exception for a single jump. If the wall below that surface is in view,
  // there are two jumps. The first leads to the wall, which shows as a point before the farther surface.
  std::optional<Point> wall_before(const Line& farther, std::size_t first) const {
    std::size_t i = points_.index[first] - 1;
    if (profile_.valid[i]) return std::nullopt;
    while (i > 0 && !profile_.valid[i]) --i;
    const Point last{profile_.y[i], profile_.z[i]};
    const double slack = on_the_line * noise_;
    const bool between = last.z > points_.z[first] + slack && last.z < farther.at(last.y) - slack;
    if (!profile_.valid[i] || !between) return std::nullopt;
    return last;
  }

  // How much of a point's spacing the nearer surface loses after such a wall. Seen from along the wall, it
  // loses all of its first point. The more of the wall is seen, the nearer the ray before that point meets
  // the wall's upper end. From there the way to the point is not too steep. So it loses 1 - tan(steepest) ·
  // tan(ray to wall), but not less than nothing. Where the wall ends is known to half a point, so that much
  // of the angle is not counted.
  static double lost_after(const Point& wall, const Point& first, double apart) {
    const double up = wall.z - first.z;
    const double across = std::abs(first.y - apart - wall.y + wall.y / wall.z * up);
    return 1 - std::min(1.0, std::tan(steepest) * std::max(0.0, across - apart / 2) / up);
  }

  // Of neighbouring points along y; between the first and the last of a surface.
  double spacing(Stretch ends) const {
    return (points_.y[ends.end] - points_.y[ends.begin]) /
           static_cast<double>(points_.index[ends.end] - points_.index[ends.begin]);
  }

  const Profile& profile_;
  const Points& points_;
  const EdgeOptions& options_;
  double noise_;
  StretchSums sums_;
};

}  // namespace

const Line& Edge::beside() const {
  if (kind == EdgeKind::crease) return left;
  return left.at(y) < right.at(y) ? left : right;
}

std::optional<Edge> find_edge(const Profile& profile, const EdgeOptions& options) {
  Points points = valid_points(profile);
  points = without_spikes(points, noise_of(points));
  points = without_wall_points(points, noise_of(points));
  if (options.least_side < 4 || points.count < 2 * options.least_side) return std::nullopt;
  return Search(profile, points, options).best();
}

}  // namespace pal::skills::sensing
