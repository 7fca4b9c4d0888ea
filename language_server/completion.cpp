// What may be written at a place: keywords, blocks, and names of the sort that is wanted there.
#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "language_server/session.hpp"
#include "pal/check/rules/layers.hpp"
#include "pal/pan/dump.hpp"
#include "pal/syntax/expected.hpp"

namespace pal::language_server {

namespace {

using check::SymbolKind;
using syntax::Wanted;

/// Whole statements and units, by the word that begins them. `$1` are the places to fill in.
const std::map<std::string, std::string>& blocks() {
  static const std::map<std::string, std::string> table{
      {"WTM", "WTM( ${1:message} from ${2:module} )"},
      {"TXM", "TXM( ${1:message} to ${2:module} )"},
      {"SPC", "SPC( ${1:condition} )"},
      {"RPC", "RPC( ${1:condition} )"},
      {"CASE",
       "CASE\n  ( ${1:condition} = TRUE ):\n    $0\n  ( ${1:condition} = FALSE ):\n    Do Nothing\nEND CASE"},
      {"REPEAT", "REPEAT\n  $0\nUNTIL( ${1:forever} )"},
      {"CONCURRENT", "CONCURRENT\nBEGIN\n  $1\nEND\n\nBEGIN\n  $2\nEND\nEND CONCURRENT"},
      {"Skill Module:", "Skill Module: ${1:SM1}\nBEGIN\n  WTM( Coordinator )\n  $0\nEND"},
      {"Logical Sensor:", "Logical Sensor: ${1:LS1}\nBEGIN\n  $0\nEND"},
      {"Sensor Driver:", "Sensor Driver: ${1:SD1}\nBEGIN\n  $0\nEND"},
      {"Machine Controller:", "Machine Controller: ${1:MC1}\nBEGIN\n  $0\nEND"},
      {"Contingency Module:", "Contingency Module: ${1:CM1}\nBEGIN\n  $0\nEND"},
  };
  return table;
}

const char* const keywords_in_small_letters[] = {"from", "to", "request"};

std::string spelled(const std::string& keyword, bool in_statement) {
  std::string small = keyword;
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* each : keywords_in_small_letters) {
    if (in_statement && small == each) return small;
  }
  if (keyword == "EXECUTE") return "Execute";
  if (keyword == "FOREVER") return "forever";
  if (keyword == "COORDINATOR") return "Coordinator";
  return keyword;
}

bool is_word(const std::string& keyword) {
  return std::isalpha(static_cast<unsigned char>(keyword.front())) != 0;
}

std::optional<pan::ModuleKind> kind_wanted(Wanted wanted) {
  switch (wanted) {
    case Wanted::sensor_driver:
      return pan::ModuleKind::sensor_driver;
    case Wanted::logical_sensor:
      return pan::ModuleKind::logical_sensor;
    case Wanted::machine_controller:
      return pan::ModuleKind::machine_controller;
    case Wanted::skill_method:
      return pan::ModuleKind::skill_module;
    case Wanted::contingency_method:
      return pan::ModuleKind::contingency_module;
    default:
      return std::nullopt;
  }
}

/// Names of a family, chosen for one place.
class Chooser {
 public:
  Chooser(const Family& family, FileId file, std::uint32_t offset) : family_(family) {
    for (const auto& tree : family.trees) {
      for (const auto& unit : tree.units) {
        const auto* module = std::get_if<syntax::ModuleUnit>(&unit);
        if (module == nullptr) continue;
        kinds_[module->name.text] = module->kind;
        if (module->where.file == file && module->where.begin <= offset &&
            (here_ == nullptr || here_->where.begin < module->where.begin))
          here_ = module;
      }
    }
  }

  /// Pairs of a name and what it is.
  std::set<std::pair<std::string, std::string>> names(Wanted wanted) const {
    std::set<std::pair<std::string, std::string>> result;
    const auto add = [&](SymbolKind kind, const auto& fits) {
      for (const auto& symbol : family_.symbols.all) {
        if (symbol.kind == kind && fits(symbol))
          result.emplace(symbol.name, symbol.owner.empty()
                                          ? check::name(kind)
                                          : std::string(check::name(kind)) + " of " + symbol.owner);
      }
    };
    const auto any = [](const check::Symbol&) { return true; };
    switch (wanted) {
      case Wanted::message:
        add(SymbolKind::message, any);
        break;
      case Wanted::condition:
        add(SymbolKind::condition, any);
        break;
      case Wanted::sender:
      case Wanted::receiver:
      case Wanted::asked:
        add(SymbolKind::module,
            [this](const auto& symbol) { return may_talk_with(kind_of(symbol.name), symbol.name); });
        add(SymbolKind::device, [this](const auto&) { return may_talk_with(std::nullopt, {}); });
        break;
      case Wanted::party:
        add(SymbolKind::module, any);
        add(SymbolKind::device, any);
        break;
      case Wanted::activity:
        add(SymbolKind::activity,
            [this](const auto& symbol) { return here_ == nullptr || symbol.owner == here_->name.text; });
        break;
      case Wanted::activity_of_time:
        add(SymbolKind::activity, any);
        break;
      case Wanted::callee:
        add(SymbolKind::module, [this](const auto& symbol) {
          return kind_of(symbol.name) == pan::ModuleKind::contingency_module ||
                 kind_of(symbol.name) == pan::ModuleKind::skill_module;
        });
        break;
      case Wanted::module:
        add(SymbolKind::module, any);
        break;
      case Wanted::device:
        add(SymbolKind::device, any);
        add(SymbolKind::module, any);
        break;
      case Wanted::processor:
        add(SymbolKind::processor, any);
        break;
      case Wanted::skill:
        add(SymbolKind::skill, any);
        break;
      case Wanted::completion_code:
        add(SymbolKind::completion, any);
        break;
      case Wanted::contingency_number:
        add(SymbolKind::contingency, any);
        break;
      case Wanted::time_unit:
        for (const char* unit : {"ns", "us", "ms", "s", "min"}) result.emplace(unit, "unit of time");
        break;
      case Wanted::unit:
        for (const char* unit :
             {"mm", "cm", "m", "in", "deg", "rad", "N", "N*m", "mm/s", "deg/s", "s", "ms", "%"})
          result.emplace(unit, "unit");
        break;
      default:
        if (const auto kind = kind_wanted(wanted))
          add(SymbolKind::module, [&](const auto& symbol) { return kind_of(symbol.name) == kind; });
    }
    return result;
  }

 private:
  std::optional<pan::ModuleKind> kind_of(const std::string& module) const {
    const auto found = kinds_.find(module);
    return found == kinds_.end() ? std::nullopt : std::optional(found->second);
  }
  bool may_talk_with(std::optional<pan::ModuleKind> kind, const std::string& name) const {
    if (here_ == nullptr) return true;
    return name != here_->name.text && check::may_talk(check::layer_of(here_->kind), check::layer_of(kind));
  }

  const Family& family_;
  std::map<std::string, pan::ModuleKind> kinds_;
  const syntax::ModuleUnit* here_ = nullptr;
};

}  // namespace

Json Session::completion(const Json& params) {
  const auto place = place_in(params);
  if (is_operation(place.path)) return operation_completion(place);
  const auto& content = place.text->content();
  std::size_t begin = place.offset;
  const auto continues = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  };
  while (begin > 0 && continues(content[begin - 1])) --begin;
  const auto before =
      place.text->line(place.text->position(place.offset).line)
          .substr(0, place.offset - place.text->offset({place.text->position(place.offset).line, 0}));
  if (before.find('#') != std::string_view::npos || std::count(before.begin(), before.end(), '"') % 2 == 1)
    return Json::array();  // a comment, or a text
  const auto expected = syntax::expected_at(content, place.offset);
  const auto family = index_.family(place.path);
  const Chooser chooser(*family, index_.id(place.path), place.offset);
  Json items = Json::array();
  std::set<std::string> labels;
  const auto add = [&](const std::string& label, int kind, const std::string& detail,
                       const std::string& order, const std::string& inserted, bool snippet) {
    if (!labels.insert(label).second) return;
    Json item{{"label", label},
              {"kind", kind},
              {"sortText", order + label},
              {"textEdit", text_edit(*place.text, begin, place.offset, inserted)}};
    if (!detail.empty()) item["detail"] = detail;
    if (snippet) item["insertTextFormat"] = 2;
    items.push_back(std::move(item));
  };
  for (const auto wanted : expected.wanted) {
    for (const auto& [name, detail] : chooser.names(wanted)) add(name, 6, detail, "1", name, false);
  }
  const bool in_statement = expected.line_begins_with == "WTM" || expected.line_begins_with == "TXM" ||
                            expected.line_begins_with == "(";
  for (const auto& keyword : expected.keywords) {
    if (!is_word(keyword)) continue;
    const auto word = spelled(keyword, in_statement);
    const auto block = blocks().find(keyword);
    const bool starts = expected.line_begins_with.empty();
    if (snippets_ && starts && block != blocks().end()) {
      add(word, 15, "block", "2", block->second, true);
    } else {
      add(word, 14, "", "2", word == "DO" ? "Do Nothing" : word, false);
    }
  }
  return items;
}

}  // namespace pal::language_server
