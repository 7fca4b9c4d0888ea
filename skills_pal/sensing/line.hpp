// Lines through the points of a profile.
#pragma once

#include "skills_pal/sensing/profile.hpp"

namespace pal::skills::sensing {

/// z = height + slope · (y - middle).
struct Line {
  double slope = 0;
  double height = 0;  // mm
  double middle = 0;  // mm; of the points that it was fitted to

  double at(double y) const { return height + slope * (y - middle); }
  /// Against the tool's y axis, deg, in (-90, 90).
  double angle() const;
};

/// Which points of a Points a line goes through: [begin, end).
struct Stretch {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t size() const { return end - begin; }
};

/// The line of least squares; points further off than three deviations `noise` count less and less, not at
/// all beyond about five (Tukey's weights). At least two points.
Line fit_line(const Points& points, Stretch stretch, double noise);

struct LineOnStretch {
  Line line;
  Stretch stretch;
};

/// Fits a line to `seed`. Then it extends the stretch from both ends, as long as points lie on the line, and
/// at most to the ends of `bounds`. A point is on the line within 3.5 deviations. Up to two others in a row
/// are passed over. The line is fitted again with each point.
LineOnStretch grow_line(const Points& points, Stretch seed, Stretch bounds, double noise);

/// Sums over the points up to each one, from which the squares that any stretch leaves come in constant time.
class StretchSums {
 public:
  explicit StretchSums(const Points& points);
  /// What a line of least squares through the stretch leaves: the sum of the squares, mm^2.
  double residual(Stretch stretch) const;

 private:
  struct Sums {
    double y = 0, z = 0, yy = 0, yz = 0, zz = 0;
  };
  std::array<Sums, most_points + 1> sums_{};
};

}  // namespace pal::skills::sensing
