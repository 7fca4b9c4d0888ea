#include "pal/check/network/scope.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <type_traits>

#include "pal/check/report.hpp"
#include "pal/support/finding.hpp"
#include "pal/units/unit.hpp"

namespace pal::check {

namespace {

std::vector<std::size_t> seen_from(const std::vector<syntax::Tree>& trees, std::size_t root) {
  std::map<FileId, std::size_t> index;
  for (std::size_t i = 0; i < trees.size(); ++i) index.emplace(trees[i].file, i);
  std::vector<std::size_t> order{root};
  std::set<std::size_t> seen{root};
  for (std::size_t at = 0; at < order.size(); ++at) {
    for (const auto& unit : trees[order[at]].units) {
      const auto* uses = std::get_if<syntax::Uses>(&unit);
      if (uses == nullptr || !uses->file.valid()) continue;
      const auto found = index.find(uses->file);
      if (found != index.end() && seen.insert(found->second).second) order.push_back(found->second);
    }
  }
  return order;
}

std::string unit_text(const std::string& unit) {
  return unit.empty() ? "a plain number" : quoted(unit);
}

std::string size_text(int size) {
  return size == 0 ? "a single value" : std::to_string(size) + (size == 1 ? " value" : " values");
}

/// How one unit relates to another, if both can be compared: "1 cm is 10 mm".
std::string relation(const std::string& left, const std::string& right) {
  const auto from = units::parse_unit(left);
  const auto to = units::parse_unit(right);
  if (!from || !to) return {};
  const auto factor = units::factor(*from, *to);
  if (!factor) return from->dimension == to->dimension ? "" : ": they measure different things";
  if (factor->over == factor->under) return ": they are the same unit";
  return ": 1 " + left + " is " + std::to_string(factor->over) +
         (factor->under == 1 ? "" : "/" + std::to_string(factor->under)) + " " + right;
}

/// Two declarations of one message: what passes between those who use one and those who use the other would
/// change its meaning on the way.
void report_two_messages(const syntax::MessageUnit& second, const syntax::MessageUnit& first,
                         Diagnostics& diagnostics) {
  std::string differences;
  for (std::size_t i = 0; i < std::min(first.fields.size(), second.fields.size()); ++i) {
    const auto& a = first.fields[i];
    const auto& b = second.fields[i];
    if (a.size != b.size)
      differences +=
          "; " + quoted(b.name) + " has " + size_text(b.size) + " here and " + size_text(a.size) + " there";
    if (a.unit == b.unit) continue;
    differences += "; " + quoted(b.name) + " is in " + unit_text(b.unit) + " here and in " +
                   unit_text(a.unit) + " there" + relation(b.unit, a.unit);
  }
  if (differences.empty()) return report_twice(diagnostics, "message", second.name, first.name);
  diagnostics.report(Finding::message_declared_twice, second.name.where, second.name.text, differences)
      .note(first.name.where, Remark::also_declared);
}

}  // namespace

Scope scope_of(const std::vector<syntax::Tree>& trees, std::size_t root, Diagnostics& diagnostics) {
  Scope scope;
  scope.trees = seen_from(trees, root);
  const auto declare = [&](auto& declarations, const auto& unit, const char* what) {
    if (unit.name.text.empty()) return;  // a syntax error, already reported
    if (const auto* first = declarations.add(unit)) {
      // Of two files the one that uses the other is to be changed.
      const bool same_file = first->name.where.file == unit.name.where.file;
      if constexpr (std::is_same_v<std::decay_t<decltype(unit)>, syntax::ModuleUnit>)
        scope.module_twice = true;
      if constexpr (std::is_same_v<std::decay_t<decltype(unit)>, syntax::MessageUnit>) {
        return report_two_messages(same_file ? unit : *first, same_file ? *first : unit, diagnostics);
      }
      report_twice(diagnostics, what, same_file ? unit.name : first->name,
                   same_file ? first->name : unit.name);
    }
  };
  for (const auto index : scope.trees) {
    for (const auto& unit : trees[index].units) {
      if (const auto* message = std::get_if<syntax::MessageUnit>(&unit)) {
        declare(scope.messages, *message, "message");
      } else if (const auto* condition = std::get_if<syntax::ConditionUnit>(&unit)) {
        declare(scope.conditions, *condition, "condition");
      } else if (const auto* device = std::get_if<syntax::DeviceUnit>(&unit)) {
        declare(scope.devices, *device, "device");
      } else if (const auto* module = std::get_if<syntax::ModuleUnit>(&unit)) {
        declare(scope.modules, *module, "module");
      }
    }
  }
  // Messages go to and come from both by name alone.
  for (const auto* device : scope.devices.all()) {
    if (const auto* module = scope.modules.find(device->name.text)) {
      report_twice(diagnostics, "device", device->name, module->name);
    }
  }
  return scope;
}

}  // namespace pal::check
