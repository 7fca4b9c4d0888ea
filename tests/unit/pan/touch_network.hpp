// Modules of the touch skill as networks, made by hand: what the front end makes of skills_pal/touch, without
// it.
#pragma once

#include "pal/pan/network.hpp"

namespace pal::pan {

/// Module 0 is SM1, module 1 is MC1; the others have no body.
Network touch_network();

}  // namespace pal::pan
