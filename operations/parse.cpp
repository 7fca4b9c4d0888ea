#include "operations/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "operations/fields.hpp"
#include "operations/json_value.hpp"
#include "operations/parse_icon.hpp"

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

void read_arguments(Operation& operation, Fields& fields, Diagnostics& diagnostics) {
  const JsonValue* arguments = fields.find("arguments", Kind::object, "an object with an argument a name");
  if (arguments == nullptr) return;
  std::set<std::string> names;
  constexpr std::size_t most = 64;
  if (arguments->members.size() > most)
    fields.report(arguments->where, fmt::format("an operation has at most {} arguments", most),
                  "make several operations of it");
  for (const JsonMember& member : arguments->members) {
    auto argument = read_argument(member, diagnostics);
    if (!names.insert(member.name).second) {
      fields.report(member.where, fmt::format("'{}' is given twice", member.name), "keep one of the two");
    } else if (argument) {
      operation.arguments.push_back(std::move(*argument));
    }
  }
}

/// A name of an operation of the same file, or {"file": …, "operation": …}.
OnStop read_on_stop(Fields& fields, Diagnostics& diagnostics) {
  OnStop result;
  const JsonValue* value = fields.find("on-stop");
  if (value == nullptr) return result;
  result.where = value->where;
  if (value->kind == Kind::text) {
    result.operation = value->text;
  } else if (value->kind == Kind::object) {
    Fields inside(*value, diagnostics);
    result.file = inside.needed_text("file", &result.where);
    result.operation = inside.text("operation", &result.where);
    inside.refuse_the_rest();
    return result;
  }
  if (result.operation.empty())
    fields.report(value->where, "'on-stop' names an operation",
                  "write the name of an operation of this file, or {\"file\": …}");
  return result;
}

Operation read_operation(const JsonValue& value, Fields& fields, std::vector<Extent>& extents,
                         Diagnostics& diagnostics) {
  Operation operation;
  operation.where = value.where;
  operation.name = fields.needed_text("name", &operation.where);
  operation.description = fields.text("description");
  read_arguments(operation, fields, diagnostics);
  operation.on_stop = read_on_stop(fields, diagnostics);
  const JsonValue* icons = fields.find("icons", Kind::array, "a list of icons");
  if (icons == nullptr) fields.missing("icons");
  if (icons == nullptr) return operation;
  for (const JsonValue& each : icons->items) {
    std::string id;
    if (auto icon = read_icon(each, id, diagnostics)) operation.icons.push_back(std::move(*icon));
    if (each.kind == Kind::object)
      extents.push_back({{each.where.file, each.where.begin, each.end}, operation.name, std::move(id)});
  }
  return operation;
}

}  // namespace

std::optional<Document> parse(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto root = parse_json(sources, file, diagnostics);
  if (!root) return std::nullopt;
  Fields fields(*root, diagnostics);
  if (root->kind != Kind::object) {
    fields.report(root->where, "an operation is an object", "write {\"operation-format\": 1, …}");
    return std::nullopt;
  }
  if (const JsonValue* format = fields.find("operation-format"); format == nullptr) {
    fields.missing("operation-format");
  } else if (format->kind != Kind::number || format->number != 1) {
    fields.report(format->where, "this program reads operation-format 1 only", "write 1");
  }
  Document document;
  document.operations.push_back(read_operation(*root, fields, document.extents, diagnostics));
  if (const JsonValue* others = fields.find("operations", Kind::array, "a list of sub-operations")) {
    for (const JsonValue& each : others->items) {
      Fields sub_fields(each, diagnostics);
      if (each.kind != Kind::object) {
        sub_fields.report(each.where, "a sub-operation is an object", "write {\"name\": …, \"icons\": […]}");
        continue;
      }
      document.operations.push_back(read_operation(each, sub_fields, document.extents, diagnostics));
      sub_fields.refuse_the_rest();
    }
  }
  fields.refuse_the_rest();
  for (Operation& operation : document.operations) operation.from = sources.name(file);
  std::sort(document.extents.begin(), document.extents.end(),
            [](const Extent& a, const Extent& b) { return a.where.begin < b.where.begin; });
  return document;
}

}  // namespace pal::operations
