// The command line of the program pal.
#pragma once

#include <string>
#include <vector>

#include "programs/pal/session/console.hpp"
#include "programs/pal/session/exit_status.hpp"

namespace pal::program {

/// Runs the command that `arguments` (without the program's name) give.
ExitStatus run(const std::vector<std::string>& arguments, const Console& console);

}  // namespace pal::program
