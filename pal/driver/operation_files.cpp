#include "pal/driver/private/operation_files.hpp"

#include <algorithm>

namespace pal::driver {

operations::Skills read_skills(const OperationOptions& options, const std::set<std::string>& used,
                               const Console& console, Session& session) {
  Selection selection;
  selection.max_errors = options.max_errors;
  selection.environments = options.environments;
  for (const std::string& path : options.skills) {
    if (const auto found = console.files.list(path, ".pal")) {
      // An environment in the folder is not the one that was asked for.
      selection.files.insert(selection.files.end(), found->begin(), found->end());
    } else {
      selection.files.push_back(path);
    }
  }
  read(selection, console, session);
  operations::Skills skills;
  for (const pan::Network& network : session.specification.skills)
    skills.emplace(network.skill.name, network.skill);
  std::erase_if(session.specification.skills,
                [&](const pan::Network& network) { return !used.contains(network.skill.name); });
  if (options.environments.empty()) session.specification.environments.clear();
  return skills;
}

}  // namespace pal::driver
