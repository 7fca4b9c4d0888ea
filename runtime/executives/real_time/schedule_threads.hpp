// Which CPU and which priority of the operating system the threads of a run have.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/executives/real_time/levels.hpp"
#include "runtime/executives/real_time/os_thread.hpp"
#include "runtime/kernel/journal.hpp"

namespace pal::runtime {

/// Pins each level to a CPU and gives it SCHED_FIFO, as far as the system permits; levels keep the order of
/// their priorities. The first of `threads`, which keeps time, becomes one more urgent than all levels.
/// Returns the greatest priority a level may have; nothing, if SCHED_FIFO is not permitted: then all threads
/// have the ordinary policy. What was not permitted is added to `shortcomings`.
std::optional<int> schedule_threads(const Wiring& wiring, Levels& levels,
                                    const std::vector<std::unique_ptr<OsThread>>& threads,
                                    std::vector<std::string>& shortcomings);

}  // namespace pal::runtime
