// What the force-torque sensor shows when nothing touches the tool.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "runtime/drivers/force_torque/codec.hpp"

namespace pal::runtime::drivers::force_torque {

/// Forces in N and torques in N*m, in the order of the axes.
using Load = std::array<double, axes>;

/// The zero of the gauges. It is taken once, in free air, and kept: a tool that presses when a skill begins
/// still presses. Loads that are given are less the tool's own weight, so that the zero holds in every pose.
///
/// Gauges drift. A tool that shows next to nothing is in free air, and the zero then follows. It follows no
/// further than a sensor drifts that is in order.
class ZeroPoint {
 public:
  bool known() const { return known_.has_value(); }

  /// A look at the load of a tool that stands still: begin_look(), loads until looked_enough(), end_look().
  void begin_look();
  void look(const Load& load);
  bool looked_enough() const { return count_ >= (known() ? looks_again : looks_first); }
  /// Takes the zero, lets it follow, or leaves it as it is. Empty, or why there can be no zero.
  std::string end_look();

  /// The load without the zero. The zero is known.
  Load take_off(const Load& load) const;

 private:
  static constexpr int looks_first = 16;
  static constexpr int looks_again = 8;

  Load mean() const;
  std::string take(const Load& mean);
  std::string follow(const Load& mean);

  std::optional<Load> known_;
  Load first_{};  // as it was taken
  Load sum_{}, least_{}, greatest_{};
  int count_ = 0;
};

}  // namespace pal::runtime::drivers::force_torque
