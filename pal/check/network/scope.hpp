// What one file sees: its own declarations and those of the files that it uses.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// Declarations of one sort, by name and in order: the file's own first, then those of used files.
template <class Unit>
class Declarations {
 public:
  /// Gives the declaration that already has the name, or nullptr after adding this one.
  const Unit* add(const Unit& unit) {
    const auto [entry, added] = by_name_.emplace(unit.name.text, &unit);
    if (!added) return entry->second;
    in_order_.push_back(&unit);
    names_.push_back(unit.name.text);
    return nullptr;
  }
  const Unit* find(std::string_view name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : found->second;
  }
  const std::vector<const Unit*>& all() const { return in_order_; }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::map<std::string, const Unit*, std::less<>> by_name_;
  std::vector<const Unit*> in_order_;
  std::vector<std::string> names_;  // in the same order
};

struct Scope {
  std::vector<std::size_t> trees;  // indices of the files seen, the file itself first
  Declarations<syntax::MessageUnit> messages;
  Declarations<syntax::ConditionUnit> conditions;
  Declarations<syntax::DeviceUnit> devices;
  Declarations<syntax::ModuleUnit> modules;
  bool module_twice = false;  // one of two modules of a name is lost
};

/// What `trees[root]` sees. Reports names that it sees twice.
Scope scope_of(const std::vector<syntax::Tree>& trees, std::size_t root, Diagnostics& diagnostics);

}  // namespace pal::check
