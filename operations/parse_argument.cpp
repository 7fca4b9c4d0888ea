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
    fields.report(Finding::argument_not_object, member.value.where);
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
      fields.report(Finding::argument_text_too_long, usual->where, pan::longest_text);
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
      fields.report(either<Finding::default_not_whole, Finding::default_not_in_range>(fits), usual->where,
                    member.name);
  } else {
    fields.report(Finding::default_of_no_type, usual->where);
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
    fields.report(Finding::too_many_fields, arguments->where, owner, most, field);
  for (const JsonMember& member : arguments->members) {
    auto argument = read_argument(member, diagnostics);
    if (!names.insert(member.name).second) {
      fields.report(Finding::field_given_twice, member.where, member.name);
    } else if (argument) {
      result.push_back(std::move(*argument));
    }
  }
  return result;
}

}  // namespace pal::operations
