#include "pal/syntax/dot/vocabulary.hpp"

#include <algorithm>
#include <array>

#include "pal/support/finding.hpp"
#include "pal/support/nearest.hpp"

namespace pal::syntax {

namespace {

const std::vector<DotKind>& kinds() {
  static const std::vector<DotKind> table = {
      {"start", {}, {}},
      {"end", {}, {}},
      {"wait_for_start", {}, {}},
      {"wait", {"pal_message", "pal_sender"}, {"pal_within_ns"}},
      {"send", {"pal_message", "pal_receiver"}, {}},
      {"complete", {"pal_code"}, {}},
      {"set", {"pal_condition"}, {"pal_value"}},
      {"read", {"pal_condition"}, {}},
      {"perform", {"pal_activity"}, {"pal_reads", "pal_writes"}},
      {"execute", {"pal_module"}, {}},
      {"nothing", {}, {}},
      {"case", {}, {}},
      {"guard", {"pal_guard"}, {}},
      {"merge", {}, {}},
      {"repeat", {}, {}},
      {"until", {}, {"pal_guard"}},
      {"concurrent", {}, {}},
      {"join", {}, {}},
  };
  return table;
}

constexpr std::array of_every_node{"pal_kind", "pal_node", "pal_mate"};
constexpr std::array of_graphs{"pal_format",     "pal_skill",       "pal_module",  "pal_module_kind",
                               "pal_activities", "pal_description", "pal_drivers", "pal_method",
                               "pal_returns",    "pal_uses"};
constexpr std::array of_edges{"pal_branch",      "pal_thread",    "pal_back",  "pal_stops",
                              "pal_never_taken", "pal_block_end", "pal_layout"};

template <class List>
bool holds(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

const std::vector<std::string>& all_attributes() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names(of_every_node.begin(), of_every_node.end());
    names.insert(names.end(), of_graphs.begin(), of_graphs.end());
    names.insert(names.end(), of_edges.begin(), of_edges.end());
    for (const DotKind& kind : kinds()) {
      names.insert(names.end(), kind.needs.begin(), kind.needs.end());
      names.insert(names.end(), kind.may_have.begin(), kind.may_have.end());
    }
    return names;
  }();
  return all;
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const DotKind& kind : kinds()) names.emplace_back(kind.name);
  return names;
}

std::string listed(const DotKind& kind) {
  std::string text;
  for (const auto& list : {kind.needs, kind.may_have}) {
    for (const std::string_view name : list) text += (text.empty() ? "" : ", ") + std::string(name);
  }
  return text.empty() ? "it has none of its own" : "it has " + text;
}

/// As much of a text as a line of a report can show.
std::string shown(const std::string& text) {
  constexpr std::size_t most = 60;
  if (text.size() <= most) return "'" + text + "'";
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return "'" + text.substr(0, end) + "…'";
}

}  // namespace

const DotKind* dot_kind(std::string_view name) {
  const auto found =
      std::find_if(kinds().begin(), kinds().end(), [&](const DotKind& kind) { return kind.name == name; });
  return found == kinds().end() ? nullptr : &*found;
}

bool is_dot_attribute(std::string_view name) {
  return holds(all_attributes(), name);
}

void report_strange_attribute(const DotValue& name, Diagnostics& diagnostics) {
  diagnostics.report(Finding::unknown_attribute, name.where, shown(name.text))
      .suggest(nearest(name.text, all_attributes()));
}

bool check_attributes(const DotNode& node, Diagnostics& diagnostics) {
  const DotValue* word = node.values.find("pal_kind");
  if (word == nullptr) {
    diagnostics.report(Finding::node_without_kind, node.where);
    return false;
  }
  const DotKind* kind = dot_kind(word->text);
  if (kind == nullptr) {
    diagnostics.report(Finding::unknown_kind_of_node, word->where, shown(word->text))
        .suggest(nearest(word->text, kind_names()));
    return false;
  }
  bool good = true;
  for (const std::string_view needed : kind->needs) {
    if (node.values.find(needed) != nullptr) continue;
    diagnostics.report(Finding::node_lacks_attribute, node.where, word->text, needed);
    good = false;
  }
  for (const auto& [name, value] : node.values) {
    if (holds(of_every_node, name) || holds(kind->needs, name) || holds(kind->may_have, name)) continue;
    diagnostics.report(Finding::attribute_of_another_kind, value->where, word->text, name, listed(*kind));
  }
  return good;
}

}  // namespace pal::syntax
