// Files of operations, .op.json: findings, completion and hover, by the templates of the workspace's skills.
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "language_server/operation_schema.hpp"
#include "language_server/operation_text.hpp"
#include "language_server/session.hpp"
#include "operations/check.hpp"
#include "operations/check_values.hpp"
#include "operations/load.hpp"
#include "pal/check/project.hpp"
#include "pal/doc/words.hpp"

namespace pal::language_server {

namespace {

std::string number_text(double number) {
  return operations::to_text(operations::Value(number));
}

std::string kind_text(pan::Completion::Kind kind) {
  return kind == pan::Completion::Kind::normal        ? "normal"
         : kind == pan::Completion::Kind::contingency ? "contingency"
                                                      : "error";
}

/// "a number from 1 to 40 N, by default 5 N".
std::string parameter_text(const pan::Parameter& parameter) {
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  const std::string usual = parameter.type == pan::ScalarType::text ? "\"" + parameter.default_text + "\""
                            : parameter.type == pan::ScalarType::boolean
                                ? (parameter.default_value != 0 ? "true" : "false")
                                : number_text(parameter.default_value) + unit;
  return operations::type_text(parameter) + ", by default " + usual;
}

std::string skill_text(const pan::Template& skill) {
  std::string text = "**" + skill.name + "**\n\n";
  for (const auto& each : skill.descriptions) text += each + "\n\n";
  for (const auto& each : skill.parameters)
    text += "- `" + each.name + "`: " + parameter_text(each) +
            (each.description.empty() ? "" : ". " + each.description) + "\n";
  text += "\n";
  for (const auto& each : skill.completions)
    text += "- code " + std::to_string(each.code) + ", " + kind_text(each.kind) +
            (each.description.empty() ? "" : ": " + each.description) + "\n";
  return text;
}

std::string member_text(const SchemaMember& member) {
  return "`" + member.name + "`" + (member.type.empty() ? "" : ": " + member.type) +
         (member.words.empty() ? "" : "\n\n" + member.words);
}

/// The frame of the icon that a place is in: the object of a list `icons`. Nothing: it is in none.
const JsonFrame* icon_of(const JsonPlace& place) {
  for (std::size_t i = place.frames.size(); i-- > 2;) {
    if (place.frames[i].object && !place.frames[i - 1].object && place.frames[i - 2].key == "icons")
      return &place.frames[i];
  }
  return nullptr;
}

std::set<std::string> words_behind(std::string_view text, const std::string& name) {
  std::set<std::string> found;
  const std::string mark = "\"" + name + "\"";
  for (auto at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    const auto open = text.find('"', at + mark.size());
    const auto end = open == std::string_view::npos ? open : text.find('"', open + 1);
    if (end != std::string_view::npos && text.find_first_not_of(" \t:", at + mark.size()) == open)
      found.emplace(text.substr(open + 1, end - open - 1));
  }
  return found;
}

}  // namespace

bool is_operation(const std::string& path) {
  return path.ends_with(".op.json");
}

const operations::Skills& Session::skills() {
  const auto& project = workspace_.project();
  if (!templates_.empty() && templates_of_ == workspace_.revision()) return templates_;
  templates_.clear();
  for (const auto& file : project) {
    if (!file.has_skill) continue;
    const auto found = known_.find(file.path);
    auto& kept = templates_by_file_[file.path];
    std::shared_ptr<const Analysis> analysis = found == known_.end() ? nullptr : found->second.analysis;
    if (analysis == nullptr) {
      if (kept.second.empty() || kept.first != workspace_.revision(file.path)) {
        kept = {workspace_.revision(file.path), {}};
        const auto alone = analyze(workspace_, {file.path}, {});
        for (const auto& skill : alone->specification.skills) kept.second.push_back(skill.skill);
      }
    } else {
      kept = {workspace_.revision(file.path), {}};
      for (const auto& skill : analysis->specification.skills) kept.second.push_back(skill.skill);
    }
    for (const auto& skill : kept.second) templates_.emplace(skill.name, skill);
  }
  templates_of_ = workspace_.revision();
  return templates_;
}

std::vector<Diagnostic> Session::operation_findings(const std::string& path, SourceManager& sources) {
  Diagnostics diagnostics;
  const auto program = operations::load(workspace_, sources, path, diagnostics);
  if (program && !diagnostics.has_errors()) operations::check_shape(*program, diagnostics);
  if (program && !diagnostics.has_errors() && !skills().empty()) {
    operations::Cell cell;
    cell.skills = skills();
    operations::check_cell(*program, cell, diagnostics);
  }
  const auto file = sources.find(path);
  auto found = diagnostics.sorted();
  std::erase_if(found, [&](const Diagnostic& finding) { return !file || finding.where.file != *file; });
  return found;
}

Json Session::operation_completion(const Place& place) {
  const auto& content = place.text->content();
  const auto at = json_place(content, place.offset);
  Json items = Json::array();
  if (at.frames.empty()) return items;
  const auto* icon = icon_of(at);
  const auto add = [&](const std::string& label, int kind, const std::string& detail,
                       const std::string& words, const std::string& inserted) {
    Json item{{"label", label},
              {"kind", kind},
              {"textEdit", text_edit(*place.text, at.begin, at.end, inserted)},
              {"filterText", inserted}};
    if (!detail.empty()) item["detail"] = detail;
    if (!words.empty()) item["documentation"] = {{"kind", "markdown"}, {"value", words}};
    items.push_back(std::move(item));
  };
  const auto quoted = [](const std::string& text) { return "\"" + text + "\""; };
  const auto& inner = at.frames.back();
  const std::string outer = at.frames.size() < 2 ? "" : at.frames[at.frames.size() - 2].key;
  const auto skill_name = icon == nullptr ? std::nullopt : json_member(content, icon->open, "skill");
  const auto skill = skill_name ? skills().find(*skill_name) : skills().end();
  if (inner.object && outer == "parameters" && skill != skills().end()) {
    for (const auto& each : skill->second.parameters) {
      if (at.names_member) {
        add(each.name, 10, parameter_text(each), each.description, quoted(each.name));
      } else if (each.name == inner.key) {
        const std::string usual = each.type == pan::ScalarType::text ? quoted(each.default_text)
                                  : each.type == pan::ScalarType::boolean
                                      ? (each.default_value != 0 ? "true" : "false")
                                      : number_text(each.default_value);
        add(usual, 12, parameter_text(each), each.description, usual);
        if (each.type == pan::ScalarType::boolean)
          add(usual == "true" ? "false" : "true", 12, "", "", usual == "true" ? "false" : "true");
      }
    }
  } else if (at.names_member) {
    for (const SchemaMember& each : members_at(content, at))
      add(each.name, 10, each.type, each.words, quoted(each.name));
  } else if (inner.object && inner.key == "skill") {
    for (const auto& [name, each] : skills())
      add(name, 7, each.descriptions.empty() ? "" : each.descriptions.front(), skill_text(each),
          quoted(name));
  } else if (inner.object && inner.key == "kind" && icon != nullptr) {
    for (const auto& name : operations::icon_kind_names()) add(name, 20, "kind of icon", "", quoted(name));
  } else if (inner.object &&
             (inner.key == "next" || inner.key == "error" || inner.key == "default" || inner.key == "to")) {
    for (const auto& name : words_behind(content, "id")) add(name, 18, "icon", "", quoted(name));
  } else if (inner.object && (inner.key == "operation" || inner.key == "on-stop")) {
    for (const auto& name : words_behind(content, "name")) add(name, 3, "operation", "", quoted(name));
  } else if (!inner.object && outer == "codes") {
    // The skills that lead here; the text has no findings yet that could say more.
    const auto here = icon == nullptr ? std::nullopt : json_member(content, icon->open, "id");
    std::set<int> told;
    for (auto next = content.find("\"skill\""); next != std::string::npos;
         next = content.find("\"skill\"", next + 1)) {
      const auto of = json_place(content, next);
      const auto* other = icon_of(of);
      if (other == nullptr || (here && json_member(content, other->open, "next") != here)) continue;
      const auto name = json_member(content, other->open, "skill");
      const auto found = name ? skills().find(*name) : skills().end();
      if (found == skills().end()) continue;
      for (const auto& each : found->second.completions) {
        if (told.insert(each.code).second)
          add(std::to_string(each.code), 12, kind_text(each.kind) + " of " + *name, each.description,
              std::to_string(each.code));
      }
    }
  }
  if (items.empty() && !at.names_member && inner.object)
    for (const SchemaMember& each : members_at(content, at))
      if (each.name == inner.key)
        for (const std::string& value : each.values) add(value, 12, each.type, each.words, value);
  return items;
}

Json Session::operation_hover(const Place& place) {
  const auto& content = place.text->content();
  const auto at = json_place(content, place.offset);
  const auto* icon = icon_of(at);
  if (at.frames.empty() || at.begin == at.end) return nullptr;
  std::string text;
  const auto name = icon == nullptr ? std::nullopt : json_member(content, icon->open, "skill");
  const auto skill = name ? skills().find(*name) : skills().end();
  const auto& inner = at.frames.back();
  const std::string outer = at.frames.size() < 2 ? "" : at.frames[at.frames.size() - 2].key;
  if (inner.object && inner.key == "skill" && skill != skills().end()) {
    text = skill_text(skill->second);
  } else if (inner.object && outer == "parameters" && skill != skills().end()) {
    const std::string& wanted = at.names_member ? at.word : inner.key;
    for (const auto& each : skill->second.parameters) {
      if (each.name == wanted)
        text = "`" + each.name + "` of " + skill->first + ": " + parameter_text(each) + "\n\n" +
               each.description;
    }
  } else if (!inner.object && outer == "codes" && icon != nullptr) {
    const auto here = json_member(content, icon->open, "id");
    for (auto next = content.find("\"skill\""); next != std::string::npos;
         next = content.find("\"skill\"", next + 1)) {
      const auto around = json_place(content, next);
      const auto* other = icon_of(around);
      if (other == nullptr || !here || json_member(content, other->open, "next") != here) continue;
      const auto of = json_member(content, other->open, "skill");
      const auto found = of ? skills().find(*of) : skills().end();
      if (found == skills().end()) continue;
      for (const auto& each : found->second.completions) {
        if (std::to_string(each.code) == at.word)
          text += "code " + at.word + " of " + found->first + ", " + kind_text(each.kind) + ": " +
                  each.description + "\n\n";
      }
    }
  }
  if (text.empty() && inner.object)
    for (const SchemaMember& each : members_at(content, at))
      if (each.name == (at.names_member ? at.word : inner.key)) text = member_text(each);
  if (text.empty()) return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", text}}},
          {"range", range_of(*place.text, at.begin, at.end)}};
}

}  // namespace pal::language_server
