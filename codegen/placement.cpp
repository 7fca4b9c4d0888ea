#include "codegen/placement.hpp"

#include "pal/support/diagnostic_code.hpp"

#include <algorithm>

namespace pal::codegen {

namespace {

const pan::Placement* find(const pan::Environment& environment, const std::string& thread) {
  for (const pan::Placement& placement : environment.placements) {
    if (placement.thread == thread) return &placement;
  }
  return nullptr;
}

const pan::Placement* place_of(const pan::Network& network, const pan::Environment& environment,
                               const std::string& thread) {
  if (const auto* own = find(environment, thread)) return own;
  std::string name = thread.substr(0, thread.find('.'));
  // At most as many steps as there are modules: modules that execute one another in a circle are nowhere.
  for (std::size_t steps = 0; steps <= network.modules.size(); ++steps) {
    if (const auto* found = find(environment, name)) return found;
    const auto module = std::find_if(network.modules.begin(), network.modules.end(),
                                     [&](const pan::Module& candidate) { return candidate.name == name; });
    if (module == network.modules.end() || !module->executed_by.valid()) return nullptr;
    name = network.modules[module->executed_by.index()].name;
  }
  return nullptr;
}

}  // namespace

void place_threads(const pan::Network& network, const pan::Environment& environment, Diagnostics& diagnostics,
                   std::vector<PlannedThread>& threads) {
  for (PlannedThread& thread : threads) {
    const pan::Placement* place = place_of(network, environment, thread.pal_name);
    if (place == nullptr) {
      diagnostics.report(
          Code::PAL0721, environment.where,
          "environment " + environment.name + " does not say where " + thread.pal_name + " runs",
          "add PLACE " + thread.pal_name + " ON … to the environment");
      continue;
    }
    const auto processor =
        std::find_if(environment.processors.begin(), environment.processors.end(),
                     [&](const pan::Processor& candidate) { return candidate.name == place->processor; });
    if (processor == environment.processors.end()) {
      diagnostics.report(Code::PAL0713, place->where,
                         "environment " + environment.name + " has no processor " + place->processor,
                         "add PROCESSOR " + place->processor + " to the environment");
      continue;
    }
    thread.processor = static_cast<std::size_t>(processor - environment.processors.begin());
    thread.priority = place->priority;
  }
}

}  // namespace pal::codegen
