#include "server/text_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "operations/load.hpp"
#include "operations/parse.hpp"
#include "operations/storyboard.hpp"
#include "operations/ways.hpp"
#include "operations/write.hpp"
#include "pal/pan/dot.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/finding.hpp"
#include "pal/support/utf8.hpp"
#include "server/json_requests.hpp"
#include "server/program_check.hpp"

namespace pal::server {
namespace {

constexpr std::size_t most_findings = 1000;
constexpr std::size_t most_tidy_icons = 1000;  // of an operation: Graphviz cannot be ended

/// Places in UTF-16 code units, which the strings of browsers are made of. Texts are looked through once.
class Utf16 {
 public:
  explicit Utf16(std::string_view text) : text_(text) {
    std::size_t units = 0;
    for (std::size_t at = 0; at < text.size();) {
      while (at >= marks_.size() * between) marks_.push_back({at, units});
      const auto next = utf8::decode(text.substr(at));
      units += next.code_point > 0xffff ? 2U : 1U;
      at += next.bytes;
    }
    if (marks_.empty()) marks_.push_back({0, 0});
  }
  std::size_t units(std::size_t byte) const {
    const Mark mark = marks_[std::min(byte / between, marks_.size() - 1)];
    std::size_t units = mark.units;
    for (std::size_t at = mark.byte; at < std::min(byte, text_.size());) {
      const auto next = utf8::decode(text_.substr(at));
      units += next.code_point > 0xffff ? 2U : 1U;
      at += next.bytes;
    }
    return units;
  }

 private:
  static constexpr std::size_t between = 256;
  struct Mark {
    std::size_t byte = 0, units = 0;
  };
  std::string_view text_;
  std::vector<Mark> marks_;
};

class FindingTexts {
 public:
  FindingTexts(const SourceManager& sources, const operations::Program* program)
      : sources_(sources), program_(program), fields_(sources) {}

  Json describe_all(const Diagnostics& diagnostics) {
    Json list = Json::array();
    for (const Diagnostic& each : diagnostics.sorted()) {
      if (list.size() >= most_findings) break;
      list.push_back(one(each));
    }
    return list;
  }

 private:
  Json position(FileId file, std::uint32_t offset) {
    const auto at = sources_.line_column(file, offset);
    return {{"line", at.line}, {"column", at.column}, {"offset", utf16(file).units(offset)}};
  }
  const Utf16& utf16(FileId file) {
    const auto found = utf16_.find(file.index());
    if (found != utf16_.end()) return found->second;
    return utf16_.emplace(file.index(), Utf16(sources_.text(file))).first->second;
  }
  std::optional<operations::Extent> extent(SourceSpan where) const {
    if (program_ == nullptr || !where.valid()) return std::nullopt;
    return operations::extent_of(*program_, where);
  }
  Json one(const Diagnostic& finding) {
    Json json{{"code", name(finding.code)},
              {"severity", name(finding.severity)},
              {"message", finding.message},
              {"hint", finding.hint},
              {"hint_for", name(row(finding.finding).hint_for)},
              {"file", ""}};
    if (finding.where.valid()) {
      json["file"] = sources_.name(finding.where.file);
      if (const auto at = extent(finding.where)) {
        json["operation"] = at->operation;
        json["icon"] = at->icon;
      }
      if (const std::string field = fields_.at(finding.where); !field.empty()) json["field"] = field;
      json["begin"] = position(finding.where.file, finding.where.begin);
      json["end"] = position(finding.where.file, finding.where.end);
    }
    json["notes"] = Json::array();
    for (const Note& note : finding.notes) {
      Json each{{"text", note.text}, {"file", note.where.valid() ? sources_.name(note.where.file) : ""}};
      if (const auto at = extent(note.where)) each["icon"] = at->icon;
      if (note.where.valid()) each["begin"] = position(note.where.file, note.where.begin);
      json["notes"].push_back(std::move(each));
    }
    json["edits"] = Json::array();
    for (const Edit& edit : finding.fix)
      if (edit.where.valid())
        json["edits"].push_back({{"file", sources_.name(edit.where.file)},
                                 {"begin", utf16(edit.where.file).units(edit.where.begin)},
                                 {"end", utf16(edit.where.file).units(edit.where.end)},
                                 {"text", edit.text}});
    return json;
  }

  const SourceManager& sources_;
  const operations::Program* program_;
  FieldFinder fields_;
  std::map<std::size_t, Utf16> utf16_;
};

Json time_or_null(const std::optional<Duration>& time) {
  return time ? Json(seconds(*time)) : Json();
}

void put_times(Json& json, const operations::Program& program, const operations::Skills& skills,
               const Facts& facts, const operations::DeclaredTimes& declared, std::size_t most_ways,
               const operations::Stop& stop) {
  const operations::SkillTimes times{facts.times, declared};
  for (const operations::IconTime& time : operations::icon_times(program, skills, times, stop)) {
    const operations::Operation& operation = program.operations[time.at.operation];
    Json each{{"operation", operation.name},
              {"icon", operation.icons[time.at.icon].id},
              {"shortest_s", seconds(time.shortest)},
              {"longest_s", time_or_null(time.longest)},
              {"unknown", time.longest ? "" : time.unknown},
              {"declared", time.declared},
              {"codes", Json::array()}};
    for (const auto& [code, longest] : time.codes)
      if (code != operations::any_code)
        each["codes"].push_back({{"code", code}, {"longest_s", time_or_null(longest)}});
    json["icons"].push_back(std::move(each));
  }
  if (most_ways == 0) return;
  const operations::Ways ways = operations::ways_through(program, skills, times, most_ways, stop);
  json["all_ways"] = ways.complete;
  std::optional<Duration> shortest, longest = Duration::zero();
  for (const operations::WayThrough& way : ways.ways) {
    json["ways"].push_back({{"icons", way.icons},
                            {"end", way.end},
                            {"shortest_s", seconds(way.shortest)},
                            {"longest_s", time_or_null(way.longest)},
                            {"unbounded", way.unbounded},
                            {"declared", way.declared},
                            {"alike", way.alike}});
    shortest = std::min(shortest.value_or(way.shortest), way.shortest);
    longest = longest && way.longest ? std::optional(std::max(*longest, *way.longest)) : std::nullopt;
  }
  json["shortest_s"] = time_or_null(shortest);
  json["longest_s"] = ways.ways.empty() || !ways.complete ? Json() : time_or_null(longest);
}

}  // namespace

Json checked(const FileSystem& files, const std::string& main, const operations::Cell& cell,
             const Facts& facts, std::size_t ways, const operations::Stop& stop) {
  SourceManager sources;
  Diagnostics diagnostics;
  bool whole = true;
  const auto program = operations::load(files, sources, main, diagnostics);
  const bool readable = program && !diagnostics.has_errors();
  if (readable) whole = operations::check_shape(*program, diagnostics, stop);
  const bool well_formed = readable && whole && !diagnostics.has_errors();
  if (well_formed) whole = operations::check_cell(*program, cell, diagnostics, stop);
  std::size_t warnings = 0;
  for (const Diagnostic& each : diagnostics.all()) warnings += each.severity == Severity::warning ? 1U : 0U;
  Json json{{"findings", FindingTexts(sources, program ? &*program : nullptr).describe_all(diagnostics)},
            {"errors", diagnostics.errors()},
            {"warnings", warnings},
            {"runs", program && whole && !diagnostics.has_errors()},
            {"complete", whole && diagnostics.all().size() <= most_findings},
            {"icons", Json::array()},
            {"ways", Json::array()},
            {"all_ways", false},
            {"shortest_s", nullptr},
            {"longest_s", nullptr}};
  if (well_formed && whole && !diagnostics.has_errors() && cell.skills)
    put_times(json, *program, *cell.skills, facts, cell.longest, ways, stop);
  return json;
}

namespace {

[[noreturn]] void refuse_findings(const SourceManager& sources, const Diagnostics& diagnostics,
                                  const operations::Program* program) {
  Problem problem =
      problem_of(Refusal{Refusal::Why::wrong, "the text has errors", "operation.check tells them all"});
  problem.data["findings"] = FindingTexts(sources, program).describe_all(diagnostics);
  throw problem;
}

operations::Document document_of(const std::string& name, const std::string& text) {
  SourceManager sources;
  Diagnostics diagnostics;
  auto document = operations::parse(sources, sources.add(name, text), diagnostics);
  if (!document || diagnostics.has_errors()) refuse_findings(sources, diagnostics, nullptr);
  return std::move(*document);
}

}  // namespace

std::string formatted(const std::string& name, const std::string& text) {
  return operations::write(document_of(name, text));
}

Json tidied(const FileSystem& files, const std::string& main, const TidyOptions& options,
            const operations::Stop& stop) {
  SourceManager sources;
  Diagnostics diagnostics;
  const auto program = operations::load(files, sources, main, diagnostics);
  if (!program) refuse_findings(sources, diagnostics, nullptr);
  constexpr double points = 72;  // of an inch, in which Graphviz has sizes
  constexpr std::pair usual(120.0, 64.0);
  Json json{{"places", Json::array()}};
  bool found = false;
  for (const operations::Operation& operation : program->operations) {
    if (operation.from != main || (!options.operation.empty() && operation.name != options.operation))
      continue;
    if (stop()) fail(Refusal::Why::cancelled, "it was cancelled");
    found = true;
    if (operation.icons.size() > most_tidy_icons)
      fail(Refusal::Why::too_much,
           fmt::format("'{}' has more than {} icons", operation.name, most_tidy_icons),
           "collapse some into a sub-operation");
    const auto size = [&](const operations::Icon& icon) {
      const auto given = options.sizes.find(operations::name(icon.kind));
      return given == options.sizes.end() ? usual : given->second;
    };
    std::string dot = fmt::format(
        "digraph tidy {{ rankdir=LR; ranksep={}; nodesep={}; node [shape=box fixedsize=true "
        "label=\"\"];\n",
        options.ranks_apart / points, options.apart / points);
    std::map<std::string, std::size_t> index;
    for (std::size_t i = 0; i < operation.icons.size(); ++i) {
      const auto [width, height] = size(operation.icons[i]);
      dot += fmt::format("n{} [width={} height={}];\n", i, width / points, height / points);
      index.emplace(operation.icons[i].id, i);
    }
    for (std::size_t i = 0; i < operation.icons.size(); ++i)
      for (const operations::Connection& to : operations::outputs(operation.icons[i]))
        if (const auto at = index.find(to.icon); at != index.end())
          dot += fmt::format("n{} -> n{};\n", i, at->second);
    for (const pan::DotPlace& place : pan::lay_out(dot + "}\n")) {
      const operations::Icon& icon = operation.icons[std::stoul(place.node.substr(1))];
      const auto [width, height] = size(icon);
      json["places"].push_back({{"operation", operation.name},
                                {"icon", icon.id},
                                {"at", {std::round(place.x - width / 2), std::round(place.y - height / 2)}}});
    }
  }
  if (!found)
    fail(Refusal::Why::wrong, fmt::format("'{}' has no operation '{}'", main, options.operation),
         "name an operation of this file");
  return json;
}

Json told_as_story(const FileSystem& files, const std::string& main, const operations::Skills& skills,
                   const operations::Stop& stop) {
  SourceManager sources;
  Diagnostics diagnostics;
  const auto program = operations::load(files, sources, main, diagnostics);
  if (!program) refuse_findings(sources, diagnostics, nullptr);
  operations::check_shape(*program, diagnostics, stop);
  if (diagnostics.has_errors()) refuse_findings(sources, diagnostics, &*program);
  Json json{{"chapters", Json::array()}};
  for (std::size_t i = 0; i < program->operations.size(); ++i)
    if (program->operations[i].icons.size() > most_tidy_icons)
      fail(Refusal::Why::too_much,
           fmt::format("'{}' has more than {} icons", program->operations[i].name, most_tidy_icons),
           "collapse some into a sub-operation");
  for (operations::StoryChapter& each : operations::story(*program, skills)) {
    if (stop()) fail(Refusal::Why::cancelled, "it was cancelled");
    Json scenes = Json::array();
    for (operations::StoryScene& scene : each.scenes)
      scenes.push_back({{"icon", scene.icon},
                        {"title", scene.title},
                        {"sentences", scene.sentences},
                        {"branches", scene.branches}});
    json["chapters"].push_back({{"operation", each.operation},
                                {"introduction", each.introduction},
                                {"scenes", std::move(scenes)},
                                {"picture", pan::svg(each.dot)}});
  }
  return json;
}

namespace {

/// By the names of operations, then the ids of icons; "" has the operation's own fields.
using Fields = std::map<std::string, std::map<std::string, Json>>;

Fields fields_of(const std::string& text) {
  Fields result;
  const auto add = [&result](const Json& operation) {
    auto& icons = result[operation.value("name", std::string())];
    Json own = operation;
    for (const char* other : {"icons", "operations", "operation-format"}) own.erase(other);
    icons[""] = own;
    if (operation.contains("icons"))
      for (const Json& icon : operation["icons"]) icons[icon.value("id", std::string())] = icon;
  };
  const Json document = Json::parse(text);
  add(document);
  if (document.contains("operations"))
    for (const Json& each : document["operations"]) add(each);
  return result;
}

/// The fields that differ.
Json fields_between(const Json& before, const Json& after) {
  Json list = Json::array();
  std::set<std::string> names;
  for (const auto& [name, value] : before.items()) names.insert(name);
  for (const auto& [name, value] : after.items()) names.insert(name);
  for (const std::string& name : names) {
    const bool had = before.contains(name), has = after.contains(name);
    if (had && has && before[name] == after[name]) continue;
    Json each{{"field", name}};
    if (had) each["before"] = before[name];
    if (has) each["after"] = after[name];
    list.push_back(std::move(each));
  }
  return list;
}

}  // namespace

Json difference(const std::string& before, const std::string& after) {
  const std::string first = formatted("before", before), second = formatted("after", after);
  const Fields old = fields_of(first), fresh = fields_of(second);
  Json changes = Json::array();
  bool content = false;
  std::set<std::string> operations;
  for (const auto& [name, icons] : old) operations.insert(name);
  for (const auto& [name, icons] : fresh) operations.insert(name);
  static const std::map<std::string, Json> none;
  for (const std::string& operation : operations) {
    const auto& had = old.contains(operation) ? old.at(operation) : none;
    const auto& has = fresh.contains(operation) ? fresh.at(operation) : none;
    std::set<std::string> icons;
    for (const auto& [icon, fields] : had) icons.insert(icon);
    for (const auto& [icon, fields] : has) icons.insert(icon);
    for (const std::string& icon : icons) {
      const bool was = had.contains(icon), is = has.contains(icon);
      const Json fields =
          fields_between(was ? had.at(icon) : Json::object(), is ? has.at(icon) : Json::object());
      if (fields.empty() && was == is) continue;
      const bool moved = was && is && fields.size() == 1 && fields.front()["field"] == "at";
      content = content || !moved;
      changes.push_back({{"operation", operation},
                         {"icon", icon},
                         {"change", !was    ? "added"
                                    : !is   ? "removed"
                                    : moved ? "moved"
                                            : "changed"},
                         {"fields", fields}});
    }
  }
  // The order of icons is no content.
  return {{"same", first == second}, {"content", content}, {"changes", std::move(changes)}};
}

}  // namespace pal::server
