// The templates of logical sensors (thesis, section 2.3.5) against what their bodies do.
#pragma once

#include "pal/check/network/names.hpp"

namespace pal::checker {

/// Drivers that are named and not asked, or asked and not named; information likewise; slots of logical
/// sensors in other modules. A template without a slot says nothing of it.
void check_sensors(const Names& names, const pan::Network& network, Diagnostics& diagnostics);

}  // namespace pal::checker
