// A workcell in which an activity takes longer than workcell.pal says: for the proof and for the run alike.
#pragma once

#include <memory>
#include <string>

#include "pal/runtime/skill.hpp"

namespace pal::test {

struct Slower {
  std::string module;
  std::string activity;
  int milliseconds = 0;     // that it takes, always
  std::string processor{};  // on which the module runs, so that no thread waits for it; empty: where
                            // workcell.pal has it
};

/// The text of workcell.pal with another TIME for the activity, and another PLACE for the module. Throws
/// std::runtime_error if it has no such place.
std::string slow_down(const std::string& workcell, const Slower& slower);

/// The skill in that workcell. Throws std::runtime_error if it has no such activity.
std::unique_ptr<runtime::Skill> slow_down(std::unique_ptr<runtime::Skill> skill, const Slower& slower);

}  // namespace pal::test
