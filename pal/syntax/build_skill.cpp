// The tree of a skill template.
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/syntax/build.hpp"

namespace pal::syntax {

namespace {

void append(std::vector<Name>& list, std::vector<Name> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void append(std::vector<std::string>& list, std::vector<std::string> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

SkillUnit Builder::skill_unit(Parser::SkillUnitContext* context) {
  SkillUnit result;
  result.name = name(context->name());
  result.where = span(span(context->SKILL(0)), result.name.where);
  result.whole = span(context);
  for (auto* slot : context->slot()) add_slot(result, slot);
  return result;
}

void Builder::add_slot(SkillUnit& skill, Parser::SlotContext* context) {
  if (auto* c = dynamic_cast<Parser::DescriptionSlotContext*>(context)) {
    skill.descriptions.push_back(text(c->STRING()));
    return;
  }
  if (auto* c = dynamic_cast<Parser::PreconditionSlotContext*>(context)) {
    append(skill.preconditions, texts(c->strings()));
    return;
  }
  if (auto* c = dynamic_cast<Parser::PostconditionSlotContext*>(context)) {
    append(skill.postconditions, texts(c->strings()));
    return;
  }
  if (auto* c = dynamic_cast<Parser::ModelDataSlotContext*>(context)) {
    append(skill.model_data, texts(c->strings()));
    return;
  }
  if (auto* c = dynamic_cast<Parser::SensorDriverSlotContext*>(context)) {
    append(skill.sensor_drivers, names(c->names()));
    return;
  }
  if (auto* c = dynamic_cast<Parser::MachineControllerSlotContext*>(context)) {
    append(skill.machine_controllers, names(c->names()));
    return;
  }
  if (auto* c = dynamic_cast<Parser::LogicalSensorSlotContext*>(context)) {
    append(skill.logical_sensors, names(c->names()));
    return;
  }
  if (auto* c = dynamic_cast<Parser::SkillMethodSlotContext*>(context)) {
    append(skill.skill_methods, names(c->names()));
    return;
  }
  if (auto* c = dynamic_cast<Parser::ContingencySlotContext*>(context)) {
    const auto number = integer(c->NUMBER());
    if (!number) return;
    Contingency contingency{*number, text(c->STRING()), std::nullopt, span(c), span(c->NUMBER())};
    if (c->name() != nullptr) contingency.method = name(c->name());
    skill.contingencies.push_back(std::move(contingency));
    return;
  }
  if (auto* c = dynamic_cast<Parser::ParameterSlotContext*>(context)) {
    skill.parameters.push_back(parameter(c));
    return;
  }
  if (auto* c = dynamic_cast<Parser::CompletionSlotContext*>(context)) {
    if (auto built = completion(c)) skill.completions.push_back(std::move(*built));
    return;
  }
  if (auto* c = dynamic_cast<Parser::RequirementSlotContext*>(context)) {
    if (auto built = requirement(c)) skill.requirements.push_back(std::move(*built));
  }
}

Parameter Builder::parameter(Parser::ParameterSlotContext* context) {
  const auto errors_before = diagnostics_.errors();
  Parameter result;
  result.name = name(context->name());
  result.where = span(context);
  auto* declared = context->parameterType();
  result.location = declared != nullptr && declared->LOCATION() != nullptr;
  auto written = result.location       ? TypeOf{pan::ScalarType::text, {}, 0}
                 : declared != nullptr ? type(declared->type())
                                       : TypeOf{};
  result.type = written.type;
  result.unit = std::move(written.unit);
  if (written.size != 0) {
    diagnostics_.report(Finding::parameter_is_no_array, span(declared));
  }
  const auto literals = context->literal();
  std::size_t next = 0;
  const auto take = [&] { return next < literals.size() ? literal(literals[next++]) : std::nullopt; };
  if (context->DEFAULT() != nullptr) result.default_value = take();
  if (context->RANGE() != nullptr) {
    result.low = take();
    result.high = take();
  }
  result.description = text(context->STRING());
  // A figure that could not be read is no wrong default or range besides.
  if (diagnostics_.errors() != errors_before) diagnostics_.distrust(result.where);
  return result;
}

std::optional<Completion> Builder::completion(Parser::CompletionSlotContext* context) {
  Completion result;
  const auto code = integer(context->NUMBER(0));
  if (!code) return std::nullopt;
  result.code = *code;
  result.where = span(context);
  result.code_where = span(context->NUMBER(0));
  if (context->CONTINGENCY() != nullptr) {
    result.contingency_where = span(context->NUMBER(1));
    result.kind = pan::Completion::Kind::contingency;
    result.contingency = integer(context->NUMBER(1)).value_or(0);
  } else if (context->ERROR() != nullptr) {
    result.kind = pan::Completion::Kind::error;
  }
  result.description = text(context->STRING());
  return result;
}

}  // namespace pal::syntax
