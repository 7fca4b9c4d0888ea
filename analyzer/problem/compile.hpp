// From the graphs of the modules to the flat steps of the threads.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// What the environment says about times and places, looked up and validated by make_problem.
class TimesAndPlaces {
 public:
  virtual ~TimesAndPlaces() = default;
  virtual Range activity(const pan::Activity& activity) = 0;
  virtual const pan::Costs& costs() const = 0;
  /// Places `thread` (its name is set); `runner`: of a block, the thread that runs its module's body; or -1.
  virtual void place(Thread& thread, ThreadId runner) = 0;
};

/// A problem has fewer steps. Compilation ends soon after.
constexpr std::size_t most_steps = 30'000;

/// Fills threads, steps and statements of `problem`; its channels stand already. Reports loops in which
/// nothing ever happens.
void compile(const pan::Network& network, TimesAndPlaces& environment, const SourceManager* sources,
             Diagnostics& diagnostics, Problem& problem);

/// The index of a module or device of the network among the problem's devices; none for a module with a body.
DeviceId device_of(const pan::Network& network, const pan::Party& party);

}  // namespace pal::analyzer
