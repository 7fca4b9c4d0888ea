#include "pal/check/calls.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "pal/check/report.hpp"
#include "pal/support/diagnostic_code.hpp"

namespace pal::frontend {

namespace {

/// Every Execute and bare name, in the order of the text, and whether it stands in a block of CONCURRENT.
template <class Visit>
void each_call(const syntax::Statements& statements, const Visit& visit, bool in_block = false) {
  for (const auto& statement : statements) {
    if (const auto* execute = std::get_if<syntax::Execute>(&statement.content)) {
      visit(execute->module.name, in_block);
    } else if (const auto* perform = std::get_if<syntax::Perform>(&statement.content)) {
      visit(perform->name, in_block);
    } else if (const auto* wait = std::get_if<syntax::WaitBranches>(&statement.content)) {
      for (const auto& arm : wait->arms) each_call(arm.body, visit, in_block);
      each_call(wait->otherwise, visit, in_block);
    } else if (const auto* choose = std::get_if<syntax::Choose>(&statement.content)) {
      for (const auto& arm : choose->arms) each_call(arm.body, visit, in_block);
    } else if (const auto* repeat = std::get_if<syntax::Repeat>(&statement.content)) {
      each_call(repeat->body, visit, in_block);
    } else if (const auto* concurrent = std::get_if<syntax::Concurrent>(&statement.content)) {
      for (const auto& block : concurrent->blocks) each_call(block.body, visit, true);
    }
  }
}

bool has_concurrent(const syntax::Statements& statements) {
  return std::any_of(statements.begin(), statements.end(), [](const syntax::Statement& statement) {
    if (std::holds_alternative<syntax::Concurrent>(statement.content)) return true;
    if (const auto* wait = std::get_if<syntax::WaitBranches>(&statement.content)) {
      return has_concurrent(wait->otherwise) ||
             std::any_of(wait->arms.begin(), wait->arms.end(),
                         [](const auto& arm) { return has_concurrent(arm.body); });
    }
    if (const auto* choose = std::get_if<syntax::Choose>(&statement.content)) {
      return std::any_of(choose->arms.begin(), choose->arms.end(),
                         [](const auto& arm) { return has_concurrent(arm.body); });
    }
    const auto* repeat = std::get_if<syntax::Repeat>(&statement.content);
    return repeat != nullptr && has_concurrent(repeat->body);
  });
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

/// A CONCURRENT has one set of threads. A module that runs in a block may run in two of them at a time.
void report_blocks_within(const std::map<std::size_t, SourceSpan>& called_in_block, const Names& names,
                          const pan::Network& network, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const auto* unit = names.unit_of(pan::ModuleId(i));
    if (unit == nullptr || !has_concurrent(unit->body)) continue;
    auto at = pan::ModuleId(i);
    std::size_t steps = 0;
    while (at.valid() && !called_in_block.contains(at.index()) && ++steps <= network.modules.size()) {
      at = network.modules[at.index()].executed_by;
    }
    if (!at.valid() || !called_in_block.contains(at.index())) continue;
    auto& finding = diagnostics.report(
        Code::PAL0216, called_in_block.at(at.index()),
        quoted(unit->name.text) + " has a CONCURRENT, so it cannot be executed in a block of another",
        "write the CONCURRENT of " + quoted(unit->name.text) + " in the block itself");
    finding.notes.push_back({network.modules[i].where, "it is declared here"});
  }
}

}  // namespace

void enter_calls(Names& names, pan::Network& network, Diagnostics& diagnostics) {
  std::map<std::size_t, SourceSpan> called_in_block;  // module -> the first such place
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const pan::ModuleId caller(i);
    const auto* unit = names.unit_of(caller);
    if (unit == nullptr) continue;
    const auto activities = activities_of(*unit);
    each_call(unit->body, [&](const syntax::Name& name, bool in_block) {
      if (activities.contains(name.text) || !names.is_module(name.text)) return;
      const auto called = *names.module(name, false);
      const auto& module = network.modules[called.index()];
      if (in_block) called_in_block.emplace(called.index(), name.where);
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
        auto& finding =
            diagnostics.report(Code::PAL0211, name.where,
                               quoted(name.text) + " is executed from " + quoted(unit->name.text) +
                                   " and from " + quoted(network.modules[module.executed_by.index()].name),
                               "give each its own module: a module talks as the one that executes it");
        finding.notes.push_back(
            {network.modules[module.executed_by.index()].where, "it is executed here too"});
      }
    });
  }
  report_blocks_within(called_in_block, names, network, diagnostics);
}

}  // namespace pal::frontend
