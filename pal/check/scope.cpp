#include "pal/check/scope.hpp"

#include <algorithm>
#include <set>

#include "pal/check/report.hpp"

namespace pal::frontend {

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

}  // namespace

Scope scope_of(const std::vector<syntax::Tree>& trees, std::size_t root, Diagnostics& diagnostics) {
  Scope scope;
  scope.trees = seen_from(trees, root);
  const auto declare = [&](auto& declarations, const auto& unit, const char* what) {
    if (unit.name.text.empty()) return;  // a syntax error, already reported
    if (const auto* first = declarations.add(unit)) {
      // Of two files the one that uses the other is to be changed.
      const bool same_file = first->name.where.file == unit.name.where.file;
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

}  // namespace pal::frontend
