#include "runtime/run.hpp"

#include "runtime/thrown.hpp"
#include "runtime/virtual_executive.hpp"

namespace pal::runtime {

Outcome run(Skill& skill, World& world, const std::vector<Connection>& connections,
            const RunOptions& options) {
  Clock clock;
  Journal journal(clock, skill, options);
  VirtualExecutive executive(clock, journal, world, skill.wiring(), options);
  Kernel kernel(clock, executive, journal, skill, connections, options);
  try {
    executive.run(kernel);
  } catch (...) {
    journal.fail("the run: " + what_was_thrown());
  }
  kernel.devices.close();
  Outcome outcome = journal.take();
  outcome.broken_promises = kernel.promises.take();
  return outcome;
}

}  // namespace pal::runtime
