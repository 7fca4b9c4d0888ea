#include "pal/pan/dot_letters.hpp"

#include <algorithm>
#include <cstddef>

#include "pal/pan/dot_attributes.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/xml.hpp"

namespace pal::pan {

namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

Pairs::const_iterator meaning(const Pairs& pairs, const std::string& text) {
  return std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.second == text; });
}

std::string capital(std::size_t index) {
  const std::string last(1, static_cast<char>('A' + index % 26));
  return index < 26 ? last : capital(index / 26 - 1) + last;
}

template <class... Kinds>
bool is_any(const Content& content) {
  return (std::holds_alternative<Kinds>(content) || ...);
}

}  // namespace

DotLetters::DotLetters(const Network& network, ModuleId module) : network_(network) {
  const Graph& body = network.modules[module.index()].body;
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const Content& content = body.nodes[i].content;
    if (const auto* set = std::get_if<Set>(&content)) meet(set->condition);
    if (const auto* read = std::get_if<Read>(&content)) meet(read->condition);
    if (const auto* choose = std::get_if<Choose>(&content)) {
      for (const Guard& it : choose->guards) meet(it);
    }
    if (const auto* until = std::get_if<Until>(&content); until != nullptr && until->guard)
      meet(*until->guard);
    if (is_any<Start, End, Choose, Merge, Loop, Until, Fork, Join>(content)) continue;
    const std::string text = statement_text(network, module, NodeId(i));
    if (meaning(statements_, text) == statements_.end())
      statements_.emplace_back(capital(statements_.size()), text);
  }
}

void DotLetters::meet(const Guard& guard) {
  if (guard.kind == Guard::Kind::equals) meet(guard.condition);
  for (const Guard& term : guard.terms) meet(term);
}

void DotLetters::meet(ConditionId condition) {
  const std::string& text = network_.conditions[condition.index()].name;
  if (meaning(conditions_, text) == conditions_.end()) {
    conditions_.emplace_back("c" + std::to_string(conditions_.size() + 1), text);
  }
}

std::string DotLetters::letter(const std::string& statement) const {
  const auto found = meaning(statements_, statement);
  return found == statements_.end() ? statement : found->first;
}

std::string DotLetters::guard(const Guard& guard) const {
  if (guard.kind == Guard::Kind::equals) {
    const auto found = meaning(conditions_, network_.conditions[guard.condition.index()].name);
    return (guard.value ? "" : "not ") + found->first;
  }
  if (guard.kind == Guard::Kind::negation) {
    const Guard& term = guard.terms.front();
    const bool bare = term.kind == Guard::Kind::equals && term.value;
    return bare ? "not " + this->guard(term) : "not (" + this->guard(term) + ")";
  }
  std::string text;
  for (const Guard& term : guard.terms) {
    if (!text.empty()) text += guard.kind == Guard::Kind::all_of ? " and " : " or ";
    const bool simple = term.kind == Guard::Kind::equals || term.kind == Guard::Kind::negation;
    text += simple ? this->guard(term) : "(" + this->guard(term) + ")";
  }
  return text;
}

std::string DotLetters::key(const std::string& title, std::size_t columns, const std::string& signs) const {
  Pairs rows = statements_;
  rows.insert(rows.end(), conditions_.begin(), conditions_.end());
  constexpr std::size_t most_rows = 20;
  columns = std::max(columns, (rows.size() + most_rows - 1) / most_rows);
  const std::size_t height = (rows.size() + columns - 1) / columns;
  std::string table = "<<TABLE BORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"2\"><TR><TD COLSPAN=\"" +
                      std::to_string(2 * columns) + "\"><FONT POINT-SIZE=\"13\">" + xml_escaped(title) +
                      "</FONT></TD></TR>";
  for (std::size_t row = 0; row < height; ++row) {
    table += "<TR>";
    for (std::size_t i = row; i < columns * height; i += height) {
      // Graphviz refuses a whole table for one <B></B> with nothing in it.
      table += i >= rows.size() ? "<TD></TD><TD></TD>"
                                : "<TD ALIGN=\"RIGHT\"><B>" + xml_escaped(rows[i].first) +
                                      "</B></TD><TD ALIGN=\"LEFT\">" + xml_escaped(rows[i].second) + "</TD>";
    }
    table += "</TR>";
  }
  if (!signs.empty())
    table += "<TR><TD COLSPAN=\"" + std::to_string(2 * columns) +
             "\"><TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"4\">" + signs + "</TABLE></TD></TR>";
  return table + "</TABLE>>";
}

}  // namespace pal::pan
