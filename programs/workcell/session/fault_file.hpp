// What the user says is to go wrong, and what is to be done about it.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "pal/runtime/outcome.hpp"
#include "pal/trace/spool.hpp"
#include "programs/workcell/session/failure.hpp"
#include "sim/cell/fault_plan.hpp"

namespace pal::workcell {

/// The faults that a file names, at least one; none if `file` is empty. Throws Failure.
std::vector<sim::PlannedFault> faults_in(const std::string& file);

/// The same, without slow statements: a file for whatever skill comes first knows no skill's lines.
std::vector<sim::PlannedFault> faults_of_lines(const std::string& file);

/// For the user whose file names a device that the cell does not have.
Failure no_such_device(const std::string& file, const sim::NoSuchDevice& problem);

/// A line for each fault that never came, `ended` says why: "the skill ended after 912 ms". What was not
/// tried is not shown to be harmless. Returns whether there was one.
bool tell_faults_to_come(const std::string& file, const std::vector<sim::PlannedFault>& to_come,
                         const std::string& ended, std::ostream& out);

/// Of the slow statements, those whose line was not executed from their time on.
std::vector<sim::PlannedFault> slow_to_come(const std::vector<runtime::SlowStatement>& slow,
                                            const trace::Trace& tables, const trace::EventSource& events);

/// "report", "contingency" or "stop".
runtime::OnBrokenPromise policy_named(const std::string& name);

}  // namespace pal::workcell
