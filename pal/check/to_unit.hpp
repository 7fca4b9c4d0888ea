// From a Process Activity Network back to the text that it was drawn from.
#pragma once

#include "pal/pan/network.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// The module as it would be written in PAL: its kind, its activities and its statements. They are in
/// canonical form: no kind words, `Execute` before a module, none before an activity. A network has no
/// descriptions, so neither has the result. No place in it is valid. syntax::print gives the text.
syntax::ModuleUnit to_unit(const pan::Network& network, pan::ModuleId module);

}  // namespace pal::check
