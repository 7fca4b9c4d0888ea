// Messages that blocks of one module use at the same time. A module and those that it executes keep one value
// of each (docs/reference/runtime.md).
#pragma once

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::check {

/// Reports each message that one block writes while another uses it. A wait, and an activity that WRITES it,
/// write it. A send, a decision FROM it and an activity that READS it read it. Blocks on two processors may
/// meet, and so may blocks of two priorities on a preemptive one. Blocks of one priority on one processor
/// take turns, statement by statement.
void check_shared_messages(const pan::Network& network, const pan::Environment& environment,
                           Diagnostics& diagnostics);

}  // namespace pal::check
