// The joint servos: what torque each motor gives, a thousand times a second.
#pragma once

#include "sim/arm/puma.hpp"

namespace pal::sim {

/// The set-point of a joint servo.
struct SetPoint {
  Joints position = Joints::Zero();
  Joints speed = Joints::Zero();
  Joints acceleration = Joints::Zero();
};

/// Proportional, differential and integral action per joint on top of the computed load; friction is fed
/// forward where the set-point moves. Torques are limited to what the drives can give.
class JointServos {
 public:
  /// `load`: the torques that hold the arm against gravity and Coriolis forces and accelerate it as wanted.
  /// Called once each millisecond.
  Joints torques(const SetPoint& wanted, const Joints& position, const Joints& speed, const Joints& load);

  /// Forgets the integral action.
  void reset();

 private:
  Joints integral_ = Joints::Zero();
};

}  // namespace pal::sim
