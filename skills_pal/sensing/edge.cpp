#include "skills_pal/sensing/edge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pal::sensing {
namespace {

// How much better two lines must be than one. A test holds that 1000 planes and 1000 waves show no edge.
constexpr double clear = 12;
constexpr double overshadowing = 3;    // times as clear
constexpr double on_the_line = 3.5;    // deviations
constexpr double spacing_slack = 1.5;  // points

class Search {
 public:
  Search(const Points& points, const EdgeOptions& options)
      : points_(points), options_(options), noise_(noise_of(points)), sums_(points) {}

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

  // A surface that ends before another one: half a point beyond its last.
  bool end(Edge& edge, std::size_t place) const {
    const double y0 = points_.y[place - 1];
    const double y1 = points_.y[place];
    const double step = edge.right.at((y0 + y1) / 2) - edge.left.at((y0 + y1) / 2);
    if (std::abs(step) < std::max(options_.least_step, on_the_line * noise_)) return false;
    edge.kind = EdgeKind::step;
    const bool left_is_nearer = step > 0;
    edge.y = left_is_nearer ? y0 + (y0 - points_.y[place - 2]) / 2 : y1 - (points_.y[place + 1] - y1) / 2;
    edge.z = edge.beside().at(edge.y);
    return true;
  }

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
  if (options.least_side < 4 || points.count < 2 * options.least_side) return std::nullopt;
  return Search(points, options).best();
}

}  // namespace pal::sensing
