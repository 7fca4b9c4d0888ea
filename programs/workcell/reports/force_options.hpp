// Which of a skill's parameters belong in the plot of its force.
#pragma once

#include <string>

#include "pal/runtime/skill.hpp"
#include "programs/workcell/session/session.hpp"
#include "sim/report/plot.hpp"

namespace pal::workcell {

/// Parameters in N, or in counts of the force-torque sensor, are levels of force. Three make bands: what is
/// called least and greatest (or min… and max…), and `band` around `force`.
sim::ForcePlotOptions force_options(const runtime::Skill& skill, const Session& session,
                                    const std::string& title, runtime::Time end);

}  // namespace pal::workcell
