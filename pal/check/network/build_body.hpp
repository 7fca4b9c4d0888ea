// From the statements of a module to its graph.
#pragma once

#include "pal/check/network/names.hpp"
#include "pal/pan/network.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// Fills in body and threads of `module`. `speaker` is the module in whose name it communicates: itself, or
/// the one that executes it. Statements with unknown names are left out, and these names are reported.
void build_body(pan::ModuleId module, pan::ModuleId speaker, Names& names, pan::Network& network,
                Diagnostics& diagnostics);

}  // namespace pal::check
