// The way that the arm came, the last millimetres of it: an arm that has hit something backs off along it.
#pragma once

#include <array>
#include <cstddef>

#include "sim/arm/kinematics.hpp"

namespace pal::sim {

/// Marks on the way behind the arm, each a quarter of a millimetre from the next. There are none where the
/// arm did not follow its set-point, because something was in its way. Never allocates.
class Trail {
 public:
  /// `tool`: from the flange to the tip.
  explicit Trail(const Pose& tool) : tool_(tool) {}

  /// Where the arm is, by its encoders, and where it was told to be. Called once each millisecond.
  void note(const Joints& q, const Joints& wanted);

  /// Whether a mark is near `from`.
  bool leads_back(const Joints& from) const;
  /// On the way back from `from`: there (0), at the last mark (a third), at the first one that is kept (1).
  /// Contract: leads_back(from), 0 <= part <= 1.
  Joints back(const Joints& from, double part) const;

  /// Forgets all marks.
  void forget() { count_ = 0; }

 private:
  static constexpr std::size_t capacity = 41;  // 10 mm

  const Joints& mark(std::size_t ago) const { return marks_[(last_ + capacity - ago) % capacity]; }
  double distance(const Joints& a, const Joints& b) const;

  Pose tool_;
  std::array<Joints, capacity> marks_{};
  std::size_t count_ = 0;
  std::size_t last_ = 0;
};

}  // namespace pal::sim
