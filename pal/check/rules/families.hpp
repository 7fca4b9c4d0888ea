// The families of checks on a network, one file each.
#pragma once

#include <functional>

#include "pal/pan/flow.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::check {

/// Which modules may communicate (thesis, figure 3.3).
void check_layers(const pan::Network& network, Diagnostics& diagnostics);
/// Messages that no module sends or takes, requests that no module answers, modules without messages.
void check_channels(const pan::Network& network, Diagnostics& diagnostics);
/// Requests for one answer in two blocks at once.
void check_askers(const pan::Network& network, Diagnostics& diagnostics);
/// Conditions with two writers, in two modules or in two blocks at once.
void check_writers(const pan::Network& network, Diagnostics& diagnostics);
/// Conditions that are read before they are set.
void check_reads(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics);
/// CASEs of which no arm may hold, arms that never hold, and loops whose end condition never holds.
void check_cases(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics);
/// Statements that are never reached, loops that spin.
void check_flow(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics);
/// Activities and conditions that read a message which never comes, or has not come yet.
void check_readers(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics);
/// The start of the skill and its completions; contingency methods that nothing executes.
void check_protocol(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics);

/// Modules that begin with something other than a wait.
void check_starts(const pan::Network& network, Diagnostics& diagnostics);
/// Runs after which the skill can never complete, and messages that no run takes. For networks without
/// errors. `stop`: as for check().
void check_deadlocks(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics,
                     const std::function<bool()>& stop);

}  // namespace pal::check
