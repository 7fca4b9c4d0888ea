// The skill template (thesis, section 2.3.2), checked.
#pragma once

#include "pal/check/network/names.hpp"
#include "pal/pan/network.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// Fills in Network::skill and enters the modules that it lists.
void build_template(const syntax::SkillUnit& skill, Names& names, pan::Network& network,
                    Diagnostics& diagnostics);

}  // namespace pal::check
