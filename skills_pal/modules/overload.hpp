// Will a contact overload the force-torque sensor?
#pragma once

namespace pal::skills {

/// Half of the sensor's noise, its zero's drift and the shock of starting to move are left out of its range
/// of 65 N.
inline constexpr double greatest_force = 60;  // N

/// From a force to the end of the last motion that was decided before it was known: 6 ms of the sensor, 28 ms
/// until the next request, 28 ms of motion, and 5 ms in which the arm comes to rest.
inline constexpr double reaction = 0.067;  // s

/// Throws runtime::ParameterError, with the speed that would do, when a tool that goes on at `speed` (mm/s)
/// until the force is `threshold` (N) may press with more than `greatest_force` on a contact of `stiffness`
/// (N/mm).
void refuse_overload(double threshold, double speed, double stiffness);

}  // namespace pal::skills
