// What a skill needs of a workcell, and whether the workcell has it. This compares the thesis' operation
// environment configuration (OEC, section 2.3.4) with the system environment configuration (SEC, section
// 2.3.3). It needs no times.
#pragma once

#include <string>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::check {

/// One thing that a skill needs.
struct Resource {
  /// The groups of section 2.3.3: SD, LS, RM, and GS, which is the skill. Then the modules of the skill
  /// itself, and activities, each with the module that does it.
  enum class Group { sensor_driver, logical_sensor, robotic_machine, generic_skill, skill_module, activity };
  /// What an environment must say about it. `listed`: also needed, if the environment lists what it has of
  /// the group.
  enum class Kind { processor, device, time, listed };
  Group group = Group::sensor_driver;
  Kind kind = Kind::processor;
  std::string name;    // "SD1", "force-torque", "extract-z"
  std::string module;  // the module that needs it; of a generic skill its own name
  SourceSpan where;
};

/// The configuration that the skill needs, by group, in the order of the text. Every module with a body needs
/// a processor, every device that a module waits for a behaviour, and every activity in a body a time, unless
/// it declares one. Drivers, sensors, machines and the skill itself must be listed.
std::vector<Resource> needed_resources(const pan::Network& network);

/// The configuration that an operation of all these skills needs (section 2.3.4): whatever one of them needs,
/// once.
std::vector<Resource> needed_resources(const std::vector<pan::Network>& skills);

/// Those that the environment does not have.
std::vector<Resource> missing_resources(const std::vector<Resource>& needed,
                                        const pan::Environment& environment);

/// "sensor drivers", …
std::string group_text(Resource::Group group);
/// "a processor (PLACE)", "a behaviour (DEVICE)", "a time (TIME)", "to be listed".
std::string kind_text(Resource::Kind kind);

/// Reports what the environment's lists lack, in one finding with a note for each resource. (A missing
/// processor, behaviour or time is reported when the model of the skill in the environment is built.)
void check_listed(const pan::Network& network, const pan::Environment& environment, Diagnostics& diagnostics);

}  // namespace pal::check
