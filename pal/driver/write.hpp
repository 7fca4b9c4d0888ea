// How commands leave their files.
#pragma once

#include <vector>

#include "pal/driver/console.hpp"
#include "pal/driver/exit_status.hpp"
#include "pal/support/output.hpp"

namespace pal::driver {

/// Writes all files or none, and lists those that stay on `console.out`; or says what was wrong on
/// `console.err`.
ExitStatus write_and_list(const std::vector<OutputFile>& files, const Console& console);

}  // namespace pal::driver
