// The context in which Z3 solves what a thread asks of it.
#pragma once

#include <z3++.h>

namespace pal::analyzer {

/// Of this thread, and kept: making a context takes longer than most problems take to be solved.
z3::context& solver_context();

/// One that was interrupted is not used again: the next question of this thread gets a new one. Nothing that
/// belongs to the old one may be left.
void renew_solver_context();

}  // namespace pal::analyzer
