// Why the arm stopped by itself.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "pal/runtime/device.hpp"

namespace pal::sim {

struct ArmFault {
  enum class Kind {
    collision,        // a part of the arm met something that it is not made to touch
    self_collision,   // two parts of the arm met
    following_error,  // the tool was more than 5 mm from where it had been told to be
  };

  Kind kind = Kind::collision;
  std::string text;  // "the forearm hit post 2"
  runtime::Time time{};
  /// Where the arm meets something, in frame 0, m; nothing: it does not.
  std::optional<Eigen::Vector3d> place{};
};

/// How far the tool may be from its set-point, mm.
inline constexpr double greatest_following_error = 5;

}  // namespace pal::sim
