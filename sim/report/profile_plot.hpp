// Plots of range profiles with what was made of them.
#pragma once

#include <string>
#include <vector>

#include "sim/report/plot.hpp"

namespace pal::sim {

/// One measured point in the sensor's plane: across, and away from the sensor; mm. Of a point that is not
/// valid only `across` is shown.
struct ProfilePoint {
  double across = 0, away = 0;
  bool valid = true;
};

/// A fitted straight line, from end to end.
struct ProfileLine {
  double across_begin = 0, away_begin = 0, across_end = 0, away_end = 0;
};

/// A point that the interpretation found, an edge for instance.
struct ProfileMark {
  std::string label;
  double across = 0, away = 0;
};

struct RangeProfile {
  std::string title;
  std::vector<ProfilePoint> points;
  std::vector<ProfileLine> lines;
  std::vector<ProfileMark> marks;
};

/// One profile with its interpretation, both axes in one scale, the sensor above. `name`: of the files,
/// without ending.
Plot profile_plot(const RangeProfile& profile, const std::string& name = "profile");

/// Several profiles side by side, all in one scale, for comparison: one object at several distances, for
/// instance.
Plot profiles_plot(const std::vector<RangeProfile>& profiles, const std::string& title,
                   const std::string& name = "profiles");

}  // namespace pal::sim
