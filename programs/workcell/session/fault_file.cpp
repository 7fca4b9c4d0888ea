#include "programs/workcell/session/fault_file.hpp"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <sstream>

namespace pal::workcell {

std::vector<sim::PlannedFault> faults_in(const std::string& file) {
  if (file.empty()) return {};
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw Failure(ExitStatus::usage, file, "the file cannot be read", "name a file of faults");
  auto read = sim::read_faults(text.str());
  if (const auto* wrong = std::get_if<sim::FaultTextError>(&read))
    throw Failure(ExitStatus::wrong_specification, fmt::format("{}:{}", file, wrong->line), wrong->cause,
                  "for example: at 500 ms force-torque dropout");
  if (std::get<0>(read).empty())
    throw Failure(ExitStatus::wrong_specification, file, "the file names no fault",
                  "write a line, for example: at 500 ms force-torque dropout");
  return std::get<0>(std::move(read));
}

std::vector<sim::PlannedFault> faults_of_lines(const std::string& file) {
  std::vector<sim::PlannedFault> faults = faults_in(file);
  for (const sim::PlannedFault& fault : faults)
    if (fault.kind == sim::PlannedFault::Kind::takes)
      throw Failure(
          ExitStatus::wrong_specification, fmt::format("{}:{}", file, fault.line),
          "a statement can be made slow in 'workcell run' only",
          "name a device and what goes wrong with its line, for example: at 500 ms force-torque late 3 ms");
  return faults;
}

Failure no_such_device(const std::string& file, const sim::NoSuchDevice& problem) {
  return {ExitStatus::wrong_specification, fmt::format("{}:{}", file, problem.line()), problem.what(),
          "name one of these, or choose a scene whose tool is the device"};
}

bool tell_faults_to_come(const std::string& file, const std::vector<sim::PlannedFault>& to_come,
                         const std::string& ended, std::ostream& out) {
  for (const sim::PlannedFault& fault : to_come)
    out << fmt::format("  {}{}: the fault of {} at {:g} ms never came: {}\n", file,
                       fault.line == 0 ? "" : ":" + std::to_string(fault.line), fault.device,
                       std::chrono::duration<double, std::milli>(fault.at).count(), ended);
  return !to_come.empty();
}

std::vector<sim::PlannedFault> slow_to_come(const std::vector<runtime::SlowStatement>& slow,
                                            const trace::Trace& tables, const trace::EventSource& events) {
  std::vector<bool> came(slow.size());
  if (slow.empty()) return {};
  events([&](const trace::Event& event) {
    if (event.kind != trace::Kind::done || event.statement < 0) return;
    const trace::Statement& statement = tables.statements[static_cast<std::size_t>(event.statement)];
    for (std::size_t i = 0; i < slow.size(); ++i)
      if (event.time_ns >= slow[i].from.count() && statement.module == slow[i].module &&
          statement.line == slow[i].line)
        came[i] = true;
  });
  std::vector<sim::PlannedFault> result;
  for (std::size_t i = 0; i < slow.size(); ++i)
    if (!came[i])
      result.push_back({.at = slow[i].from, .device = fmt::format("{}:{}", slow[i].module, slow[i].line)});
  return result;
}

runtime::OnBrokenPromise policy_named(const std::string& name) {
  if (name == "contingency") return runtime::OnBrokenPromise::contingency;
  return name == "stop" ? runtime::OnBrokenPromise::stop : runtime::OnBrokenPromise::report;
}

}  // namespace pal::workcell
