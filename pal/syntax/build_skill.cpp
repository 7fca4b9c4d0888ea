#include <cmath>
#include <utility>

#include "pal/support/diagnostic_code.hpp"
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
    Contingency contingency{*number, text(c->STRING()), std::nullopt, span(c)};
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
  Parameter result;
  result.name = name(context->name());
  result.where = span(context);
  if (auto* type = context->type()) {
    result.type = type->INTEGER() != nullptr   ? pan::ScalarType::integer
                  : type->BOOLEAN() != nullptr ? pan::ScalarType::boolean
                                               : pan::ScalarType::real;
    result.unit = unit(type->physicalUnit());
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
  return result;
}

std::optional<Completion> Builder::completion(Parser::CompletionSlotContext* context) {
  Completion result;
  const auto code = integer(context->NUMBER(0));
  if (!code) return std::nullopt;
  result.code = *code;
  result.where = span(context);
  if (context->CONTINGENCY() != nullptr) {
    result.kind = pan::Completion::Kind::contingency;
    result.contingency = integer(context->NUMBER(1)).value_or(0);
  } else if (context->ERROR() != nullptr) {
    result.kind = pan::Completion::Kind::error;
  }
  result.description = text(context->STRING());
  return result;
}

std::optional<Requirement> Builder::requirement(Parser::RequirementSlotContext* context) {
  Requirement result;
  result.name = name(context->name());
  result.where = span(context);
  auto* measure = context->measure();
  if (auto* c = dynamic_cast<Parser::ResponseContext*>(measure)) {
    auto to = step(c->step());
    if (!to) return std::nullopt;
    result.measure = Requirement::Response{message(c->message()), party(c->party()), std::move(*to)};
    result.limit = duration(c->duration());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::AgeContext*>(measure)) {
    auto at = step(c->step());
    if (!at) return std::nullopt;
    result.measure = Requirement::Age{name(c->name()), std::move(*at)};
    result.limit = duration(c->duration());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::LoadContext*>(measure)) {
    Requirement::Load load;
    if (c->name() != nullptr) load.processor = name(c->name());
    result.measure = std::move(load);
    const auto percent = real(c->NUMBER());
    if (percent && (*percent < 0 || *percent > 100)) {
      diagnostics_.report(Code::PAL0801, span(c->NUMBER(), c->PERCENT()), "a load is between 0 % and 100 %",
                          "write a part of the processor's time, such as 80 %");
    } else if (percent) {
      constexpr double nanoseconds_per_percent = 1e7;  // of work in a second
      result.limit = Duration{std::llround(*percent * nanoseconds_per_percent)};
    }
    return result;
  }
  return std::nullopt;
}

std::optional<Step> Builder::step(Parser::StepContext* context) {
  if (context == nullptr || context->pattern() == nullptr) return std::nullopt;
  auto* pattern = context->pattern();
  Step result;
  result.where = span(pattern);
  if (context->party() != nullptr) result.in = party(context->party());
  if (auto* c = dynamic_cast<Parser::WaitPatternContext*>(pattern)) {
    auto from = source(c->source());
    result.kind = Step::Kind::wait;
    result.message = std::move(from.message);
    result.party = std::move(from.from);
    return result;
  }
  if (auto* c = dynamic_cast<Parser::SendPatternContext*>(pattern)) {
    result.kind = Step::Kind::send;
    result.message = message(c->message());
    result.party = party(c->party());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::AskPatternContext*>(pattern)) {
    result.kind = Step::Kind::send;
    result.message = message(c->message());
    result.party = party(c->party());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::SetPatternContext*>(pattern)) {
    result.kind = Step::Kind::set;
    result.name = name(c->name());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::ReadPatternContext*>(pattern)) {
    result.kind = Step::Kind::read;
    result.name = name(c->name());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::ActivityPatternContext*>(pattern)) {
    result.kind = Step::Kind::perform;
    result.name = name(c->activityName());
    return result;
  }
  return std::nullopt;
}

}  // namespace pal::syntax
