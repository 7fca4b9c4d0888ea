#include "pal/check/network/calls.hpp"

#include <set>
#include <string_view>

#include "pal/check/report.hpp"
#include "pal/support/diagnostic_code.hpp"

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
        auto& finding = diagnostics.report(Code::PAL0210, name.where,
                                           quoted(name.text) + " has no body that could be executed",
                                           "give it a body, or send it a message instead");
        finding.notes.push_back({module.where, "it is declared here"});
      } else if (executed_within(caller, called, network)) {
        diagnostics.report(Code::PAL0212, name.where,
                           quoted(name.text) + " executes itself" +
                               (caller == called ? std::string() : ", by way of " + quoted(unit->name.text)),
                           "use REPEAT to do something again");
      } else if (!module.executed_by.valid()) {
        network.modules[called.index()].executed_by = caller;
      } else if (module.executed_by != caller) {
        auto& finding = diagnostics.report(
            Code::PAL0211, name.where,
            quoted(name.text) + " is executed from " + quoted(unit->name.text) + " and from " +
                quoted(network.modules[module.executed_by.index()].name),
            "give each its own module: an executed module sends and receives as its caller");
        finding.notes.push_back(
            {network.modules[module.executed_by.index()].where, "it is executed here too"});
      }
    });
  }
}

}  // namespace pal::check
