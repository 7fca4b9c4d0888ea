// Compares the templates of logical sensors (thesis, section 2.3.5) with their bodies.
#pragma once

#include "pal/check/network/names.hpp"

namespace pal::check {

/// Drivers that are named and not asked, or asked and not named; the same for information; slots of logical
/// sensors in other modules. A slot that is left out is not checked.
void check_sensors(const Names& names, const pan::Network& network, Diagnostics& diagnostics);

}  // namespace pal::check
