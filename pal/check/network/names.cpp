#include "pal/check/network/names.hpp"

#include "pal/check/report.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

std::string slot_for(pan::ModuleKind kind, const std::string& name) {
  switch (kind) {
    case pan::ModuleKind::sensor_driver:
      return "SENSOR DRIVER " + name;
    case pan::ModuleKind::logical_sensor:
      return "LOGICAL SENSOR " + name;
    case pan::ModuleKind::machine_controller:
      return "MACHINE CONTROLLER " + name;
    case pan::ModuleKind::skill_module:
      return "SKILL METHOD " + name;
    case pan::ModuleKind::contingency_module:
      return "CONTINGENCY … METHOD " + name;
  }
  return name;
}

std::optional<std::vector<std::string>> names_of(const std::optional<syntax::NameSlot>& slot) {
  if (!slot) return std::nullopt;
  std::vector<std::string> names;
  for (const auto& name : slot->names) names.push_back(name.text);
  return names;
}

}  // namespace

pan::ModuleId Names::enter_module(const syntax::ModuleUnit& unit) {
  if (const auto known = modules_.find(unit.name.text); known != modules_.end()) return known->second;
  const pan::ModuleId id(network_.modules.size());
  network_.modules.push_back({unit.name.text,
                              unit.kind,
                              {},
                              {},
                              {},
                              unit.where,
                              unit.descriptions,
                              unit.sensor.methods,
                              names_of(unit.sensor.drivers),
                              names_of(unit.sensor.returns)});
  units_.push_back(&unit);
  modules_.emplace(unit.name.text, id);
  return id;
}

pan::DeviceId Names::enter_device(const syntax::Name& name, const syntax::DeviceUnit* unit) {
  const auto [entry, added] = devices_.emplace(name.text, pan::DeviceId(network_.devices.size()));
  if (added) {
    network_.devices.push_back(unit != nullptr ? pan::Device{unit->name.text, unit->description, unit->where}
                                               : pan::Device{name.text, {}, name.where});
  }
  return entry->second;
}

void Names::unknown(const PartialDiagnostic& what, const syntax::Name& name,
                    const std::vector<std::string>& known) {
  const Code code = row(what.finding).code;
  if (!unknown_.emplace(code, name.text).second) return;
  // The module that is missed may be the one that has another's name.
  if (scope_.module_twice && code == Code::PAL0201) return;
  report_unknown(diagnostics_, what, name, known,
                 [this](const std::string& meant) { return declaration(meant); });
}

std::optional<SourceSpan> Names::declaration(const std::string& name) const {
  if (const auto* module = scope_.modules.find(name)) return module->name.where;
  if (const auto* device = scope_.devices.find(name)) return device->name.where;
  if (const auto* message = scope_.messages.find(name)) return message->name.where;
  if (const auto* condition = scope_.conditions.find(name)) return condition->name.where;
  return std::nullopt;
}

std::optional<pan::ModuleId> Names::module(const syntax::Name& name, bool listed) {
  if (name.text.empty()) return std::nullopt;
  if (const auto* unit = scope_.modules.find(name.text)) {
    const auto id = enter_module(*unit);
    if (listed) listed_.insert(id);
    return id;
  }
  if (trusting_) {
    const auto [entry, added] = modules_.emplace(name.text, pan::ModuleId(network_.modules.size()));
    if (added) {
      network_.modules.push_back(
          {name.text, pan::ModuleKind::contingency_module, {}, {}, {}, name.where, {}, {}, {}, {}});
      units_.push_back(nullptr);
    }
    return entry->second;
  }
  if (const auto* device = scope_.devices.find(name.text)) {
    auto& finding = diagnostics_.report(Finding::device_not_module, name.where, name.text);
    finding.note(device->name.where, Remark::declared_here);
    return std::nullopt;
  }
  unknown({Finding::unknown_module, name.text}, name, scope_.modules.names());
  return std::nullopt;
}

std::optional<pan::ModuleId> Names::entered_module(const std::string& name) const {
  const auto found = modules_.find(name);
  if (found == modules_.end()) return std::nullopt;
  return found->second;
}

void Names::check_kind(const syntax::PartyName& name, pan::ModuleId module) {
  if (!name.kind) return;
  const auto& found = network_.modules[module.index()];
  if (found.kind == *name.kind) return;
  auto& finding = diagnostics_.report(Finding::module_of_another_kind, name.where, name.name.text,
                                      kind_text(found.kind), kind_text(*name.kind));
  finding.fix = {{name.where, kind_text(found.kind) + " " + name.name.text}};
  finding.note(found.where, Remark::declared_here);
}

void Names::check_listed(const syntax::Name& name, pan::ModuleId module) {
  if (trusting_ || listed_.contains(module)) return;
  const auto kind = network_.modules[module.index()].kind;
  auto& finding = diagnostics_.report(Finding::module_not_listed, name.where, network_.skill.name,
                                      kind_text(kind), name.text, slot_for(kind, name.text));
  finding.note(network_.skill.where, Remark::template_here);
  listed_.insert(module);  // once is enough
}

std::optional<pan::Party> Names::party(const syntax::PartyName& name, const std::string& speaker) {
  if (name.name.text.empty()) return std::nullopt;
  if (scope_.modules.find(name.name.text) != nullptr) {
    const auto id = *module(name.name, false);
    check_kind(name, id);
    check_listed(name.name, id);
    return id;
  }
  const auto* device = scope_.devices.find(name.name.text);
  if (device != nullptr || trusting_) {
    if (device != nullptr && name.kind) {
      auto& finding =
          diagnostics_.report(Finding::device_with_kind, name.where, name.name.text, kind_text(*name.kind));
      finding.fix = {{name.where, name.name.text}};
    }
    return enter_device(name.name, device);
  }
  auto known = scope_.modules.names();
  for (const auto& other : scope_.devices.names()) known.push_back(other);
  std::erase(known, speaker);
  unknown({Finding::unknown_party, name.name.text}, name.name, known);
  return std::nullopt;
}

std::optional<pan::ModuleId> Names::callee(const syntax::PartyName& name) {
  const auto id = module(name.name, false);
  if (!id || units_[id->index()] == nullptr) return id;
  check_kind(name, *id);
  check_listed(name.name, *id);
  return id;
}

std::optional<pan::MessageId> Names::message(const syntax::MessageName& name) {
  if (name.name.text.empty()) return std::nullopt;
  const auto* unit = scope_.messages.find(name.name.text);
  if (unit == nullptr && !trusting_) {
    unknown({Finding::unknown_message, name.name.text}, name.name, scope_.messages.names());
    return std::nullopt;
  }
  const auto [entry, added] = messages_.emplace(name.name.text, pan::MessageId(network_.messages.size()));
  if (added) {
    network_.messages.push_back(unit != nullptr ? pan::Message{unit->name.text, unit->fields, {}, unit->where}
                                                : pan::Message{name.name.text, {}, {}, name.where});
  }
  const auto answer = entry->second;
  if (!name.request) return answer;
  const auto full = "request " + name.name.text;
  const auto [request, fresh] = messages_.emplace(full, pan::MessageId(network_.messages.size()));
  if (fresh) network_.messages.push_back({full, {}, answer, network_.messages[answer.index()].where});
  return request->second;
}

std::optional<pan::ConditionId> Names::condition(const syntax::Name& name) {
  if (name.text.empty()) return std::nullopt;
  const auto* unit = scope_.conditions.find(name.text);
  if (unit == nullptr && !trusting_) {
    const auto* message = scope_.messages.find(name.text);
    if (message == nullptr) {
      unknown({Finding::unknown_condition, name.text}, name, scope_.conditions.names());
      return std::nullopt;
    }
    auto& finding = diagnostics_.report(Finding::message_not_condition, name.where, name.text);
    finding.note(message->name.where, Remark::declared_here);
    return std::nullopt;
  }
  const auto [entry, added] = conditions_.emplace(name.text, pan::ConditionId(network_.conditions.size()));
  if (added) {
    pan::Condition condition{name.text, {}, {}, {}, name.where};
    if (unit != nullptr) {
      condition.description = unit->description;
      condition.where = unit->where;
      for (const auto& from : unit->from) {
        if (const auto id = message(from)) condition.from.push_back(*id);
      }
    }
    network_.conditions.push_back(std::move(condition));
  }
  return entry->second;
}

void Names::enter_activities(pan::ModuleId module) {
  const auto* unit = unit_of(module);
  if (unit == nullptr) return;
  std::map<std::string, const syntax::Name*> seen;
  for (const auto& heading : unit->activities) {
    const auto [first, fresh] = seen.emplace(heading.name.text, &heading.name);
    if (!fresh) {
      report_twice(diagnostics_, "activity", heading.name, *first->second);
      continue;
    }
    pan::Activity activity{heading.name.text, module, {}, {}, heading.where, heading.time};
    for (const auto& read : heading.reads) {
      if (const auto id = message(read)) activity.reads.push_back(*id);
    }
    for (const auto& written : heading.writes) {
      if (const auto id = message(written)) activity.writes.push_back(*id);
    }
    activities_.emplace(std::pair(module, heading.name.text), pan::ActivityId(network_.activities.size()));
    network_.activities.push_back(std::move(activity));
  }
}

std::optional<pan::ActivityId> Names::activity(const syntax::Name& name, pan::ModuleId module) const {
  const auto found = activities_.find(std::pair(module, name.text));
  if (found == activities_.end()) return std::nullopt;
  return found->second;
}

pan::ActivityId Names::trusted_activity(const syntax::Name& name, pan::ModuleId module) {
  const auto [entry, added] =
      activities_.emplace(std::pair(module, name.text), pan::ActivityId(network_.activities.size()));
  if (added) network_.activities.push_back({name.text, module, {}, {}, name.where});
  return entry->second;
}

void Names::report_no_activity(const syntax::Name& name, pan::ModuleId module) {
  std::vector<std::string> known;
  if (may_guess(diagnostics_, network_.activities.size())) {
    for (const auto& activity : network_.activities) {
      if (activity.module == module) known.push_back(activity.name);
    }
  }
  const auto& owner = network_.modules[module.index()].name;
  const bool is_if = name.text == "IF" || name.text == "If" || name.text == "if";
  report_unknown(diagnostics_,
                 {either<Finding::if_is_no_activity, Finding::unknown_activity>(is_if), owner, name.text},
                 name, known);
}

pan::ChannelId Names::channel(const pan::Party& sender, pan::MessageId message, const pan::Party& receiver,
                              SourceSpan where) {
  const auto [entry, added] =
      channels_.emplace(std::tuple(sender, message, receiver), pan::ChannelId(network_.channels.size()));
  if (added) network_.channels.push_back({sender, message, receiver, {}, where});
  return entry->second;
}

}  // namespace pal::check
