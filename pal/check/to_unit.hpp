// From a Process Activity Network back to the text that it was drawn from.
#pragma once

#include "pal/pan/network.hpp"
#include "pal/syntax/tree.hpp"

namespace pal {

/// The module as it would be written in PAL: its kind, its activities and its statements, in canonical form
/// (no kind words, `Execute` before a module, none before an activity). Texts for people are not in a network
/// and so not here. No place in any text is valid. syntax::print gives the text.
syntax::ModuleUnit to_unit(const pan::Network& network, pan::ModuleId module);

}  // namespace pal
