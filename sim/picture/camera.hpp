// Cameras whose place is computed from the scene. Private to pal_sim.
#pragma once

#include <optional>

#include "sim/picture/stage.hpp"

namespace pal::sim {

/// Keeps the arm, its tool and what stands in its reach in the picture, and looks at the tool past whatever
/// might hide it. The direction is chosen once; as the arm moves on, the camera draws back where it must, and
/// never jumps.
class WorkcellCamera {
 public:
  /// `camera`: a camera of the model that is used instead, if there is one of this name.
  WorkcellCamera(const Stage& stage, double aspect, const std::string& camera);

  /// The view of the stage in its present state. `calm`: how much of the way to the best view is left to
  /// later pictures, 0 to 1.
  View view(const Stage& stage, double calm);

 private:
  void include_all(const Stage& stage);

  int fixed_;
  Framing framing_;
  bool begun_ = false;
  View shown_;
};

/// Looks at the tool's tip, and at what is before it, from near by. The direction is chosen once.
class ContactCamera {
 public:
  explicit ContactCamera(const Stage& stage);

  /// `calm`: as of the WorkcellCamera.
  View view(const Stage& stage, double calm);
  /// Where two parts have met, in the world, from wherever it can be seen.
  View view_of_place(const Stage& stage, const Eigen::Vector3d& place);

 private:
  View direction_;
  std::optional<Eigen::Vector3d> place_;
  View place_view_;
  double shown_gap_ =
      -1;  // m between tip and surface that the picture has room for; negative: nothing shown yet
};

}  // namespace pal::sim
