#include "programs/pal/reports/sarif.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "pal/support/finding.hpp"
#include "programs/pal/reports/json_text.hpp"

namespace pal::program {
namespace {

using Json = nlohmann::ordered_json;

/// A path as a URI reference (3.4.3, RFC 3986): what may not stand in one as %XX.
std::string uri_of(const std::string& path) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain.find(c) != std::string_view::npos) {
      uri += c;
    } else {
      uri += '%';
      uri += digits[byte >> 4];
      uri += digits[byte & 15];
    }
  }
  return uri;
}

class Log {
 public:
  Log(const Session& session, const std::vector<Code>& rules)
      : session_(session), sources_(session.sources), rules_(rules) {}

  Json result(const Diagnostic& finding) const {
    Json result = head(finding.code, name(finding.severity), finding.message, finding.where);
    if (!finding.hint.empty()) result["message"]["text"] = finding.message + "\nhint: " + finding.hint;
    for (std::size_t i = 0; i < finding.notes.size(); ++i) {
      Json related = location(finding.notes[i].where.valid() ? finding.notes[i].where : finding.where);
      related["id"] = i;
      related["message"]["text"] = finding.notes[i].text;
      result["relatedLocations"].push_back(std::move(related));
    }
    if (!finding.fix.empty()) result["fixes"].push_back(fix(finding));
    return result;
  }

  Json artifacts() const {
    auto list = Json::array();
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      Json artifact;
      artifact["location"] = artifact_location(FileId(i));
      if (!is_unread(FileId(i), session_)) {
        artifact["length"] = sources_.text(FileId(i)).size();
        artifact["encoding"] = "UTF-8";
      }
      artifact["sourceLanguage"] = sources_.name(FileId(i)).ends_with(".json") ? "json" : "pal";
      list.push_back(std::move(artifact));
    }
    return list;
  }

 private:
  Json head(Code code, std::string_view level, const std::string& message, const SourceSpan& where) const {
    Json result;
    result["ruleId"] = name(code);
    result["ruleIndex"] = std::find(rules_.begin(), rules_.end(), code) - rules_.begin();
    result["level"] = level;
    result["message"]["text"] = message;
    result["locations"].push_back(location(where));
    return result;
  }

  Json artifact_location(FileId file) const {
    Json location;
    location["uri"] = uri_of(sources_.name(file));
    location["index"] = file.index();
    return location;
  }

  Json region(const SourceSpan& where) const {
    const auto begin = sources_.line_column(where.file, where.begin);
    const auto end = sources_.line_column(where.file, where.end);
    Json region;
    region["startLine"] = begin.line;
    region["startColumn"] = begin.column;
    region["endLine"] = end.line;
    region["endColumn"] = end.column;  // the column after the last (3.30.8)
    return region;
  }

  /// Code hosts refuse a result that has no place in a file.
  Json location(SourceSpan where) const {
    Json location = Json::object();
    if (!where.valid() && sources_.size() == 0) return location;
    if (!where.valid()) where = {FileId(0), 0, 0};
    location["physicalLocation"]["artifactLocation"] = artifact_location(where.file);
    location["physicalLocation"]["region"] = region(where);
    return location;
  }

  Json fix(const Diagnostic& finding) const {
    std::map<std::size_t, Json> replacements;
    for (const Edit& edit : finding.fix) {
      Json replacement;
      replacement["deletedRegion"] = region(edit.where);
      if (!edit.text.empty()) replacement["insertedContent"]["text"] = edit.text;
      replacements[edit.where.file.index()].push_back(std::move(replacement));
    }
    Json fix;
    fix["description"]["text"] = finding.hint;
    for (auto& [file, list] : replacements) {
      Json change;
      change["artifactLocation"] = artifact_location(FileId(file));
      change["replacements"] = std::move(list);
      fix["artifactChanges"].push_back(std::move(change));
    }
    return fix;
  }

  const Session& session_;
  const SourceManager& sources_;
  const std::vector<Code>& rules_;
};

std::string_view meaning(ExitStatus status, bool any_verdict, bool all_checked) {
  switch (status) {
    case ExitStatus::all_hold:
      return !any_verdict  ? "no requirement was checked, as was asked for"
             : all_checked ? "every requirement holds"
                           : "every requirement that was checked holds; some were not checked";
    case ExitStatus::wrong_specification:
      return "the specification is wrong";
    case ExitStatus::usage:
      return "a file could not be read";
    case ExitStatus::not_met:
      return any_verdict ? "some requirement fails, is undecided or was not checked"
                         : "no requirement was checked";
  }
  return "";
}

Json notification(const char* level, std::string text) {
  Json notification;
  notification["level"] = level;
  notification["message"]["text"] = std::move(text);
  return notification;
}

Json invocation(ExitStatus status, std::string_view meaning) {
  Json invocation;
  // It did what it was asked to unless it could not read a file (3.20.14).
  invocation["executionSuccessful"] = status != ExitStatus::usage;
  invocation["exitCode"] = static_cast<int>(status);
  invocation["exitCodeDescription"] = meaning;
  return invocation;
}

}  // namespace

std::string sarif(const Session& session, const std::vector<Unchecked>& not_checked, bool required,
                  bool any_verdict, ExitStatus status, const std::string& remark) {
  const auto findings = session.diagnostics.sorted();
  std::vector<Code> rules;  // those that occur
  for (const Diagnostic& finding : findings) {
    if (std::find(rules.begin(), rules.end(), finding.code) == rules.end()) rules.push_back(finding.code);
  }
  const Log log(session, rules);
  Json run;
  Json& driver = run["tool"]["driver"];
  driver["name"] = "pal";
  driver["version"] = PAL_VERSION;
  driver["rules"] = Json::parse(sarif_rules(rules));
  run["invocations"].push_back(invocation(status, meaning(status, any_verdict, not_checked.empty())));
  Json& invoked = run["invocations"].back();
  if (const auto not_kept = session.diagnostics.not_kept().sum(); not_kept != 0)
    invoked["toolExecutionNotifications"].push_back(
        notification("warning", std::to_string(not_kept) + " further findings are not in this log"));
  if (!remark.empty()) invoked["toolExecutionNotifications"].push_back(notification("note", remark));
  for (const Unchecked& row : not_checked)
    invoked["toolExecutionNotifications"].push_back(notification(row.left_out ? "note"
                                                                 : required   ? "error"
                                                                              : "warning",
                                                                 text_of(finding_of(row))));
  run["columnKind"] = "unicodeCodePoints";
  run["artifacts"] = log.artifacts();
  run["results"] = Json::array();
  for (const Diagnostic& finding : findings) run["results"].push_back(log.result(finding));
  Json document;
  document["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  document["version"] = "2.1.0";
  document["runs"].push_back(std::move(run));
  return json_text(document, 2) + "\n";
}

}  // namespace pal::program
