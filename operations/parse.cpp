#include "operations/parse.hpp"

#include <algorithm>
#include <utility>

#include "operations/fields.hpp"
#include "operations/json_value.hpp"
#include "operations/parse_argument.hpp"
#include "operations/parse_icon.hpp"

namespace pal::operations {
namespace {

using Kind = JsonValue::Kind;

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
  if (result.operation.empty()) fields.report(Finding::on_stop_names_operation, value->where);
  return result;
}

Operation read_operation(const JsonValue& value, Fields& fields, std::vector<Extent>& extents,
                         Diagnostics& diagnostics) {
  Operation operation;
  operation.where = value.where;
  operation.name = fields.needed_text("name", &operation.where);
  operation.description = fields.text("description");
  constexpr std::size_t most_arguments = 64;
  operation.arguments = read_arguments("arguments", most_arguments, "an operation", fields, diagnostics);
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
    fields.report(Finding::operation_not_object, root->where);
    return std::nullopt;
  }
  if (const JsonValue* format = fields.find("operation-format"); format == nullptr) {
    fields.missing("operation-format");
  } else if (format->kind != Kind::number || format->number != 1) {
    fields.report(Finding::unknown_operation_format, format->where);
  }
  Document document;
  document.operations.push_back(read_operation(*root, fields, document.extents, diagnostics));
  if (const JsonValue* others = fields.find("operations", Kind::array, "a list of sub-operations")) {
    for (const JsonValue& each : others->items) {
      Fields sub_fields(each, diagnostics);
      if (each.kind != Kind::object) {
        sub_fields.report(Finding::sub_operation_not_object, each.where);
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
