#include "operations/parse_argument.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace pal::operations {
namespace {

using Kind = JsonValue::Kind;

/// An argument by its default: a number with its range, a text, true or false.
std::optional<pan::Parameter> read_argument(const JsonMember& member, Diagnostics& diagnostics) {
  Fields fields(member.value, diagnostics);
  if (member.value.kind != Kind::object) {
    fields.report(member.value.where, "an argument is an object",
                  "write {\"default\": 5, \"from\": 1, \"to\": 40, \"unit\": \"N\"}");
    return std::nullopt;
  }
  pan::Parameter argument;
  argument.name = member.name;
  argument.where = member.where;
  argument.description = fields.text("note");
  const JsonValue* usual = fields.find("default");
  if (usual == nullptr) {
    fields.missing("default");
  } else if (usual->kind == Kind::boolean) {
    argument.type = pan::ScalarType::boolean;
    argument.high = 1;
    argument.default_value = usual->truth ? 1 : 0;
  } else if (usual->kind == Kind::text) {
    argument.type = pan::ScalarType::text;
    argument.default_text = usual->text;
    if (usual->text.size() > pan::longest_text)
      fields.report(usual->where, fmt::format("a text has at most {} signs", pan::longest_text),
                    "write a shorter one");
  } else if (usual->kind == Kind::number) {
    const JsonValue* whole = fields.find("whole", Kind::boolean, "true or false");
    argument.type = whole != nullptr && whole->truth ? pan::ScalarType::integer : pan::ScalarType::real;
    argument.unit = fields.text("unit");
    const auto low = read_number("from", any_number, fields, diagnostics);
    const auto high = read_number("to", any_number, fields, diagnostics);
    if (!low) fields.missing("from");
    if (!high) fields.missing("to");
    argument.low = low.value_or(usual->number);
    argument.high = high.value_or(usual->number);
    argument.default_value = usual->number;
    const bool fits = usual->number >= argument.low && usual->number <= argument.high;
    if (!fits || (argument.type == pan::ScalarType::integer && std::floor(usual->number) != usual->number))
      fields.report(
          usual->where,
          fmt::format("the default of '{}' is not {}", member.name, fits ? "a whole number" : "in its range"),
          "correct the default, or 'from', 'to' and 'whole'");
  } else {
    fields.report(usual->where, "a default is a number, a text, true or false", "write one of these");
  }
  fields.refuse_the_rest();
  return argument;
}

}  // namespace

std::vector<pan::Parameter> read_arguments(const std::string& field, std::size_t most, const char* owner,
                                           Fields& fields, Diagnostics& diagnostics) {
  std::vector<pan::Parameter> result;
  const JsonValue* arguments = fields.find(field, Kind::object, "an object with an argument a name");
  if (arguments == nullptr) return result;
  std::set<std::string> names;
  if (arguments->members.size() > most)
    fields.report(arguments->where, fmt::format("{} has at most {} {}", owner, most, field),
                  "make several of it");
  for (const JsonMember& member : arguments->members) {
    auto argument = read_argument(member, diagnostics);
    if (!names.insert(member.name).second) {
      fields.report(member.where, fmt::format("'{}' is given twice", member.name), "keep one of the two");
    } else if (argument) {
      result.push_back(std::move(*argument));
    }
  }
  return result;
}

}  // namespace pal::operations
