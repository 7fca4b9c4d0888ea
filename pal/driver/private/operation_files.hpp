// What the commands on operations read.
#pragma once

#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/model.hpp"
#include "pal/driver/commands.hpp"

namespace pal::driver {

/// Reads and checks the PAL of --skills, of whose folders every file counts, and of --environment. Of the
/// skills only those stay in the session that `used` names.
operations::Skills read_skills(const OperationOptions& options, const std::set<std::string>& used,
                               const Console& console, Session& session);

}  // namespace pal::driver
