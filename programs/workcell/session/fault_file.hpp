// What the user says is to go wrong, and what is to be done about it.
#pragma once

#include <string>
#include <vector>

#include "pal/runtime/outcome.hpp"
#include "programs/workcell/session/failure.hpp"
#include "sim/cell/fault_plan.hpp"

namespace pal::workcell {

/// The faults that a file names, at least one; none if `file` is empty. Throws Failure.
std::vector<sim::PlannedFault> faults_in(const std::string& file);

/// The same, without slow statements: a file for whatever skill comes first knows no skill's lines.
std::vector<sim::PlannedFault> faults_of_lines(const std::string& file);

/// For the user whose file names a device that the cell does not have.
Failure no_such_device(const std::string& file, const sim::NoSuchDevice& problem);

/// "report", "contingency" or "stop".
runtime::OnBrokenPromise policy_named(const std::string& name);

}  // namespace pal::workcell
