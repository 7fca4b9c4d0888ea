// The trees of files and modules.
#include <utility>

#include "pal/syntax/build.hpp"

namespace pal::syntax {

Tree Builder::build(Parser::FileContext* file) {
  Tree tree;
  tree.file = tokens_.file();
  for (auto* child : file->unit()) {
    if (auto built = unit(child)) tree.units.push_back(std::move(*built));
  }
  return tree;
}

std::optional<Unit> Builder::unit(Parser::UnitContext* context) {
  if (auto* c = context->uses()) {
    if (is_made_up(c->STRING()->getSymbol())) return std::nullopt;
    return uses(c);
  }
  if (auto* c = context->messageUnit()) return message_unit(c);
  if (auto* c = context->conditionUnit()) return condition_unit(c);
  if (auto* c = context->deviceUnit()) return device_unit(c);
  if (auto* c = context->moduleUnit()) return module_unit(c);
  if (auto* c = context->skillUnit()) return skill_unit(c);
  if (auto* c = context->environmentUnit()) return environment_unit(c);
  return std::nullopt;
}

Uses Builder::uses(Parser::UsesContext* context) {
  return {text(context->STRING()), span(context->STRING()), {}};
}

MessageUnit Builder::message_unit(Parser::MessageUnitContext* context) {
  MessageUnit result{name(context->name()), {}, {}, span(context)};
  auto* payload = context->payload();
  if (payload == nullptr) return result;
  if (payload->type() != nullptr) {
    auto written = type(payload->type());
    result.fields.push_back({"value", written.type, std::move(written.unit), written.size});
    return result;
  }
  for (auto* group : payload->fieldGroup()) {
    const auto field = type(group->type());
    for (auto& field_name : names(group->name())) {
      result.fields.push_back({field_name.text, field.type, field.unit, field.size});
      result.field_names.push_back(std::move(field_name));
    }
  }
  return result;
}

ConditionUnit Builder::condition_unit(Parser::ConditionUnitContext* context) {
  auto all = names(context->name());
  ConditionUnit result;
  result.where = span(context);
  result.description = text(context->STRING());
  if (all.empty()) return result;
  result.name = std::move(all.front());
  result.from.assign(std::make_move_iterator(all.begin() + 1), std::make_move_iterator(all.end()));
  return result;
}

DeviceUnit Builder::device_unit(Parser::DeviceUnitContext* context) {
  return {name(context->name()), text(context->STRING()), span(context)};
}

ModuleUnit Builder::module_unit(Parser::ModuleUnitContext* context) {
  ModuleUnit result;
  result.name = name(context->name());
  if (const auto word = kind(context->header())) result.kind = *word;
  result.where = span(span(context->header()), result.name.where);
  result.whole = span(context);
  for (auto* heading : context->heading()) add_heading(result, heading);
  result.has_body = context->BEGIN() != nullptr;
  result.body = statements(context->statements());
  result.end = span(context->END());
  return result;
}

void Builder::add_heading(ModuleUnit& module, Parser::HeadingContext* context) {
  if (auto* c = dynamic_cast<Parser::ModuleDescriptionContext*>(context)) {
    module.descriptions.push_back(text(c->STRING()));
    return;
  }
  auto* c = dynamic_cast<Parser::ActivityContext*>(context);
  if (c == nullptr) {
    add_sensor_slot(module.sensor, context);
    return;
  }
  ActivityHeading activity;
  activity.name = name(c->activityName());
  activity.where = span(c);
  for (auto* access : c->access()) {
    auto& list = access->READS() != nullptr ? activity.reads : activity.writes;
    for (auto& message : names(access->name())) list.push_back(std::move(message));
  }
  if (c->TIME() != nullptr) activity.time = interval(c->interval());
  module.activities.push_back(std::move(activity));
}

void Builder::add_sensor_slot(SensorTemplate& sensor, Parser::HeadingContext* context) {
  const auto add = [&](std::optional<NameSlot>& slot, Parser::NamesContext* listed) {
    if (!slot) slot = NameSlot{{}, span(context)};
    for (auto& name : names(listed)) slot->names.push_back(std::move(name));
  };
  if (!sensor.where.valid()) sensor.where = span(context);
  if (auto* c = dynamic_cast<Parser::RequiredDriversContext*>(context)) {
    add(sensor.drivers, c->names());
  } else if (auto* r = dynamic_cast<Parser::ReturnedContext*>(context)) {
    add(sensor.returns, r->names());
  } else if (auto* m = dynamic_cast<Parser::SensorMethodsContext*>(context)) {
    for (auto& text : texts(m->strings())) sensor.methods.push_back(std::move(text));
  }
}

}  // namespace pal::syntax
