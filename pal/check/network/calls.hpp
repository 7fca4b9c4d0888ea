// Which module executes which.
#pragma once

#include "pal/check/network/names.hpp"
#include "pal/pan/network.hpp"

namespace pal::check {

/// Enters the modules that bodies execute and fills in Module::executed_by. Reports modules that are executed
/// from two modules, in a circle, or have no body.
void enter_calls(Names& names, pan::Network& network, Diagnostics& diagnostics);

}  // namespace pal::check
