// Runs that show the losses of a device. It is the run behind a verdict, with what comes after the loss, or a
// run in which nothing is lost.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analyzer/chart/options.hpp"
#include "analyzer/verdict/verdict.hpp"
#include "pal/trace/trace.hpp"
#include "programs/pal/session/proof.hpp"

namespace pal::program {

struct LossRun {
  trace::Trace run;
  std::vector<analyzer::chart::Loss> losses;  // of the requirement's device
  std::optional<analyzer::chart::Highlight> highlight;
  std::optional<analyzer::chart::Window> window;
  std::vector<analyzer::Reason> reasons;  // what kept the device's message from being taken
};

/// The messages of a device that no thread took in a run. These are frames that no thread had asked for, and
/// messages that found the one before them still in their slot. Frames count from the first that is passed
/// on, and only whole ones.
std::vector<analyzer::chart::Loss> losses_in(const analyzer::Problem& problem, const trace::Trace& run,
                                             analyzer::DeviceId device);

/// The run for requirement `index`, which is one on losses. Nothing if it cannot be simulated.
std::optional<LossRun> loss_run(const Proof& proof, std::size_t index);

}  // namespace pal::program
