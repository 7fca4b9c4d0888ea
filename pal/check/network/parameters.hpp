// A parameter of the skill template, checked, its values in its unit.
#pragma once

#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// A value with a unit of its own is converted exactly and rounded once. If something was reported, use the
/// result only for further findings.
pan::Parameter build_parameter(const syntax::Parameter& written, Diagnostics& diagnostics);

}  // namespace pal::check
