// Environments (thesis, section 2.3.3), checked as far as they can be without a skill.
#pragma once

#include "pal/pan/environment.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// Reports figures that no workcell can have, as a period of 0 (PAL0708 to PAL0714, PAL0728). For
/// environments whose figures were changed after they were read, too.
void check_figures(const pan::Environment& environment, Diagnostics& diagnostics);

pan::Environment build_environment(const syntax::EnvironmentUnit& written, Diagnostics& diagnostics);

}  // namespace pal::check
