// Selections that grow by the structure of the text, and the END that is written by itself.
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "language_server/session.hpp"
#include "language_server/text.hpp"
#include "pal/syntax/text_tokens.hpp"

namespace pal::language_server {

namespace {

using syntax::TextToken;
using Span = std::pair<std::uint32_t, std::uint32_t>;

/// The spans of a tree that hold a place.
class Holding {
 public:
  explicit Holding(std::uint32_t offset) : offset_(offset) {}

  void add(const SourceSpan& where) {
    if (where.valid()) add(where.begin, where.end);
  }
  void add(std::uint32_t begin, std::uint32_t end) {
    if (begin <= offset_ && offset_ <= end && begin < end) spans_.insert({begin, end});
  }
  /// A list as a whole, and what is in it.
  void add(const syntax::Statements& list) {
    if (list.empty()) return;
    add(list.front().where.begin, std::max(list.back().where.end, list.back().end.end));
    for (const auto& each : list) add(each);
  }

  /// From the smallest on; of those that cross each other the smaller one counts.
  std::vector<Span> nested() const {
    std::vector<Span> sorted(spans_.begin(), spans_.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Span& a, const Span& b) { return a.second - a.first < b.second - b.first; });
    std::vector<Span> result;
    for (const auto& each : sorted) {
      if (result.empty() || (each.first <= result.back().first && each.second >= result.back().second))
        result.push_back(each);
    }
    return result;
  }

 private:
  void add(const syntax::Statement& statement) {
    add(statement.where);
    if (statement.end.valid()) add(statement.where.begin, statement.end.end);
    if (const auto* wait = std::get_if<syntax::WaitBranches>(&statement.content)) {
      for (const auto& arm : wait->arms) {
        add(arm.where);
        add(arm.body);
      }
      add(wait->otherwise);
    } else if (const auto* choose = std::get_if<syntax::Choose>(&statement.content)) {
      for (const auto& arm : choose->arms) {
        add(arm.where);
        add(arm.body);
        if (!arm.body.empty())
          add(arm.where.begin, std::max(arm.body.back().where.end, arm.body.back().end.end));
      }
    } else if (const auto* repeat = std::get_if<syntax::Repeat>(&statement.content)) {
      add(repeat->body);
    } else if (const auto* concurrent = std::get_if<syntax::Concurrent>(&statement.content)) {
      for (const auto& block : concurrent->blocks) {
        add(block.where);
        add(block.body);
      }
    }
  }

  std::uint32_t offset_;
  std::set<Span> spans_;
};

/// The ENDs that a text lacks: one for each line that opens something, in the order of the text.
struct Opened {
  std::uint32_t at = 0;
  std::string end;  // "END CASE"
};

/// What is open at the end of the unit around `offset`: at the next word that begins a unit, or at the end.
std::vector<Opened> open_in_unit(std::string_view content, std::uint32_t offset) {
  static const std::set<std::string> units{"USES",    "MESSAGE", "SKILL",       "SENSOR",     "LOGICAL",
                                           "MACHINE", "DEVICE",  "CONTINGENCY", "ENVIRONMENT"};
  std::vector<Opened> open;
  std::string before;
  for (const auto& token : syntax::text_tokens(content)) {
    if (token.kind == TextToken::Kind::comment || token.kind == TextToken::Kind::text) continue;
    const std::string word = capitals(content.substr(token.begin, token.end - token.begin));
    const auto line = content.rfind('\n', token.begin) + 1;  // npos + 1 is the beginning
    const bool begins_line = content.find_first_not_of(" \t", line) == token.begin;
    if (units.contains(word) && line == token.begin) {
      if (token.begin > offset) return open;
      open.clear();
    } else if (word == "END" || word == "UNTIL") {
      if (!open.empty() && begins_line && (word == "END") == (open.back().end != "UNTIL( forever )"))
        open.pop_back();
    } else if (begins_line && word == "BEGIN") {
      open.push_back({token.begin, "END"});
    } else if (begins_line && (word == "CASE" || word == "CONCURRENT") && before != "END") {
      open.push_back({token.begin, "END " + word});
    } else if (begins_line && word == "REPEAT") {
      open.push_back({token.begin, "UNTIL( forever )"});
    } else if ((word == "FIRST" && before == "WTM") || (word == "WITHIN" && before == ")")) {
      if (open.empty() || open.back().end != "END WTM" || content.find('\n', open.back().at) < token.begin)
        open.push_back({static_cast<std::uint32_t>(content.find_first_not_of(" \t", line)), "END WTM"});
    }
    before = word;
  }
  return open;
}

}  // namespace

Json Session::selection_range(const Json& params) {
  const auto path = path_in(params);
  const auto text = workspace_.text(path);
  const auto* tree = index_.tree(path);
  Json result = Json::array();
  for (const Json& each : member(params, "positions")) {
    const auto position = position_of(each);
    if (text == nullptr) continue;
    Holding holding(text->offset(position));
    for (const auto& token : syntax::text_tokens(text->content())) holding.add(token.begin, token.end);
    if (tree != nullptr) {
      for (const auto& symbol : check::symbols_of({*tree}).all) holding.add(symbol.where);
      for (const auto& unit : tree->units) {
        if (const auto* module = std::get_if<syntax::ModuleUnit>(&unit)) {
          holding.add(module->whole);
          holding.add(module->body);
        } else if (const auto* skill = std::get_if<syntax::SkillUnit>(&unit)) {
          holding.add(skill->whole);
          for (const auto& requirement : skill->requirements) holding.add(requirement.where);
        } else if (const auto* environment = std::get_if<syntax::EnvironmentUnit>(&unit)) {
          holding.add(environment->whole);
          for (const auto& item : environment->placements) holding.add(item.where);
          for (const auto& item : environment->activities) holding.add(item.where);
          for (const auto& item : environment->devices) holding.add(item.where);
        }
      }
    }
    holding.add(0, static_cast<std::uint32_t>(text->content().size()));
    Json range;
    const auto spans = holding.nested();
    for (auto span = spans.rbegin(); span != spans.rend(); ++span) {
      Json outer = std::move(range);
      range = {{"range", range_of(*text, span->first, span->second)}};
      if (!outer.is_null()) range["parent"] = std::move(outer);
    }
    if (range.is_null()) range = {{"range", {{"start", json_of(position)}, {"end", json_of(position)}}}};
    result.push_back(std::move(range));
  }
  return result;
}

/// After a line break behind a line that opens something: its END, if the unit lacks one.
Json Session::on_type_formatting(const Json& params) {
  const auto place = place_in(params);
  const auto line = place.text->position(place.offset).line;
  Json result = Json::array();
  if (line == 0 || string_of(params, "ch") != "\n") return result;
  const auto above = place.text->line(line - 1);
  const auto first = above.find_first_not_of(" \t");
  if (first == std::string_view::npos) return result;
  const auto begin = place.text->offset({line - 1, 0}) + static_cast<std::uint32_t>(first);
  const auto open = open_in_unit(place.text->content(), begin);
  // Of several that are open the new one is the last that nothing closes: all ENDs are taken by those inside.
  const auto found =
      std::find_if(open.begin(), open.end(), [&](const auto& each) { return each.at == begin; });
  const bool any = !open.empty() && open.back().at <= begin;
  std::string end;
  if (found != open.end()) {
    end = found->end;
  } else if (any) {  // its END was taken from one around it
    const auto around = open_in_unit(place.text->content().substr(0, place.text->offset({line, 0})), begin);
    if (!around.empty() && around.back().at == begin) end = around.back().end;
  }
  if (end.empty()) return result;
  const std::string indentation(above.substr(0, first));
  if (line + 1 < place.text->lines()) {
    const auto at = place.text->offset({line + 1, 0});
    result.push_back(text_edit(*place.text, at, at, indentation + end + "\n"));
  } else {
    const auto at = place.text->content().size();
    result.push_back(text_edit(*place.text, at, at, "\n" + indentation + end));
  }
  return result;
}

}  // namespace pal::language_server
