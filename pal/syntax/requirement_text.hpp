// Requirements in their canonical spelling.
#pragma once

#include <string>

#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// "REQUIREMENT fresh : AGE OF pc-force AT TXM( motion to MC1 ) IN SM1 AT MOST 10 ms"
std::string requirement_text(const Requirement& requirement);

}  // namespace pal::syntax
