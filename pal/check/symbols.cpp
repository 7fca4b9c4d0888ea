#include "pal/check/symbols.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "pal/check/network/scope.hpp"

namespace pal::check {

namespace {

using PlaceKey = std::pair<FileId, std::uint32_t>;

PlaceKey key(const SourceSpan& where) {
  return {where.file, where.begin};
}

class SymbolFinder {
 public:
  explicit SymbolFinder(const std::vector<syntax::Tree>& trees) : trees_(trees) {}

  Symbols find() {
    for (const auto& tree : trees_) {
      for (const auto& unit : tree.units) std::visit([this](const auto& each) { declare(each); }, unit);
    }
    for (const std::size_t root : roots()) look_from(root);
    for (const auto& tree : trees_) {
      for (const auto& unit : tree.units) {
        if (const auto* environment = std::get_if<syntax::EnvironmentUnit>(&unit)) look_up(*environment);
      }
    }
    for (const auto& [place, symbol, role] : found_) result_.uses.push_back({place_of(place), symbol, role});
    return std::move(result_);
  }

 private:
  struct Place {
    FileId file;
    std::uint32_t begin, end;
    auto operator<=>(const Place&) const = default;
  };
  static SourceSpan place_of(const Place& place) { return {place.file, place.begin, place.end}; }

  void add_use(const SourceSpan& where, std::size_t symbol, UseRole role) {
    found_.emplace(Place{where.file, where.begin, where.end}, symbol, role);
  }

  // ---- declarations

  void declare(SymbolKind kind, const std::string& name, SourceSpan name_where, SourceSpan where,
               const std::string& owner = {}) {
    if (name.empty() || !name_where.valid() || name_where.begin == name_where.end) return;
    const std::size_t id = result_.all.size();
    if (!declared_.emplace(key(name_where), id).second) return;
    result_.all.push_back({kind, name, name_where, where, owner});
    by_name_[{kind, name}].push_back(id);
    add_use(name_where, id, UseRole::declaration);
  }
  void declare(SymbolKind kind, const syntax::Name& name, SourceSpan where, const std::string& owner = {}) {
    declare(kind, name.text, name.where, where, owner);
  }

  void declare(const syntax::Uses&) {}
  void declare(const syntax::MessageUnit& unit) {
    declare(SymbolKind::message, unit.name, unit.where);
    for (const auto& field : unit.field_names)
      declare(SymbolKind::field, field, field.where, unit.name.text);
  }
  void declare(const syntax::ConditionUnit& unit) { declare(SymbolKind::condition, unit.name, unit.where); }
  void declare(const syntax::DeviceUnit& unit) { declare(SymbolKind::device, unit.name, unit.where); }
  void declare(const syntax::ModuleUnit& unit) {
    declare(SymbolKind::module, unit.name, unit.whole);
    for (const auto& activity : unit.activities)
      declare(SymbolKind::activity, activity.name, activity.where, unit.name.text);
  }
  void declare(const syntax::SkillUnit& unit) {
    declare(SymbolKind::skill, unit.name, unit.whole);
    const std::string& owner = unit.name.text;
    for (const auto& each : unit.parameters) declare(SymbolKind::parameter, each.name, each.where, owner);
    for (const auto& each : unit.requirements) declare(SymbolKind::requirement, each.name, each.where, owner);
    for (const auto& each : unit.contingencies)
      declare(SymbolKind::contingency, std::to_string(each.number), each.number_where, each.where, owner);
    for (const auto& each : unit.completions)
      declare(SymbolKind::completion, std::to_string(each.code), each.code_where, each.where, owner);
  }
  void declare(const syntax::EnvironmentUnit& unit) {
    declare(SymbolKind::environment, unit.name, unit.whole);
    for (const auto& each : unit.names) {
      if (each.role == syntax::ItemName::Role::processor)
        declare(SymbolKind::processor, each.name, each.item, unit.name.text);
    }
  }

  // ---- what sees what

  std::vector<std::size_t> roots() const {
    std::set<FileId> used;
    for (const auto& tree : trees_) {
      for (const auto& unit : tree.units) {
        const auto* uses = std::get_if<syntax::Uses>(&unit);
        if (uses != nullptr && uses->file.valid() && uses->file != tree.file) used.insert(uses->file);
      }
    }
    std::vector<std::size_t> result;
    std::set<std::size_t> seen;
    const auto add = [&](std::size_t tree) {
      result.push_back(tree);
      Diagnostics unwanted;
      for (const std::size_t each : scope_of(trees_, tree, unwanted).trees) seen.insert(each);
    };
    for (std::size_t i = 0; i < trees_.size(); ++i) {
      const bool skill = std::any_of(trees_[i].units.begin(), trees_[i].units.end(), [](const auto& unit) {
        return std::holds_alternative<syntax::SkillUnit>(unit);
      });
      if (skill || !used.contains(trees_[i].file)) add(i);
    }
    for (std::size_t i = 0; i < trees_.size(); ++i) {  // a circle of files that no other one uses
      if (!seen.contains(i)) add(i);
    }
    return result;
  }

  void look_from(std::size_t root) {
    Diagnostics unwanted;
    const Scope scope = scope_of(trees_, root, unwanted);
    scope_ = &scope;
    for (const auto& unit : trees_[root].units) {
      if (const auto* skill = std::get_if<syntax::SkillUnit>(&unit)) look_up(*skill);
    }
    for (const std::size_t tree : scope.trees) {
      for (const auto& unit : trees_[tree].units) {
        if (const auto* condition = std::get_if<syntax::ConditionUnit>(&unit)) {
          for (const auto& from : condition->from) message(from, UseRole::read);
        } else if (const auto* module = std::get_if<syntax::ModuleUnit>(&unit)) {
          look_up(*module);
        }
      }
    }
    scope_ = nullptr;
  }

  // ---- names

  template <class Unit>
  bool use(const Unit* unit, const syntax::Name& name, UseRole role) {
    if (unit == nullptr) return false;
    const auto found = declared_.find(key(unit->name.where));
    if (found == declared_.end()) return false;
    add_use(name.where, found->second, role);
    return true;
  }
  bool module(const syntax::Name& name) {
    return use(scope_->modules.find(name.text), name, UseRole::mention);
  }
  void party(const syntax::Name& name) {
    if (!module(name)) use(scope_->devices.find(name.text), name, UseRole::mention);
  }
  void message(const syntax::Name& name, UseRole role) {
    use(scope_->messages.find(name.text), name, role);
  }
  void condition(const syntax::Name& name, UseRole role) {
    use(scope_->conditions.find(name.text), name, role);
  }
  bool activity(const syntax::Name& name, const syntax::ModuleUnit& of) {
    const auto found = std::find_if(of.activities.begin(), of.activities.end(),
                                    [&](const auto& each) { return each.name.text == name.text; });
    return found != of.activities.end() && use(&*found, name, UseRole::mention);
  }
  void numbered(SymbolKind kind, int number, SourceSpan where, const std::string& owner) {
    if (!where.valid()) return;
    const auto found = by_name_.find({kind, std::to_string(number)});
    if (found == by_name_.end()) return;
    for (const std::size_t symbol : found->second) {
      if (result_.all[symbol].owner == owner) add_use(where, symbol, UseRole::mention);
    }
  }

  void names(const std::vector<syntax::Name>& list) {
    for (const auto& name : list) module(name);
  }
  void slot(const std::optional<syntax::NameSlot>& slot, bool messages) {
    if (!slot) return;
    for (const auto& name : slot->names) messages ? message(name, UseRole::mention) : party(name);
  }

  // ---- templates

  void look_up(const syntax::SkillUnit& skill) {
    for (const auto* list : {&skill.sensor_drivers, &skill.machine_controllers, &skill.logical_sensors,
                             &skill.skill_methods})
      names(*list);
    for (const auto& each : skill.contingencies) {
      if (each.method) module(*each.method);
    }
    for (const auto& each : skill.completions)
      numbered(SymbolKind::contingency, each.contingency, each.contingency_where, skill.name.text);
    for (const auto& each : skill.requirements) {
      std::visit([&](const auto& measure) { look_up(measure, skill); }, each.measure);
      if (each.phase) step(each.phase->step);
    }
  }

  void look_up(const syntax::Requirement::Response& it, const syntax::SkillUnit&) {
    message(it.event.name, UseRole::mention);
    party(it.of.name);
    step(it.to);
  }
  void look_up(const syntax::Requirement::Age& it, const syntax::SkillUnit&) {
    known(it.of);
    step(it.at);
  }
  void look_up(const syntax::Requirement::Reaction& it, const syntax::SkillUnit&) {
    known(it.of);
    step(it.at);
  }
  void look_up(const syntax::Requirement::Passes& it, const syntax::SkillUnit&) { step(it.at); }
  void look_up(const syntax::Requirement::Loss& it, const syntax::SkillUnit&) { party(it.of.name); }
  void look_up(const syntax::Requirement::Completing& it, const syntax::SkillUnit& skill) {
    numbered(SymbolKind::completion, it.code, it.where, skill.name.text);
  }
  void look_up(const syntax::Requirement::Load& it, const syntax::SkillUnit&) { processor(it.processor); }
  void look_up(const syntax::Requirement::BusyPeriod& it, const syntax::SkillUnit&) {
    processor(it.processor);
  }
  void processor(const std::optional<syntax::Name>& name) {
    if (name) everywhere(SymbolKind::processor, *name);
  }
  void known(const syntax::Known& known) {
    if (const auto* name = std::get_if<syntax::Name>(&known.of)) {
      condition(*name, UseRole::mention);
    } else {
      const auto& sample = std::get<syntax::Known::Sample>(known.of);
      message(sample.message.name, UseRole::mention);
      party(sample.from.name);
    }
  }
  void step(const syntax::Step& step) {
    if (step.in) module(step.in->name);
    switch (step.kind) {
      case syntax::Step::Kind::wait:
      case syntax::Step::Kind::send:
        message(step.message.name, UseRole::mention);
        party(step.party.name);
        return;
      case syntax::Step::Kind::set:
      case syntax::Step::Kind::read:
        condition(step.name, UseRole::mention);
        return;
      case syntax::Step::Kind::perform:
        for (const auto* unit : scope_->modules.all()) {
          if (!step.in || step.in->name.text == unit->name.text) activity(step.name, *unit);
        }
    }
  }

  // ---- modules

  void look_up(const syntax::ModuleUnit& module) {
    module_ = &module;
    for (const auto& activity : module.activities) {
      for (const auto& name : activity.reads) message(name, UseRole::read);
      for (const auto& name : activity.writes) message(name, UseRole::write);
    }
    slot(module.sensor.drivers, false);
    slot(module.sensor.returns, true);
    list(module.body);
  }

  void list(const syntax::Statements& statements) {
    for (const auto& statement : statements)
      std::visit([this](const auto& content) { look_up(content); }, statement.content);
  }
  void source(const syntax::Source& source) {
    message(source.message.name, UseRole::read);
    party(source.from.name);
  }
  void guard(const syntax::Guard& guard) {
    if (guard.kind == syntax::Guard::Kind::equals) condition(guard.condition, UseRole::read);
    for (const auto& term : guard.terms) this->guard(term);
  }

  void look_up(const syntax::WaitForStart&) {}
  void look_up(const syntax::Wait& wait) { source(wait.source); }
  void look_up(const syntax::WaitBranches& wait) {
    for (const auto& arm : wait.arms) {
      source(arm.source);
      list(arm.body);
    }
    list(wait.otherwise);
  }
  void look_up(const syntax::Send& send) {
    message(send.message.name, UseRole::write);
    party(send.to.name);
  }
  /// Those of the skills in the file that everything is looked up from.
  void look_up(const syntax::Complete& complete) {
    for (const auto& unit : trees_[scope_->trees.front()].units) {
      if (const auto* skill = std::get_if<syntax::SkillUnit>(&unit))
        numbered(SymbolKind::completion, complete.code, complete.code_where, skill->name.text);
    }
  }
  void look_up(const syntax::Set& set) { condition(set.condition, UseRole::write); }
  void look_up(const syntax::Read& read) { condition(read.condition, UseRole::read); }
  void look_up(const syntax::Choose& choose) {
    for (const auto& arm : choose.arms) {
      guard(arm.guard);
      list(arm.body);
    }
  }
  void look_up(const syntax::Repeat& repeat) {
    list(repeat.body);
    if (repeat.until) guard(*repeat.until);
  }
  void look_up(const syntax::Concurrent& concurrent) {
    for (const auto& block : concurrent.blocks) list(block.body);
  }
  void look_up(const syntax::Execute& execute) {
    // Execute of an activity is that activity.
    if (execute.module.kind || !activity(execute.module.name, *module_)) module(execute.module.name);
  }
  void look_up(const syntax::Nothing&) {}
  void look_up(const syntax::Perform& perform) {
    if (!activity(perform.name, *module_)) module(perform.name);
  }

  // ---- environments

  void everywhere(SymbolKind kind, const syntax::Name& name, const std::string& owner = {}) {
    const auto found = by_name_.find({kind, name.text});
    if (found == by_name_.end()) return;
    for (const std::size_t symbol : found->second) {
      if (owner.empty() || result_.all[symbol].owner == owner) add_use(name.where, symbol, UseRole::mention);
    }
  }
  void everywhere(SymbolKind kind, const std::optional<syntax::NameSlot>& slot) {
    if (!slot) return;
    for (const auto& name : slot->names) everywhere(kind, name);
  }

  void look_up(const syntax::EnvironmentUnit& environment) {
    using Role = syntax::ItemName::Role;
    everywhere(SymbolKind::module, environment.resources.sensor_drivers);
    everywhere(SymbolKind::module, environment.resources.logical_sensors);
    everywhere(SymbolKind::module, environment.resources.machine_controllers);
    everywhere(SymbolKind::skill, environment.resources.skills);
    for (const auto& each : environment.names) {
      switch (each.role) {
        case Role::processor:
          break;
        case Role::placed_on:
          everywhere(SymbolKind::processor, each.name, environment.name.text);
          break;
        case Role::device:
          everywhere(SymbolKind::device, each.name);
          everywhere(SymbolKind::module, each.name);
          break;
        case Role::message:
          everywhere(SymbolKind::message, each.name);
          break;
        case Role::thread:
        case Role::owner:
          everywhere(SymbolKind::module, each.name);
          break;
        case Role::activity:
          everywhere(SymbolKind::activity, each.name, each.owner);
      }
    }
  }

  const std::vector<syntax::Tree>& trees_;
  Symbols result_;
  std::map<PlaceKey, std::size_t> declared_;
  std::map<std::pair<SymbolKind, std::string>, std::vector<std::size_t>> by_name_;
  std::set<std::tuple<Place, std::size_t, UseRole>> found_;
  const Scope* scope_ = nullptr;
  const syntax::ModuleUnit* module_ = nullptr;
};

}  // namespace

std::vector<const Use*> Symbols::at(FileId file, std::uint32_t offset) const {
  std::vector<const Use*> result;
  // Names do not overlap: those that end before the offset come first.
  auto use = std::partition_point(uses.begin(), uses.end(), [&](const Use& each) {
    return std::tuple(each.where.file, each.where.end) < std::tuple(file, offset);
  });
  for (; use != uses.end() && use->where.file == file && use->where.begin <= offset; ++use)
    result.push_back(&*use);
  return result;
}

Symbols symbols_of(const std::vector<syntax::Tree>& trees) {
  return SymbolFinder(trees).find();
}

const char* name(SymbolKind kind) {
  constexpr std::array names{"skill",     "module",    "device",      "message",     "field",
                             "condition", "activity",  "parameter",   "requirement", "contingency",
                             "completion", "environment", "processor"};
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace pal::check
