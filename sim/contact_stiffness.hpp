// How stiff the contact between tool and scene is, found by pressing slowly.
#pragma once

#include "sim/scene.hpp"

namespace pal::sim {

/// Newton per millimetre of commanded motion, between two contact forces (N), by least squares. The tool goes
/// along its z axis in steps of 0.05 mm. Each force is read when the arm has come to rest. Steps of 1 mm
/// before contact. Throws SceneError, and std::runtime_error if nothing is met within 400 mm. Contract: 0 <
/// low < high.
double contact_stiffness(const Scene& scene, double low, double high);

}  // namespace pal::sim
