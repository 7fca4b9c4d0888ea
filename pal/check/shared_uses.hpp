// What blocks of one module use at the same time: messages, and activities that have no result. A module and
// those that it executes keep one value of each message, and each has one object of its class
// (docs/reference/runtime.md).
#pragma once

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::check {

/// Reports each message that one block writes while another uses it (PAL0732). A wait, and an activity that
/// WRITES it, write it. A send, a decision FROM it and an activity that READS it read it. Blocks on two
/// processors may meet, and so may blocks of two priorities on a preemptive one. Blocks of one priority on
/// one processor take turns, statement by statement.
///
/// Warns of each activity that two such blocks run, and that writes no message which the module uses
/// (PAL0734). Whatever it does is then done to what its class keeps.
void check_shared_uses(const pan::Network& network, const pan::Environment& environment,
                       Diagnostics& diagnostics);

}  // namespace pal::check
