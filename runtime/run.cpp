#include "runtime/run.hpp"

#include "runtime/executives/real_time/real_executive.hpp"
#include "runtime/executives/virtual_executive.hpp"
#include "runtime/kernel/thrown.hpp"

namespace pal::runtime {

namespace {

template <class Executive>
void run_by(Executive& executive, Kernel& kernel) {
  try {
    executive.run(kernel);
  } catch (...) {
    kernel.journal.fail("the run: " + what_was_thrown());
  }
  executive.close_devices(kernel);
}

}  // namespace

Outcome run(Skill& skill, World& world, const std::vector<Connection>& connections,
            const RunOptions& options) {
  if (options.control != nullptr)
    options.control->refuse_to_hold(
        options.real_time ? "a run in real time cannot be held: its devices would not be answered" : "");
  Clock clock;
  Journal journal(clock, skill, options);
  Outcome outcome;
  if (options.real_time) {
    RealExecutive executive(clock, journal, world, skill.wiring(), options);
    Kernel kernel(clock, executive, journal, skill, connections, options);
    run_by(executive, kernel);
    outcome = journal.take();
    outcome.broken_promises = kernel.promises.take();
    outcome.requirements = kernel.promises.measured();
    outcome.real_time = executive.take_report();
  } else {
    VirtualExecutive executive(clock, journal, world, skill.wiring(), options);
    Kernel kernel(clock, executive, journal, skill, connections, options);
    run_by(executive, kernel);
    outcome = journal.take();
    outcome.broken_promises = kernel.promises.take();
    outcome.requirements = kernel.promises.measured();
  }
  return outcome;
}

}  // namespace pal::runtime
