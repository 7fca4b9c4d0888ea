// Place at Location with the choice of what it feels by.
#pragma once

#include <memory>

#include "place_at_location_skill.hpp"

namespace pal::skills {

/// place_at_location.pal, with this force sensor in the place of the usual one.
std::unique_ptr<runtime::Skill> place_at_location_by(
    std::unique_ptr<place_at_location::LS1Activities> force_sensor);

}  // namespace pal::skills
