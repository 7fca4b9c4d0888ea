// Environments (thesis, section 2.3.3), checked as far as they can be without a skill.
#pragma once

#include "pal/pan/environment.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

pan::Environment build_environment(const syntax::EnvironmentUnit& written, Diagnostics& diagnostics);

}  // namespace pal::check
