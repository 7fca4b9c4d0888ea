// From one skill, and what its file sees, to its network.
#pragma once

#include "pal/check/network/scope.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// Reports unknown names, and mistakes of the template.
pan::Network build_network(const Scope& scope, const syntax::SkillUnit& skill, Diagnostics& diagnostics);

/// All modules that the scope's first file sees, without a template. Reports only what no template could
/// change.
pan::Network build_sketch(const Scope& scope, const std::string& name, SourceSpan where,
                          Diagnostics& diagnostics);

}  // namespace pal::check
