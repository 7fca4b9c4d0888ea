#include "pal/pan/times.hpp"

#include <algorithm>

namespace pal::pan {

Environment with_times_of(const Network& network, Environment environment) {
  std::vector<ActivityTime> more;
  for (const Activity& activity : network.activities) {
    if (!activity.time) continue;
    const std::string& module = network.modules[activity.module.index()].name;
    const bool given = std::any_of(
        environment.activities.begin(), environment.activities.end(), [&](const ActivityTime& time) {
          return time.activity == activity.name && (time.module.empty() || time.module == module);
        });
    if (!given) more.push_back({activity.name, module, *activity.time, activity.where});
  }
  environment.activities.insert(environment.activities.end(), more.begin(), more.end());
  return environment;
}

}  // namespace pal::pan
