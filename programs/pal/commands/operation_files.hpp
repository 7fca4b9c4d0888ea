// What the commands on operations read.
#pragma once

#include <string>
#include <vector>

#include "operations/check.hpp"
#include "operations/model.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/session/built_skills.hpp"

namespace pal::program {

/// Reads and checks the PAL of --skills (all files of its folders) and of --environment. Skills of which `built` has
/// another one give way. Only the skills that
/// `used` names stay in the session.
operations::Skills read_skills(const OperationOptions& options, const std::set<std::string>& used,
                               const Console& console, Session& session,
                               const BuiltSkills& built);

}  // namespace pal::program
