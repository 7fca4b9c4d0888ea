#include "codegen/placement.hpp"

#include <algorithm>

#include "pal/pan/threads.hpp"
#include "pal/support/finding.hpp"

namespace pal::codegen {

namespace {

const pan::Placement* place_of(const pan::Environment& environment, const std::vector<PlannedThread>& threads,
                               const PlannedThread& thread) {
  for (const PlannedThread* at = &thread;; at = &threads[*at->runner]) {
    const pan::Placement* found = pan::place_of(environment, at->pal_name);
    if (found != nullptr || !at->runner) return found;
  }
}

}  // namespace

void place_threads(const pan::Environment& environment, Diagnostics& diagnostics,
                   std::vector<PlannedThread>& threads) {
  for (PlannedThread& thread : threads) {
    const pan::Placement* place = place_of(environment, threads, thread);
    if (place == nullptr) {
      diagnostics.report(Finding::thread_not_placed, environment.where, environment.name, thread.pal_name);
      continue;
    }
    const auto processor =
        std::find_if(environment.processors.begin(), environment.processors.end(),
                     [&](const pan::Processor& candidate) { return candidate.name == place->processor; });
    if (processor == environment.processors.end()) {
      diagnostics.report(Finding::unknown_processor, place->where, place->processor);
      continue;
    }
    thread.processor = static_cast<std::size_t>(processor - environment.processors.begin());
    thread.priority = place->priority;
  }
}

}  // namespace pal::codegen
