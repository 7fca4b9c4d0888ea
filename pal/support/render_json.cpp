// Findings as JSON.
#include <nlohmann/json.hpp>

#include "pal/support/finding.hpp"
#include "pal/support/render.hpp"

namespace pal {

namespace {

using Json = nlohmann::ordered_json;

void add_place(Json& object, const SourceSpan& where, const SourceManager& sources) {
  const bool known = where.valid();
  const auto at = known ? sources.line_column(where.file, where.begin) : LineColumn{};
  object["file"] = known ? sources.name(where.file) : std::string();
  object["line"] = at.line;
  object["column"] = at.column;
}

void add_end(Json& object, const SourceSpan& where, const SourceManager& sources) {
  const auto end = where.valid() ? sources.line_column(where.file, where.end) : LineColumn{};
  object["end_line"] = end.line;
  object["end_column"] = end.column;
}

Json to_json(const Edit& edit, const SourceManager& sources) {
  Json object;
  add_place(object, edit.where, sources);
  add_end(object, edit.where, sources);
  object["text"] = edit.text;
  return object;
}

Json to_json(const Note& note, const SourceManager& sources) {
  Json object;
  add_place(object, note.where, sources);
  add_end(object, note.where, sources);
  object["message"] = note.text;
  return object;
}

Json to_json(const Diagnostic& finding, const SourceManager& sources) {
  Json object;
  object["code"] = name(finding.code);
  object["severity"] = name(finding.severity);
  add_place(object, finding.where, sources);
  add_end(object, finding.where, sources);
  object["message"] = finding.message;
  object["hint"] = finding.hint;
  object["hint_for"] = name(row(finding.finding).hint_for);
  object["finding"] = row(finding.finding).name;
  object["arguments"] = Json::object();
  for (const auto& [argument, text] : named_arguments(finding))
    object["arguments"][std::string(argument)] = text;
  object["notes"] = Json::array();
  for (const auto& note : finding.notes) object["notes"].push_back(to_json(note, sources));
  object["fix"] = Json::array();
  for (const auto& edit : finding.fix) object["fix"].push_back(to_json(edit, sources));
  return object;
}

}  // namespace

std::string render_json(const std::vector<Diagnostic>& findings, const SourceManager& sources) {
  auto list = Json::array();
  for (const auto& finding : findings) list.push_back(to_json(finding, sources));
  // A file name may hold any bytes; what is no UTF-8 in it is replaced rather than thrown at.
  return list.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace pal
