// The tree of statements.
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/syntax/build.hpp"
#include "pal/syntax/token_list.hpp"

namespace pal::syntax {

Statements Builder::statements(Parser::StatementsContext* context) {
  Statements result;
  if (context == nullptr) return result;
  for (auto* child : context->statement()) {
    if (auto built = statement(child)) result.push_back(std::move(*built));
  }
  return result;
}

Set Builder::set(Parser::SetContext* context) {
  Set made{name(context->name()), std::nullopt};
  if (context->truth() != nullptr) made.value = context->truth()->TRUE() != nullptr;
  return made;
}

std::optional<Statement> Builder::statement(Parser::StatementContext* context) {
  const auto where = span(context);
  if (auto* c = context->wait()) return wait(c);
  if (auto* c = context->send()) return send(c);
  if (auto* c = context->choose()) return choose(c);
  if (auto* c = context->repeat()) return repeat(c);
  if (auto* c = context->concurrent()) return concurrent(c);
  if (auto* c = context->set()) return Statement{set(c), where, {}};
  if (auto* c = context->read()) return Statement{Read{name(c->name())}, where, {}};
  if (auto* c = context->execute()) {
    const auto called = name(c->name());
    const auto first = c->kind() != nullptr ? span(c->kind()) : called.where;
    return Statement{Execute{PartyName{kind(c->kind()), called, span(first, called.where)}}, where, {}};
  }
  if (context->nothing() != nullptr) return Statement{Nothing{}, where, {}};
  if (auto* c = context->perform()) return Statement{Perform{name(c->activityName())}, where, {}};
  return std::nullopt;
}

Source Builder::source(Parser::SourceContext* context) {
  if (context == nullptr) return {};
  return {message(context->message()), party(context->party())};
}

void Builder::report_no_else(SourceSpan wait, antlr4::tree::TerminalNode* end) {
  auto& finding = diagnostics_.report(Finding::wait_without_else, wait);
  if (is_made_up(end->getSymbol())) return;  // where it ends is yet to be written
  auto before = span(end);
  before.end = before.begin;
  const std::string indent(end->getSymbol()->getCharPositionInLine(), ' ');
  finding.fix = {{before, "ELSE\n" + indent + "  Do Nothing\n" + indent}};
}

std::optional<Statement> Builder::wait(Parser::WaitContext* context) {
  const auto where = span(context);
  if (dynamic_cast<Parser::WaitForStartContext*>(context) != nullptr) {
    return Statement{WaitForStart{}, where, {}};
  }
  if (auto* c = dynamic_cast<Parser::WaitForOneContext*>(context)) {
    return Statement{Wait{source(c->source())}, where, {}};
  }
  if (auto* c = dynamic_cast<Parser::WaitWithinContext*>(context)) {
    WaitBranches wait;
    wait.arms.push_back({source(c->source()), statements(c->statements(0)), span(c->source())});
    wait.within = duration(c->duration());
    wait.otherwise = statements(c->statements(1));
    const auto head = span(span(c->WTM(0)), span(c->duration()));
    if (c->ELSE() == nullptr && c->exception == nullptr) report_no_else(head, c->END_WTM());
    return Statement{std::move(wait), head, span(c->END_WTM(), c->WTM(1))};
  }
  if (auto* c = dynamic_cast<Parser::WaitForFirstContext*>(context)) {
    WaitBranches wait;
    wait.first = true;
    for (auto* arm : c->waitArm()) {
      wait.arms.push_back({source(arm->source()), statements(arm->statements()), span(arm->source())});
    }
    const auto end = span(c->END_WTM(), c->WTM(1));
    auto head = span(c->WTM(0), c->FIRST());
    if (c->WITHIN() != nullptr) {
      wait.within = duration(c->duration());
      head = span(head, span(c->duration()));
    }
    wait.otherwise = statements(c->statements());
    if (c->WITHIN() != nullptr && c->ELSE() == nullptr && c->exception == nullptr) {
      report_no_else(head, c->END_WTM());
    }
    if (c->WITHIN() == nullptr && c->ELSE() != nullptr) {
      diagnostics_.report(Finding::else_never_reached, span(c->ELSE()));
    }
    return Statement{std::move(wait), head, end};
  }
  return std::nullopt;
}

std::optional<Statement> Builder::send(Parser::SendContext* context) {
  const auto where = span(context);
  if (auto* c = dynamic_cast<Parser::CompleteContext*>(context)) {
    return Statement{Complete{integer(c->NUMBER()).value_or(0), span(c->NUMBER())}, where, {}};
  }
  if (auto* c = dynamic_cast<Parser::SendToContext*>(context)) {
    return Statement{Send{message(c->message()), party(c->party())}, where, {}};
  }
  if (auto* c = dynamic_cast<Parser::AskContext*>(context)) {
    Send send{message(c->message()), party(c->party())};
    if (!send.message.request && !send.message.name.text.empty() && c->exception == nullptr) {
      send.message.request = true;  // as is rather meant than the other way round
      auto& finding = diagnostics_.report(Finding::only_request_from, span(c->FROM()), send.message.name.text,
                                          send.to.name.text);
      auto before = span(c->message());
      before.end = before.begin;
      finding.fix = {{before, "request "}};
    }
    return Statement{std::move(send), where, {}};
  }
  return std::nullopt;
}

Statement Builder::choose(Parser::ChooseContext* context) {
  Choose result;
  for (auto* arm : context->arm()) {
    result.arms.push_back(
        {guard(arm->guard()), statements(arm->statements()), span(arm->LEFT(), arm->RIGHT())});
  }
  return {std::move(result), span(context->CASE(0)), span(context->END_CASE(), context->CASE(1))};
}

Statement Builder::repeat(Parser::RepeatContext* context) {
  Repeat result;
  result.body = statements(context->statements());
  result.until_where = span(context->UNTIL(), context->RIGHT());
  if (context->ending() != nullptr && context->ending()->guard() != nullptr) {
    result.until = guard(context->ending()->guard());
  }
  const auto end = result.until_where;
  return {std::move(result), span(context->REPEAT()), end};
}

Statement Builder::concurrent(Parser::ConcurrentContext* context) {
  Concurrent result;
  for (auto* block : context->block()) {
    result.blocks.push_back({statements(block->statements()), span(block->BEGIN())});
  }
  return {std::move(result), span(context->CONCURRENT(0)),
          span(context->END_CONCURRENT(), context->CONCURRENT(1))};
}

Guard Builder::guard(Parser::GuardContext* context) {
  if (context == nullptr) return {};
  const auto parts = context->conjunction();
  if (parts.size() == 1) return conjunction(parts.front());
  Guard result{Guard::Kind::any_of, {}, true, {}};
  for (auto* part : parts) result.terms.push_back(conjunction(part));
  return result;
}

Guard Builder::conjunction(Parser::ConjunctionContext* context) {
  const auto parts = context->factor();
  if (parts.size() == 1) return factor(parts.front());
  Guard result{Guard::Kind::all_of, {}, true, {}};
  for (auto* part : parts) result.terms.push_back(factor(part));
  return result;
}

Guard Builder::factor(Parser::FactorContext* context) {
  Guard result;
  if (context->guard() != nullptr) {
    result = guard(context->guard());
  } else {
    result.condition = name(context->name());
    result.value = context->truth() == nullptr || context->truth()->TRUE() != nullptr;
  }
  if (context->NOT().size() % 2 == 1) {
    Guard negated{Guard::Kind::negation, {}, true, {}};
    negated.terms.push_back(std::move(result));
    return negated;
  }
  return result;
}

MessageName Builder::message(Parser::MessageContext* context) {
  if (context == nullptr) return {};
  return {context->REQUEST() != nullptr, name(context->name()), span(context)};
}

PartyName Builder::party(Parser::PartyContext* context) {
  if (context == nullptr) return {};
  return {kind(context->kind()), name(context->name()), span(context)};
}

}  // namespace pal::syntax
