// The tree of an environment, made from what the grammar read.
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/syntax/build.hpp"

namespace pal::syntax {

namespace {

std::string full_name(const MessageName& message) {
  return (message.request ? "request " : "") + message.name.text;
}

}  // namespace

EnvironmentUnit Builder::environment_unit(Parser::EnvironmentUnitContext* context) {
  EnvironmentUnit result;
  result.name = name(context->name());
  result.where = span(span(context->ENVIRONMENT(0)), result.name.where);
  result.whole = span(context);
  for (auto* item : context->item()) {
    add_item(result, item);
    add_names(result.names, item);
  }
  return result;
}

void Builder::add_names(std::vector<ItemName>& names, Parser::ItemContext* context) const {
  using Role = ItemName::Role;
  const auto add = [&](Role role, antlr4::ParserRuleContext* named, std::string owner = {}) {
    if (named == nullptr) return;
    auto made = name(named);
    if (!made.text.empty()) names.push_back({role, std::move(made), span(context), std::move(owner)});
  };
  if (auto* p = dynamic_cast<Parser::ProcessorContext*>(context)) {
    add(Role::processor, p->name());
  } else if (auto* e = dynamic_cast<Parser::EventDeviceContext*>(context)) {
    add(Role::device, e->name());
    if (e->message() != nullptr) add(Role::message, e->message()->name());
    for (auto* clause : e->eventClause()) {
      if (clause->message() != nullptr) add(Role::message, clause->message()->name());
    }
  } else if (auto* r = dynamic_cast<Parser::RequestDeviceContext*>(context)) {
    add(Role::device, r->name());
  } else if (auto* f = dynamic_cast<Parser::FrameDeviceContext*>(context)) {
    add(Role::device, f->name());
  } else if (auto* placed = dynamic_cast<Parser::PlacementContext*>(context)) {
    if (placed->thread() != nullptr) {
      for (auto* part : placed->thread()->threadPart()) add(Role::thread, part->name());
    }
    add(Role::placed_on, placed->name());
  } else if (auto* t = dynamic_cast<Parser::ActivityTimeContext*>(context)) {
    add(Role::activity, t->activityName(), name(t->name()).text);
    add(Role::owner, t->name());
  }
}

bool Builder::add_resource(Resources& resources, Parser::ItemContext* context) {
  const auto add = [&](std::optional<NameSlot>& slot, Parser::NamesContext* listed) {
    if (!slot) slot = NameSlot{{}, span(context)};
    for (auto& name : names(listed)) slot->names.push_back(std::move(name));
    return true;
  };
  if (auto* d = dynamic_cast<Parser::AvailableDriversContext*>(context)) {
    return add(resources.sensor_drivers, d->names());
  }
  if (auto* s = dynamic_cast<Parser::AvailableSensorsContext*>(context)) {
    return add(resources.logical_sensors, s->names());
  }
  if (auto* m = dynamic_cast<Parser::AvailableMachinesContext*>(context)) {
    return add(resources.machine_controllers, m->names());
  }
  if (auto* g = dynamic_cast<Parser::AvailableSkillsContext*>(context))
    return add(resources.skills, g->names());
  return false;
}

std::string Builder::thread(Parser::ThreadContext* context) {
  std::string result;
  if (context == nullptr) return result;
  for (auto* part : context->threadPart()) {
    result += (result.empty() ? "" : "/") + name(part->name()).text;
    if (part->NUMBER() != nullptr) result += "." + std::to_string(integer(part->NUMBER()).value_or(0));
  }
  return result;
}

/// What else there is to say of a device with an unreadable time would only follow from that.
template <typename Behaviour>
void Builder::add_device(EnvironmentUnit& environment, const std::string& name, SourceSpan where,
                         const Behaviour& behaviour) {
  const auto errors = diagnostics_.errors();
  environment.devices.push_back({name, behaviour(), where});
  if (diagnostics_.errors() != errors) diagnostics_.distrust(where);
}

void Builder::add_item(EnvironmentUnit& environment, Parser::ItemContext* context) {
  if (add_resource(environment.resources, context)) return;
  const auto where = span(context);
  if (auto* c = dynamic_cast<Parser::EnvironmentDescriptionContext*>(context)) {
    environment.descriptions.push_back(text(c->STRING()));
    return;
  }
  if (auto* c = dynamic_cast<Parser::ProcessorContext*>(context)) {
    environment.processors.push_back({name(c->name()).text, c->NONPREEMPTIVE() == nullptr, where});
    return;
  }
  if (auto* c = dynamic_cast<Parser::EventDeviceContext*>(context)) {
    return add_device(environment, name(c->name()).text, where, [&] { return event_device(c); });
  }
  if (auto* c = dynamic_cast<Parser::RequestDeviceContext*>(context)) {
    return add_device(environment, name(c->name()).text, where, [&] {
      return pan::RequestDevice{interval(c->interval()), c->NEVER() != nullptr};
    });
  }
  if (auto* c = dynamic_cast<Parser::FrameDeviceContext*>(context)) {
    return add_device(environment, name(c->name()).text, where, [&] { return frame_device(c); });
  }
  if (auto* c = dynamic_cast<Parser::PlacementContext*>(context)) {
    environment.placements.push_back(
        {thread(c->thread()), name(c->name()).text, integer(c->NUMBER()).value_or(0), where});
    return;
  }
  if (auto* c = dynamic_cast<Parser::ActivityTimeContext*>(context)) {
    environment.activities.push_back(
        {name(c->activityName()).text, name(c->name()).text, interval(c->interval()), where});
    return;
  }
  if (auto* c = dynamic_cast<Parser::CostContext*>(context)) {
    const auto kind = c->SEND() != nullptr      ? CostItem::Kind::send
                      : c->RECEIVE() != nullptr ? CostItem::Kind::receive
                      : c->SET() != nullptr     ? CostItem::Kind::set
                      : c->READ() != nullptr    ? CostItem::Kind::read
                                                : CostItem::Kind::test;
    environment.costs.push_back({kind, interval(c->interval()), where});
    return;
  }
  if (auto* c = dynamic_cast<Parser::LatencyContext*>(context)) {
    const auto kind =
        c->WITHIN() != nullptr ? CostItem::Kind::latency_within : CostItem::Kind::latency_between;
    environment.costs.push_back({kind, interval(c->interval()), where});
  }
}

pan::EventDevice Builder::event_device(Parser::EventDeviceContext* context) {
  pan::EventDevice result;
  result.message = full_name(message(context->message()));
  bool has_period = false;
  bool has_jitter = false;
  for (auto* clause : context->eventClause()) {
    const auto once = [&](bool given) {
      if (given) diagnostics_.report(Finding::clause_given_twice, span(clause));
    };
    if (clause->EVERY() != nullptr || clause->SPORADIC() != nullptr) {
      once(has_period);
      has_period = true;
      result.sporadic = clause->SPORADIC() != nullptr;
      result.period = duration(clause->duration());
    } else if (clause->JITTER() != nullptr) {
      once(has_jitter);
      has_jitter = true;
      result.jitter = duration(clause->duration());
    } else if (clause->PHASE() != nullptr) {
      once(result.phase.has_value());
      result.phase = duration(clause->duration());
    } else if (clause->ANSWER() != nullptr) {
      once(result.answer_within.has_value());
      result.answer = full_name(message(clause->message()));
      result.answer_within = duration(clause->duration());
    }
  }
  if (!has_period && context->exception == nullptr) {
    diagnostics_.report(Finding::device_without_period, span(context));
  }
  return result;
}

pan::FrameDevice Builder::frame_device(Parser::FrameDeviceContext* context) {
  pan::FrameDevice result;
  bool has_period = false;
  bool has_collecting = false;
  for (auto* clause : context->frameClause()) {
    const auto once = [&](bool given) {
      if (given) diagnostics_.report(Finding::clause_given_twice, span(clause));
    };
    if (clause->EVERY() != nullptr) {
      once(has_period);
      has_period = true;
      result.period = duration(clause->duration());
    } else if (clause->COLLECTING() != nullptr) {
      once(has_collecting);
      has_collecting = true;
      result.collecting = duration(clause->duration());
    } else if (clause->PHASE() != nullptr) {
      once(result.phase.has_value());
      result.phase = duration(clause->duration());
    }
  }
  if ((!has_period || !has_collecting) && context->exception == nullptr) {
    diagnostics_.report(Finding::frames_without_times, span(context));
  }
  return result;
}

}  // namespace pal::syntax
