// Whether the scene's tool is the device that a skill needs.
#pragma once

#include <string>
#include <vector>

#include "pal/runtime/skill.hpp"
#include "sim/scene.hpp"

namespace pal::workcell {

/// Throws Failure, with the scenes of `folders` that have the tool, if the skill needs another tool than the
/// scene's.
void check_tool(const runtime::Skill& skill, const sim::Scene& scene,
                const std::vector<std::string>& folders);

}  // namespace pal::workcell
