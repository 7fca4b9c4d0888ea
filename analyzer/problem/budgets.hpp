// What each step of a decision may take, from the one table in budgets.def.
#pragma once

#include <cstddef>

namespace pal::analyzer::budget {

#define PAL_BUDGET(name, number, unit, use) inline constexpr std::size_t name = number;
#include "analyzer/problem/budgets.def"
#undef PAL_BUDGET

}  // namespace pal::analyzer::budget
