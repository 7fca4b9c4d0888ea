// All runs of one module, as far as conditions are concerned: which arm of a CASE is taken, the first that
// holds, and which are never taken. Its blocks and the modules that it executes belong to it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pal/pan/flow.hpp"
#include "pal/pan/network.hpp"

namespace pal::check::conditions {

/// One step of a run that sets, reads or tests a condition.
struct RunStep {
  std::string thread;  // "SM1.2"
  pan::ModuleId module;
  pan::NodeId node;
  std::string what;  // "sets pc-force to FALSE"
};

/// What the exploration found of one CASE.
struct CaseOutcome {
  std::vector<bool> taken;                           // by arm
  std::optional<std::vector<RunStep>> no_arm_holds;  // a shortest run after which none does
};

struct ConditionRuns {
  bool complete = true;  // false: there were too many states, and arms not taken prove nothing
  std::map<std::pair<pan::ModuleId, pan::NodeId>, CaseOutcome> cases;  // those that were reached
  std::map<std::pair<pan::ModuleId, pan::NodeId>, bool>
      loops;  // UNTILs that were reached: some run ends there
};

/// Explores every interleaving. Waits may always go on, because communication with other modules is left out.
/// So there are more runs than can happen, and never fewer. An SPC without a value takes both values; a
/// condition that other threads set may have any value at each read. RPC latches for the next test of its
/// thread. A test reads at one instant what is not latched. When a CONCURRENT ends, a block that cannot end
/// has stopped, or finishes its current statement (docs/reference/execution-model.md). `root` has a body and
/// is not executed by another module.
ConditionRuns explore_conditions(const pan::Network& network, const pan::Flow& flow, pan::ModuleId root);

}  // namespace pal::check::conditions
