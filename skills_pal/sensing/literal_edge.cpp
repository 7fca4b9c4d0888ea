#include "skills_pal/sensing/literal_edge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pal::skills::sensing {
namespace {

constexpr std::size_t half_mask = 7;  // of 15 points

// Of points that are not valid the difference is not known, and not counted.
double difference_across(const Profile& profile, std::size_t i) {
  double sum = 0;
  for (std::size_t j = 1; j <= half_mask; ++j) {
    if (profile.valid[i - j] && profile.valid[i + j]) sum += profile.z[i - j] - profile.z[i + j];
  }
  return sum;
}

// The greatest of the differences that begin beyond the threshold; nothing if none does.
std::optional<std::size_t> first_step(const Profile& profile, double threshold) {
  std::optional<std::size_t> best;
  double greatest = threshold;
  for (std::size_t i = half_mask; i + half_mask < profile.size(); ++i) {
    const double here = std::abs(difference_across(profile, i));
    if (best && here <= threshold) break;
    if (here <= greatest) continue;
    greatest = here;
    best = i;
  }
  return best;
}

/// Two valid points with nothing valid between them.
struct Neighbours {
  std::size_t left = 0;
  std::size_t right = 0;
};

// Under the mask, where neighbours differ most.
std::optional<Neighbours> steepest_turn(const Profile& profile, std::size_t step) {
  std::optional<Neighbours> best;
  std::optional<std::size_t> last;
  double greatest = 0;
  for (std::size_t i = step - half_mask; i <= step + half_mask; ++i) {
    if (!profile.valid[i]) continue;
    if (last && std::abs(profile.z[i] - profile.z[*last]) > greatest) {
      greatest = std::abs(profile.z[i] - profile.z[*last]);
      best = Neighbours{*last, i};
    }
    last = i;
  }
  return best;
}

// The valid point that is `count` points away on the near side, or the farthest one before it.
std::size_t away(const Profile& profile, std::size_t edge, bool to_the_left, std::size_t count) {
  std::size_t found = edge;
  for (std::size_t k = 1; k <= count; ++k) {
    if (to_the_left ? edge < k : edge + k >= profile.size()) break;
    const std::size_t i = to_the_left ? edge - k : edge + k;
    if (profile.valid[i]) found = i;
  }
  return found;
}

}  // namespace

std::optional<LiteralEdge> find_literal_edge(const Profile& profile, const LiteralEdgeOptions& options) {
  if (profile.size() < 2 * half_mask + 1) return std::nullopt;
  const std::optional<std::size_t> step = first_step(profile, options.threshold);
  if (!step) return std::nullopt;
  const std::optional<Neighbours> sides = steepest_turn(profile, *step);
  if (!sides) return std::nullopt;
  const bool left_is_nearer = profile.z[sides->left] < profile.z[sides->right];
  const std::size_t edge = left_is_nearer ? sides->left : sides->right;
  const std::size_t a = away(profile, edge, left_is_nearer, options.near_point);
  const std::size_t b = away(profile, edge, left_is_nearer, options.far_point);
  if (a == b) return std::nullopt;  // a surface of one point has no slope
  const double slope = std::atan((profile.z[b] - profile.z[a]) / (profile.y[b] - profile.y[a]));
  return LiteralEdge{profile.y[edge], profile.z[edge], slope * 180 / std::numbers::pi};
}

}  // namespace pal::skills::sensing
