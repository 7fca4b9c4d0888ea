// Requirements: the statements and channels that they mean.
#pragma once

#include "pal/check/network/names.hpp"
#include "pal/pan/network.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// Fills in Network::requirements. Reports requirements that name nothing in the skill.
void build_requirements(const syntax::SkillUnit& skill, Names& names, pan::Network& network,
                        Diagnostics& diagnostics);

}  // namespace pal::check
