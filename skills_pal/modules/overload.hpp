// Will a contact overload the force-torque sensor?
#pragma once

namespace pal::skills {

/// Half of the sensor's noise, its zero's drift and the shock of starting to move are left out of its range
/// of 65 N.
inline constexpr double greatest_force = 60;  // N

/// From a force to the end of the last motion that was decided before it was known. The sensor takes 6 ms,
/// the next request comes within 28 ms, the motion takes 28 ms, and the arm comes to rest within 5 ms.
inline constexpr double reaction = 0.067;  // s

/// A tool goes on at `speed` (mm/s) until the force is `threshold` (N). Throws runtime::ParameterError if it
/// may then press with more than `greatest_force` on a contact of `stiffness` (N/mm). The error names a speed
/// that would do.
void refuse_overload(double threshold, double speed, double stiffness);

}  // namespace pal::skills
