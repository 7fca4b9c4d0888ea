#include "pal/check/network/calls.hpp"

#include <set>
#include <string_view>

#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

/// Every Execute and bare name, in the order of the text.
template <class Visit>
void each_call(const syntax::Statements& statements, const Visit& visit) {
  for (const auto& statement : statements) {
    if (const auto* execute = std::get_if<syntax::Execute>(&statement.content)) {
      visit(execute->module.name);
    } else if (const auto* perform = std::get_if<syntax::Perform>(&statement.content)) {
      visit(perform->name);
    } else if (const auto* wait = std::get_if<syntax::WaitBranches>(&statement.content)) {
      for (const auto& arm : wait->arms) each_call(arm.body, visit);
      each_call(wait->otherwise, visit);
    } else if (const auto* choose = std::get_if<syntax::Choose>(&statement.content)) {
      for (const auto& arm : choose->arms) each_call(arm.body, visit);
    } else if (const auto* repeat = std::get_if<syntax::Repeat>(&statement.content)) {
      each_call(repeat->body, visit);
    } else if (const auto* concurrent = std::get_if<syntax::Concurrent>(&statement.content)) {
      for (const auto& block : concurrent->blocks) each_call(block.body, visit);
    }
  }
}

std::set<std::string_view> activities_of(const syntax::ModuleUnit& unit) {
  std::set<std::string_view> names;
  for (const auto& activity : unit.activities) names.insert(activity.name.text);
  return names;
}

/// True if following executed_by from `from` comes to `to`.
bool executed_within(pan::ModuleId from, pan::ModuleId to, const pan::Network& network) {
  for (auto at = from; at.valid(); at = network.modules[at.index()].executed_by) {
    if (at == to) return true;
  }
  return false;
}

}  // namespace

void enter_calls(Names& names, pan::Network& network, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const pan::ModuleId caller(i);
    const auto* unit = names.unit_of(caller);
    if (unit == nullptr) continue;
    const auto activities = activities_of(*unit);
    each_call(unit->body, [&](const syntax::Name& name) {
      if (activities.contains(name.text) || !names.is_module(name.text)) return;
      const auto called = *names.module(name, false);
      const auto& module = network.modules[called.index()];
      if (names.unit_of(called) != nullptr && !names.unit_of(called)->has_body) {
        auto& finding = diagnostics.report(Finding::executes_without_body, name.where, name.text);
        finding.note(module.where, Remark::declared_here);
      } else if (executed_within(caller, called, network)) {
        caller == called
            ? diagnostics.report(Finding::executes_itself, name.where, name.text)
            : diagnostics.report(Finding::executes_itself_by_way_of, name.where, name.text, unit->name.text);
      } else if (!module.executed_by.valid()) {
        network.modules[called.index()].executed_by = caller;
      } else if (module.executed_by != caller) {
        auto& finding = diagnostics.report(Finding::executed_from_two, name.where, name.text, unit->name.text,
                                           network.modules[module.executed_by.index()].name);
        finding.note(network.modules[module.executed_by.index()].where, Remark::also_executed);
      }
    });
  }
}

}  // namespace pal::check
