// What a skill needs of a workcell, and whether the workcell has it: the thesis' operation environment
// configuration (OEC, section 2.3.4) against the system environment configuration (SEC, section 2.3.3). Needs
// no times.
#pragma once

#include <string>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::checker {

/// One thing that a skill needs.
struct Resource {
  /// The groups of section 2.3.3: SD, LS, RM, GS, which is the skill; the modules of the skill itself;
  /// activities, each with the module that does it.
  enum class Group { sensor_driver, logical_sensor, robotic_machine, generic_skill, skill_module, activity };
  /// What an environment must say for it to be there. `listed`: if it lists what it has of the group, this,
  /// too.
  enum class Kind { processor, device, time, listed };
  Group group = Group::sensor_driver;
  Kind kind = Kind::processor;
  std::string name;    // "SD1", "force-torque", "extract-z"
  std::string module;  // the module that needs it; of a generic skill its own name
  SourceSpan where;
};

/// The configuration that the skill needs: every module with a body a processor, every device that a module
/// waits for a behaviour, every activity that stands in a body a time; drivers, sensors and machines are to
/// be listed, and so is the skill. By group, in the order of the text.
std::vector<Resource> needed_resources(const pan::Network& network);

/// The configuration that an operation of all these skills needs (section 2.3.4): whatever one of them needs,
/// once.
std::vector<Resource> needed_resources(const std::vector<pan::Network>& skills);

/// Those that the environment has not.
std::vector<Resource> missing_resources(const std::vector<Resource>& needed,
                                        const pan::Environment& environment);

/// "sensor drivers", …
std::string group_text(Resource::Group group);
/// "a processor (PLACE)", "a behaviour (DEVICE)", "a time (TIME)", "to be listed".
std::string kind_text(Resource::Kind kind);

/// Reports what the environment's lists lack, in one finding with a note a resource. (A missing processor,
/// behaviour or time is found, one by one, where a model is made of the two.)
void check_listed(const pan::Network& network, const pan::Environment& environment, Diagnostics& diagnostics);

}  // namespace pal::checker
