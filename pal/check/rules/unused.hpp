// What a file with a skill declares and the skill does not use.
#pragma once

#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// Warns of messages, conditions and devices of `tree` that none of `skills` uses. Also warns of times and
/// devices that `environments`, of the same file, give for something that no skill has. `skills` are those of
/// this file, without errors. A file without a skill is a library, so it is not checked.
void check_unused(const syntax::Tree& tree, const std::vector<const pan::Network*>& skills,
                  const std::vector<const pan::Environment*>& environments, Diagnostics& diagnostics);

}  // namespace pal::check
