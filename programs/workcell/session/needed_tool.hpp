// Whether the scene's tool is the device that a skill needs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pal/runtime/skill.hpp"
#include "sim/scene.hpp"

namespace pal::workcell {

/// The tool that the skill needs; nothing: any will do. A skill needs the tool that is its device. A skill
/// that moves by ALTER until its force sensor feels something presses with the pad's tip: forces on another
/// tool are not those of its tip.
std::optional<sim::ToolKind> needed_tool(const runtime::Skill& skill);

/// Why the scene cannot run the skill, with the scenes of `folders` that have its tool; nothing if it has it.
std::optional<std::string> lacking_tool(const runtime::Skill& skill, const sim::Scene& scene,
                                        const std::vector<std::string>& folders);

/// Throws Failure, with the scenes of `folders` that have the tool, if the skill needs another tool than the
/// scene's.
void check_tool(const runtime::Skill& skill, const sim::Scene& scene,
                const std::vector<std::string>& folders);

}  // namespace pal::workcell
