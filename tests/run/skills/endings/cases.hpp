// Which runs the table of endings has.
#pragma once

#include <string>
#include <vector>

#include "pal/runtime/dispatcher.hpp"

namespace pal::test {

using Parameters = std::vector<runtime::ParameterValue>;

struct Before {
  std::string skill;
  Parameters parameters{};
};

struct EndingCase {
  std::string skill;
  std::string scene;
  std::string lines{};           // more lines of the scene
  std::vector<Before> before{};  // skills that run first: "in contact" begins with a touch
  std::string begins = "free";
  Parameters parameters{};
};

/// For every skill: its defaults in every shipped scene in which it makes sense, and each parameter at both
/// ends of its range in one scene or two; those that press also from contact.
std::vector<EndingCase> ending_cases();

}  // namespace pal::test
