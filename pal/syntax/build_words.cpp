// Names, numbers, times and units.
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string_view>

#include "pal/support/duration_text.hpp"
#include "pal/support/finding.hpp"
#include "pal/syntax/build.hpp"
#include "pal/syntax/physical_unit.hpp"
#include "pal/syntax/token_list.hpp"

namespace pal::syntax {

SourceSpan Builder::span(antlr4::ParserRuleContext* context) const {
  if (context == nullptr || context->start == nullptr) return {};
  const auto* last = context->stop != nullptr ? context->stop : context->start;
  return tokens_.span(context->start, last);
}

SourceSpan Builder::span(antlr4::tree::TerminalNode* node) const {
  return span(node, node);
}

SourceSpan Builder::span(antlr4::tree::TerminalNode* first, antlr4::tree::TerminalNode* last) const {
  if (first == nullptr) return {};
  return tokens_.span(first->getSymbol(), last == nullptr ? first->getSymbol() : last->getSymbol());
}

SourceSpan Builder::span(SourceSpan first, SourceSpan last) const {
  if (!first.valid() || !last.valid()) return first;
  return {first.file, first.begin, std::max(first.end, last.end)};
}

Name Builder::name(antlr4::ParserRuleContext* context) const {
  if (context == nullptr || context->start == nullptr || context->exception != nullptr)
    return {{}, span(context)};
  // A token that the parser made up stands for no text.
  if (is_made_up(context->start)) return {{}, span(context)};
  return {context->start->getText(), span(context)};
}

std::vector<Name> Builder::names(const std::vector<Parser::NameContext*>& contexts) const {
  std::vector<Name> result;
  result.reserve(contexts.size());
  for (auto* context : contexts) result.push_back(name(context));
  return result;
}

std::vector<Name> Builder::names(Parser::NamesContext* context) const {
  return context == nullptr ? std::vector<Name>{} : names(context->name());
}

namespace {

/// Whether a text ends with a quote of its own: one that no backslash escapes.
bool is_closed(const std::string& quoted) {
  std::size_t i = 1;
  while (i < quoted.size() && quoted[i] != '"') i += quoted[i] == '\\' ? 2 : 1;
  return i < quoted.size();
}

}  // namespace

std::string Builder::text(antlr4::tree::TerminalNode* string) {
  if (string == nullptr || is_made_up(string->getSymbol())) return {};
  const auto quoted = string->getText();
  const std::size_t end = quoted.size() - (is_closed(quoted) ? 1 : 0);
  std::string result;
  for (std::size_t i = 1; i < end; ++i) {
    if (quoted[i] == '\\' && i + 1 < end) {
      ++i;
      if (quoted[i] != '"' && quoted[i] != '\\') {
        auto& finding = diagnostics_.report(Finding::unknown_escape, span(string));
        const auto at = span(string).begin + static_cast<std::uint32_t>(i) - 1;
        finding.fix = {{{tokens_.file(), at, at}, "\\"}};
      }
    }
    result += quoted[i];
  }
  return result;
}

std::vector<std::string> Builder::texts(Parser::StringsContext* context) {
  std::vector<std::string> result;
  if (context == nullptr) return result;
  for (auto* string : context->STRING()) result.push_back(text(string));
  return result;
}

std::optional<int> Builder::integer(antlr4::tree::TerminalNode* number) {
  if (number == nullptr || is_made_up(number->getSymbol())) return std::nullopt;
  const auto digits = number->getText();
  int value = 0;
  const auto end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc{} || stop != end) {
    diagnostics_.report(Finding::no_whole_number_of_32_bits, span(number));
    return std::nullopt;
  }
  return value;
}

std::optional<double> Builder::real(antlr4::tree::TerminalNode* number) {
  if (number == nullptr || is_made_up(number->getSymbol())) return std::nullopt;
  const auto digits = number->getText();
  double value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{}) {
    diagnostics_.report(Finding::number_too_large, span(number));
    return 0;
  }
  return value;
}

std::optional<Literal> Builder::literal(Parser::LiteralContext* context) {
  if (context == nullptr) return std::nullopt;
  if (auto* truth = context->truth()) {
    return Literal{{}, truth->TRUE() != nullptr ? 1.0 : 0.0, {}, span(context)};
  }
  if (auto* string = context->STRING()) return Literal{{}, 0, {}, span(context), text(string)};
  const auto value = real(context->NUMBER());
  if (!value) return std::nullopt;
  return Literal{context->NUMBER()->getText(), *value, unit(context->physicalUnit()), span(context)};
}

Duration Builder::duration(Parser::DurationContext* context) {
  return context == nullptr ? Duration{} : duration(context->NUMBER(), context->NAME());
}

Duration Builder::duration(antlr4::tree::TerminalNode* number, antlr4::tree::TerminalNode* unit) {
  if (number == nullptr || unit == nullptr) return Duration{};
  if (is_made_up(number->getSymbol()) || is_made_up(unit->getSymbol())) return Duration{};
  const auto parsed = parse_duration(number->getText(), unit->getText());
  if (const auto* value = std::get_if<Duration>(&parsed)) {
    if (*value < Duration{}) {
      diagnostics_.report(Finding::written_time_negative, span(number, unit));
      return Duration{};
    }
    return *value;
  }
  switch (std::get<DurationError>(parsed)) {
    case DurationError::no_unit:
      diagnostics_.report(Finding::unknown_unit_of_time, span(unit), unit->getText());
      break;
    case DurationError::not_whole:
      diagnostics_.report(Finding::no_whole_nanoseconds, span(number, unit));
      break;
    default:
      diagnostics_.report(Finding::written_time_too_long, span(number, unit));
  }
  return Duration{};
}

Interval Builder::interval(Parser::IntervalContext* context) {
  if (context == nullptr) return {};
  auto* best = context->NUMBER(0);
  auto* worst = context->NUMBER(1);
  auto* unit = context->NAME(0);
  if (best == nullptr || is_made_up(best->getSymbol())) return {};
  if (unit == nullptr) {
    diagnostics_.report(Finding::time_without_unit, span(best));
    return {};
  }
  if (worst == nullptr) {
    const auto value = duration(best, unit);
    return {value, value};
  }
  // 0.1 TO 0.2 ms: one unit stands for both.
  auto* last = context->NAME(1) != nullptr ? context->NAME(1) : unit;
  const std::size_t wrong = diagnostics_.errors();
  const Interval result{duration(best, unit), duration(worst, last)};
  if (diagnostics_.errors() == wrong && result.best > result.worst) {
    const auto turned = to_text(Interval{result.worst, result.best});
    diagnostics_.report(Finding::interval_runs_backwards, span(context)).fix = {{span(context), turned}};
  }
  return result;
}

std::string Builder::unit(Parser::PhysicalUnitContext* context) {
  if (context == nullptr || context->exception != nullptr) return {};
  auto written = context->getText();  // without the spaces between
  if (!is_physical_unit(written)) {
    diagnostics_.report(Finding::unknown_unit, span(context), written, physical_units());
  }
  return written;
}

/// Of an array. A size that means nothing is reported, and 1 stands for it, so that nothing else is.
int Builder::size(Parser::SizeContext* context) {
  if (context == nullptr || context->exception != nullptr) return 0;
  auto* number = context->NUMBER();
  if (number == nullptr || is_made_up(number->getSymbol())) return 1;
  const auto digits = number->getText();
  const std::string limit = std::to_string(pan::largest_array);
  int value = 0;
  const auto* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (stop != end) {
    diagnostics_.report(Finding::size_not_whole, span(number), limit);
  } else if (digits.starts_with('-') || (error == std::errc{} && value == 0)) {
    diagnostics_.report(Finding::array_of_nothing, span(number), limit);
  } else if (error != std::errc{} || value > pan::largest_array) {
    diagnostics_.report(Finding::array_too_large, span(number), limit);
  } else {
    return value;
  }
  return 1;
}

Builder::TypeOf Builder::type(Parser::TypeContext* context) {
  if (context == nullptr) return {};
  const bool boolean = context->BOOLEAN() != nullptr;
  const bool text = context->TEXT() != nullptr;
  if ((boolean || text) && context->physicalUnit() != nullptr) {
    diagnostics_.report(either<Finding::boolean_has_no_unit, Finding::text_has_no_unit>(boolean),
                        span(context));
  }
  if (text && context->size() != nullptr) {
    diagnostics_.report(Finding::no_arrays_of_text, span(context));
    return {pan::ScalarType::text, {}, 0};
  }
  return {context->INTEGER() != nullptr ? pan::ScalarType::integer
          : boolean                     ? pan::ScalarType::boolean
          : text                        ? pan::ScalarType::text
                                        : pan::ScalarType::real,
          unit(context->physicalUnit()), size(context->size())};
}

std::optional<pan::ModuleKind> Builder::kind(Parser::KindContext* context) const {
  if (context == nullptr) return std::nullopt;
  if (context->DRIVER() != nullptr) return pan::ModuleKind::sensor_driver;
  if (context->LOGICAL() != nullptr) return pan::ModuleKind::logical_sensor;
  if (context->MACHINE() != nullptr) return pan::ModuleKind::machine_controller;
  if (context->SKILL() != nullptr) return pan::ModuleKind::skill_module;
  if (context->CONTINGENCY() != nullptr) return pan::ModuleKind::contingency_module;
  return std::nullopt;
}

std::optional<pan::ModuleKind> Builder::kind(Parser::HeaderContext* context) const {
  if (context == nullptr || context->HEADER() == nullptr) return std::nullopt;
  if (context->DRIVER() != nullptr) return pan::ModuleKind::sensor_driver;
  if (context->SENSOR() != nullptr) return pan::ModuleKind::logical_sensor;
  if (context->CONTROLLER() != nullptr) return pan::ModuleKind::machine_controller;
  // Skill Module or Contingency Module.
  const bool skill =
      context->HEADER()->getText().starts_with('s') || context->HEADER()->getText().starts_with('S');
  return skill ? pan::ModuleKind::skill_module : pan::ModuleKind::contingency_module;
}

}  // namespace pal::syntax
