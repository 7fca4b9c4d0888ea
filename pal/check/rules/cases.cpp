// What condition_runs found of each CASE and each UNTIL, as findings: no arm may hold, an arm never holds, a
// loop never ends.

#include "pal/check/conditions/condition_runs.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

void report_no_arm(const pan::Node& node, const std::vector<conditions::RunStep>& run,
                   const pan::Network& network, Diagnostics& diagnostics) {
  auto& finding = diagnostics.report(Finding::no_arm_may_hold, node.where);
  // The end of the run says how it comes about; its beginning is the same for most.
  constexpr std::size_t most_notes = 8;
  const auto first = run.size() > most_notes ? run.size() - most_notes : 0;
  for (auto i = first; i < run.size(); ++i) {
    const auto& step = run[i];
    const auto& where = network.modules[step.module.index()].body[step.node].where;
    finding.note(where, i == first ? beginning_of_run(first == 0) : RemarkWith<2>(Remark::next_of_run),
                 step.thread, step.what);
  }
}

void report_dead_arms(const pan::Graph& graph, const pan::Node& node, const std::vector<bool>& taken,
                      const pan::Network& network, Diagnostics& diagnostics) {
  const auto& guards = std::get<pan::Choose>(node.content).guards;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i]) continue;
    auto& finding = diagnostics.report(Finding::arm_never_taken, node.where, guard_text(network, guards[i]));
    if (node.out[i] != node.mate) finding.note(graph[node.out[i]].where, Remark::begins_with_this);
  }
}

void report_endless(const pan::Node& until, const pan::Graph& graph, const pan::Network& network,
                    Diagnostics& diagnostics) {
  const auto& guard = *std::get<pan::Until>(until.content).guard;
  auto& finding = diagnostics.report(Finding::loop_never_ends, until.where, guard_text(network, guard));
  finding.note(graph[until.mate].where, Remark::loop_begins);
}

}  // namespace

void check_cases(const pan::Network& network, const pan::Flow& flow, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const auto& module = network.modules[i];
    if (module.body.empty() || module.executed_by.valid()) continue;
    const auto runs = conditions::explore_conditions(network, flow, pan::ModuleId(i));
    for (const auto& [place, outcome] : runs.cases) {
      const auto& node = network.modules[place.first.index()].body[place.second];
      if (outcome.no_arm_holds) report_no_arm(node, *outcome.no_arm_holds, network, diagnostics);
      if (runs.complete)
        report_dead_arms(network.modules[place.first.index()].body, node, outcome.taken, network,
                         diagnostics);
    }
    for (const auto& [place, ends] : runs.loops) {
      const auto& body = network.modules[place.first.index()].body;
      if (runs.complete && !ends) report_endless(body[place.second], body, network, diagnostics);
    }
  }
}

}  // namespace pal::check
