// What the skills' logical sensors see in a profile of the range finder, for people to look at.
#pragma once

#include <vector>

#include "server/telemetry.hpp"

namespace pal::workcell {

/// By the functions of skills_pal/sensing that the logical sensors call, with their usual options. `edge`:
/// the edge nearest to the middle, with the surfaces `left` and `right` of it, in deg. Without an edge
/// `surface`: one line through all, in deg. `nearest`: what is nearest, in mm.
std::vector<server::ProfileMark> profile_marks(const server::Profile& profile);

}  // namespace pal::workcell
