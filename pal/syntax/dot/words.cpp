#include "pal/syntax/dot/words.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <utility>

#include "PalLexer.h"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"
#include "pal/syntax/parse.hpp"

namespace pal::syntax {

namespace {

using Lexer = grammar::PalLexer;

/// Longer texts are not names.
constexpr std::size_t longest_shown = 60;

std::string shown_word(const std::string& text) {
  return text.size() <= longest_shown ? "'" + text + "'" : "this text";
}

/// What kind of token the whole text is; EOF if it is not one alone.
std::size_t only_token(const std::string& text) {
  antlr4::ANTLRInputStream input(text);
  Lexer lexer(&input);
  lexer.removeErrorListeners();
  const auto first = lexer.nextToken();
  const bool whole = first->getStartIndex() == 0 && lexer.nextToken()->getType() == antlr4::Token::EOF &&
                     first->getStopIndex() + 1 == input.size();
  return whole ? first->getType() : antlr4::Token::EOF;
}

bool opens_unit(std::size_t type) {
  return type >= Lexer::USES && type <= Lexer::ENVIRONMENT;
}
bool means_something_in_places(std::size_t type) {
  return type >= Lexer::ACTIVITY && type <= Lexer::WRITES;
}

/// PAL's own parser reads what PAL's grammar describes, inside a module made for it.
std::optional<ModuleUnit> module_of(const std::string& text) {
  SourceManager sources;
  Diagnostics findings;
  const FileId file = sources.add("attribute", "Skill Module: M\n" + text);
  Tree tree = parse(sources, file, findings);
  if (!tree.complete || tree.units.size() != 1) return std::nullopt;
  auto* module = std::get_if<ModuleUnit>(&tree.units.front());
  if (module == nullptr) return std::nullopt;
  return std::move(*module);
}

/// Of ASCII; what belongs to a longer character of UTF-8 is taken as it is.
bool is_printable(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 && byte != 0x7F;
}

/// %3B is a semicolon; a % that no code of a printable character follows is one.
std::string decoded(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned value = 0;
    const char* digits = text.data() + i + 1;
    const bool whole = text[i] == '%' && i + 2 < text.size() &&
                       std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2 && value >= 0x20 &&
                       value < 0x7F;
    result += whole ? static_cast<char>(value) : text[i];
    if (whole) i += 2;
  }
  return result;
}

void place(Guard& guard, SourceSpan where) {
  guard.condition.where = where;
  for (Guard& term : guard.terms) place(term, where);
}

}  // namespace

std::vector<DotValue> dot_parts(const DotValue& value) {
  std::vector<DotValue> result;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = value.text.find(';', begin);
    result.push_back({value.text.substr(begin, end - begin), value.where});
    if (end == std::string::npos) return result;
    begin = end + 1;
  }
}

void DotWords::fail(const DotValue& at, const PartialDiagnostic& what) {
  diagnostics_.report(what, at.where);
  throw Reported{};
}

Name DotWords::name(const DotValue& from) {
  const auto type = only_token(from.text);
  if (type != Lexer::NAME && !opens_unit(type) && !means_something_in_places(type)) {
    fail(from, {Finding::not_a_name, shown_word(from.text)});
  }
  return {from.text, from.where};
}

Name DotWords::activity_name(const DotValue& from) {
  const auto type = only_token(from.text);
  if (opens_unit(type)) fail(from, {Finding::unit_names_no_activity, shown_word(from.text)});
  return name(from);
}

MessageName DotWords::message(const DotValue& from) {
  constexpr std::string_view request = "request ";
  const bool asks = from.text.starts_with(request);
  return {asks, name({asks ? from.text.substr(request.size()) : from.text, from.where}), from.where};
}

PartyName DotWords::party(const DotValue& from) {
  return {std::nullopt, name(from), from.where};
}

bool DotWords::truth(const DotValue& from) {
  if (from.text == "TRUE" || from.text == "true") return true;
  if (from.text == "FALSE" || from.text == "false") return false;
  fail(from, {Finding::no_truth, shown_word(from.text)});
}

std::int64_t DotWords::number(const DotValue& from, std::int64_t most) {
  std::int64_t result = 0;
  const char* end = from.text.data() + from.text.size();
  const auto read = std::from_chars(from.text.data(), end, result);
  if (read.ec != std::errc() || read.ptr != end || result < 0 || result > most) {
    fail(from, {Finding::no_number_that_fits, shown_word(from.text), most});
  }
  return result;
}

Guard DotWords::guard(const DotValue& from) {
  auto module = module_of("BEGIN\nREPEAT\nUNTIL( " + from.text + "\n)\nEND\n");
  if (module && module->body.size() == 1) {
    auto* repeat = std::get_if<Repeat>(&module->body.front().content);
    if (repeat != nullptr && repeat->until) {
      place(*repeat->until, from.where);
      return std::move(*repeat->until);
    }
  }
  fail(from, {Finding::no_condition, shown_word(from.text)});
}

ActivityHeading DotWords::activity(const DotValue& from) {
  auto module = module_of("ACTIVITY " + from.text + "\n");
  if (!module || module->activities.size() != 1 || !module->descriptions.empty() || module->has_body) {
    fail(from, {Finding::no_activity, shown_word(from.text)});
  }
  ActivityHeading heading = std::move(module->activities.front());
  heading.where = from.where;
  heading.name.where = from.where;
  for (auto* list : {&heading.reads, &heading.writes}) {
    for (Name& it : *list) it.where = from.where;
  }
  return heading;
}

std::vector<std::string> DotWords::texts(const DotValue& from) {
  std::vector<std::string> result;
  for (const DotValue& part : dot_parts(from)) {
    if (!std::all_of(part.text.begin(), part.text.end(), is_printable)) {
      fail(from, {Finding::control_character});
    }
    result.push_back(decoded(part.text));
  }
  return result;
}

NameSlot DotWords::slot(const DotValue& from) {
  NameSlot result;
  result.where = from.where;
  if (from.text == "NONE") return result;
  for (const DotValue& part : dot_parts(from)) result.names.push_back(name(part));
  return result;
}

pan::ModuleKind DotWords::module_kind(const DotValue& from) {
  for (const auto kind :
       {pan::ModuleKind::sensor_driver, pan::ModuleKind::logical_sensor, pan::ModuleKind::machine_controller,
        pan::ModuleKind::skill_module, pan::ModuleKind::contingency_module}) {
    if (pan::kind_text(kind) == from.text) return kind;
  }
  fail(from, {Finding::no_kind_of_module, shown_word(from.text)});
}

}  // namespace pal::syntax
