// Requirements of a skill.
#include <chrono>
#include <utility>
#include <variant>

#include "pal/support/duration_text.hpp"
#include "pal/support/finding.hpp"
#include "pal/syntax/build.hpp"
#include "pal/syntax/token_list.hpp"

namespace pal::syntax {
namespace {

/// A share of a row, rounded down. The share is a part of a second.
int part_of(int row, Duration share) {
  return static_cast<int>(row * share.count() / Duration(std::chrono::seconds(1)).count());
}

}  // namespace

std::optional<Requirement> Builder::requirement(Parser::RequirementSlotContext* context) {
  Requirement written;
  written.name = name(context->name());
  written.where = span(context);
  auto built = measured(std::move(written), context->measure());
  if (!built || context->phase() == nullptr) return built;
  built->phase = phase(context->phase());
  if (!built->phase) return std::nullopt;
  return built;
}

std::optional<Phase> Builder::phase(Parser::PhaseContext* context) {
  Phase made;
  made.where = span(context);
  Parser::StepContext* named = nullptr;
  if (auto* c = dynamic_cast<Parser::AfterPhaseContext*>(context)) named = c->step();
  if (auto* c = dynamic_cast<Parser::DuringPhaseContext*>(context)) {
    made.kind = Phase::Kind::during;
    named = c->step();
  }
  auto built = step(named);
  if (!built) return std::nullopt;
  made.step = std::move(*built);
  return made;
}

/// The requirement with its measure and limit.
std::optional<Requirement> Builder::measured(Requirement result, Parser::MeasureContext* measure) {
  if (auto* c = dynamic_cast<Parser::ResponseContext*>(measure)) {
    auto to = step(c->step());
    if (!to) return std::nullopt;
    result.measure = Requirement::Response{message(c->message()), party(c->party()), std::move(*to)};
    result.limit = duration(c->duration());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::AgeContext*>(measure)) {
    auto at = step(c->step());
    if (!at || c->known() == nullptr) return std::nullopt;
    result.measure = Requirement::Age{known(c->known()), std::move(*at)};
    result.limit = duration(c->duration());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::ReactionContext*>(measure)) {
    auto at = step(c->step());
    if (!at || c->known() == nullptr) return std::nullopt;
    result.measure = Requirement::Reaction{known(c->known()), std::move(*at)};
    result.limit = duration(c->duration());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::GreatestIntervalContext*>(measure)) {
    return passes(std::move(result), c->step(), nullptr, c->duration());
  }
  if (auto* c = dynamic_cast<Parser::LeastIntervalContext*>(measure)) {
    return passes(std::move(result), c->step(), c->duration(), nullptr);
  }
  if (auto* c = dynamic_cast<Parser::BoundedIntervalContext*>(measure)) {
    return passes(std::move(result), c->step(), c->duration(0), c->duration(1));
  }
  if (auto* c = dynamic_cast<Parser::LossContext*>(measure)) {
    result.measure = loss(c);
    return result;
  }
  if (auto* c = dynamic_cast<Parser::CompletionTimeContext*>(measure)) {
    const auto code = integer(c->NUMBER());
    if (!code) return std::nullopt;
    result.measure = Requirement::Completing{*code, span(c->NUMBER())};
    result.limit = duration(c->duration());
    return result;
  }
  if (auto* c = dynamic_cast<Parser::LoadContext*>(measure)) {
    Requirement::Load load;
    if (c->name() != nullptr) load.processor = name(c->name());
    result.measure = std::move(load);
    result.limit = share(c->NUMBER(), c->PERCENT(), "a load", "of the processor's time, such as 80 %");
    return result;
  }
  if (auto* c = dynamic_cast<Parser::BusyPeriodContext*>(measure)) {
    Requirement::BusyPeriod busy;
    if (c->name() != nullptr) busy.processor = name(c->name());
    result.measure = std::move(busy);
    result.limit = duration(c->duration());
    return result;
  }
  return std::nullopt;
}

/// As a part of a second. `subject` is what has it, `example` what to write.
Duration Builder::share(antlr4::tree::TerminalNode* number, antlr4::tree::TerminalNode* percent,
                        const std::string& subject, const std::string& example) {
  if (number == nullptr || is_made_up(number->getSymbol())) return Duration{};
  const auto at = span(number, percent);
  const auto parsed = parse_percentage(number->getText());
  const auto* value = std::get_if<Duration>(&parsed);
  if (value == nullptr && std::get<DurationError>(parsed) == DurationError::not_whole) {
    diagnostics_.report(Finding::share_too_fine, at, subject);
    return Duration{};
  }
  if (value == nullptr || *value < Duration{} || *value > std::chrono::seconds(1)) {
    diagnostics_.report(Finding::share_out_of_range, at, subject, example);
    return Duration{};
  }
  return *value;
}

Known Builder::known(Parser::KnownContext* context) {
  if (context->party() == nullptr) return {name(context->name())};
  return {Known::Sample{message(context->message()), party(context->party())}};
}

std::optional<Requirement> Builder::passes(Requirement result, Parser::StepContext* at,
                                           Parser::DurationContext* least, Parser::DurationContext* most) {
  auto built = step(at);
  if (!built) return std::nullopt;
  Requirement::Passes passes{std::move(*built), {}, {}};
  const std::size_t wrong = diagnostics_.errors();
  if (least != nullptr) passes.least = duration(least);
  if (most != nullptr) passes.most = duration(most);
  if (diagnostics_.errors() == wrong && passes.least && passes.most && *passes.least > *passes.most) {
    diagnostics_.report(Finding::least_longer_than_greatest, span(span(least), span(most)));
  }
  result.measure = std::move(passes);
  return result;
}

Requirement::Loss Builder::loss(Parser::LossContext* context) {
  Requirement::Loss loss{party(context->party()), 0, 1};
  if (context->NONE() != nullptr) return loss;
  std::optional<int> most;
  if (context->PERCENT() != nullptr) {
    loss.share =
        share(context->NUMBER(0), context->PERCENT(), "a share of losses", "of the row, such as 10 %");
  } else {
    most = integer(context->NUMBER(0));
  }
  const auto in = integer(context->NUMBER(1));
  if ((!most && !loss.share) || !in) return loss;
  if (loss.share) most = part_of(*in, *loss.share);
  if (*in < 1 || *most < 0 || *most >= *in) {
    diagnostics_.report(Finding::loss_of_all_in_row, span(context->NUMBER(0), context->NUMBER(1)));
    return loss;
  }
  loss.most = *most;
  loss.in = *in;
  return loss;
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
    const Set written = set(c->set());
    result.kind = Step::Kind::set;
    result.name = written.condition;
    result.value = written.value;
    return result;
  }
  if (auto* c = dynamic_cast<Parser::ReadPatternContext*>(pattern)) {
    result.kind = Step::Kind::read;
    result.name = name(c->read()->name());
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
