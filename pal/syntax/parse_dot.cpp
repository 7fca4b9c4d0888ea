#include "pal/syntax/parse_dot.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pal/pan/dump.hpp"
#include "pal/syntax/dot_graph.hpp"
#include "pal/syntax/parse.hpp"

namespace pal::syntax {

namespace {

/// Ends the reading of one node or of the graph; caught in this file, after the finding was reported.
struct Reported {};

bool is_name(std::string_view text) {
  constexpr std::array<std::string_view, 22> reserved = {
      "wtm", "txm",  "spc",  "rpc",   "case", "repeat", "until", "concurrent", "begin", "end", "execute",
      "do",  "else", "true", "false", "and",  "or",     "not",   "none",       "from",  "to",  "request"};
  if (text.empty() || std::isdigit(static_cast<unsigned char>(text.front())) || text.front() == '-' ||
      text.back() == '-' || text.find("--") != std::string_view::npos)
    return false;
  std::string lower;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 127 || (!std::isalnum(byte) && c != '_' && c != '-')) return false;
    lower += static_cast<char>(std::tolower(byte));
  }
  return std::find(reserved.begin(), reserved.end(), lower) == reserved.end();
}

/// The parts of "a;b" with their values' place.
std::vector<DotValue> parts(const DotValue& value) {
  std::vector<DotValue> result;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = value.text.find(';', begin);
    result.push_back({value.text.substr(begin, end - begin), value.where});
    if (end == std::string::npos) return result;
    begin = end + 1;
  }
}

class DotModule {
 public:
  DotModule(const DotGraph& graph, Diagnostics& diagnostics)
      : graph_(graph),
        diagnostics_(diagnostics),
        visited_(graph.nodes.size(), false),
        outs_(graph.nodes.size()),
        backs_(graph.nodes.size()),
        stops_(graph.nodes.size()) {
    for (const DotEdge& edge : graph.edges) {
      auto& list = is_true(edge, "pal_back") ? backs_ : is_true(edge, "pal_stops") ? stops_ : outs_;
      list[edge.from].push_back(&edge);
    }
  }

  ModuleUnit read() {
    ModuleUnit unit;
    unit.name = graph_name("pal_module");
    unit.kind = kind_of_module();
    unit.has_body = true;
    unit.where = graph_.where;
    unit.end = graph_.where;
    read_contents(unit);
    const std::size_t start = only_start();
    Path path;
    visited_[start] = true;
    unit.body = sequence(only_way(start), 0, path);
    if (path.at && kind(*path.at) != "end") {
      fail(Code::PAL0116, node(*path.at).where, "what ends here was never begun",
           "let the branches of a split begin and end with it, and the module end in a node of kind 'end'");
    }
    if (path.at) visited_[*path.at] = true;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      if (!visited_[i])
        diagnostics_.report(Code::PAL0116, node(i).where, "no way leads to this node",
                            "draw the edge to it, or remove it");
    }
    return unit;
  }

 private:
  /// Where a sequence of statements ended: at a node that ends what began before it; nowhere if it never
  /// ends.
  struct Path {
    std::optional<std::size_t> at;
    std::optional<std::size_t> stopped_at;  // the node that the loop it cannot leave is stopped at
  };

  static bool is_true(const DotEdge& edge, const char* name) {
    const auto found = edge.values.find(name);
    return found != edge.values.end() && found->second.text == "true";
  }
  const DotNode& node(std::size_t i) const { return graph_.nodes[i]; }
  const std::string& kind(std::size_t i) const { return node(i).values.at("pal_kind").text; }
  const DotValue* value(std::size_t i, const char* name) const {
    const auto found = node(i).values.find(name);
    return found == node(i).values.end() ? nullptr : &found->second;
  }
  [[noreturn]] void fail(Code code, SourceSpan where, std::string message, std::string hint) {
    diagnostics_.report(code, where, std::move(message), std::move(hint));
    throw Reported{};
  }

  Name graph_name(const char* attribute) {
    const auto found = graph_.values.find(attribute);
    if (found == graph_.values.end()) {
      fail(Code::PAL0115, graph_.where, std::string("the graph does not say its ") + attribute,
           std::string("add 'graph [") + attribute + "=NAME]'");
    }
    return name(found->second);
  }
  pan::ModuleKind kind_of_module() {
    const auto found = graph_.values.find("pal_module_kind");
    if (found == graph_.values.end()) return pan::ModuleKind::skill_module;
    for (const auto kind : {pan::ModuleKind::sensor_driver, pan::ModuleKind::logical_sensor,
                            pan::ModuleKind::machine_controller, pan::ModuleKind::skill_module,
                            pan::ModuleKind::contingency_module}) {
      if (pan::kind_text(kind) == found->second.text) return kind;
    }
    fail(Code::PAL0115, found->second.where, "this is no kind of module", "write for example 'skill module'");
  }

  // Contents.

  Name name(const DotValue& from) {
    if (!is_name(from.text)) {
      fail(Code::PAL0115, from.where, "'" + from.text + "' is no name",
           "a name begins with a letter and goes on with letters, digits, '_' and inner hyphens");
    }
    return {from.text, from.where};
  }
  MessageName message(const DotValue& from) {
    constexpr std::string_view request = "request ";
    const bool asks = from.text.starts_with(request);
    return {asks, name({asks ? from.text.substr(request.size()) : from.text, from.where}), from.where};
  }
  PartyName party(const DotValue& from) { return {std::nullopt, name(from), from.where}; }

  const DotValue& needed(std::size_t i, const char* attribute) {
    const DotValue* found = value(i, attribute);
    if (found == nullptr) {
      fail(Code::PAL0115, node(i).where, "a node of kind '" + kind(i) + "' needs " + attribute,
           std::string("add '") + attribute + "=…' to the node");
    }
    return *found;
  }

  template <class Integer>
  Integer number(const DotValue& from) {
    Integer result = 0;
    const char* end = from.text.data() + from.text.size();
    const auto read = std::from_chars(from.text.data(), end, result);
    if (read.ec != std::errc() || read.ptr != end || result < 0)
      fail(Code::PAL0115, from.where, "'" + from.text + "' is no number",
           "write a whole number, not negative");
    return result;
  }

  static void place(Guard& guard, SourceSpan where) {
    guard.condition.where = where;
    for (Guard& term : guard.terms) place(term, where);
  }
  /// Conditions are read by the parser of PAL, inside a module made for it.
  Guard guard(const DotValue& from) {
    SourceManager sources;
    Diagnostics findings;
    const FileId file =
        sources.add("guard", "Skill Module: M\nBEGIN\nREPEAT\nUNTIL( " + from.text + "\n)\nEND\n");
    Tree tree = parse(sources, file, findings);
    if (tree.complete && tree.units.size() == 1) {
      auto* module = std::get_if<ModuleUnit>(&tree.units.front());
      if (module != nullptr && module->body.size() == 1) {
        auto* repeat = std::get_if<Repeat>(&module->body.front().content);
        if (repeat != nullptr && repeat->until) {
          place(*repeat->until, from.where);
          return std::move(*repeat->until);
        }
      }
    }
    fail(Code::PAL0115, from.where, "this is no condition of PAL",
         "write for example 'pc-force OR NOT pc-reach'");
  }

  void read_contents(ModuleUnit& unit) {
    bool good = true;
    contents_.resize(graph_.nodes.size());
    guards_.resize(graph_.nodes.size());
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      try {
        read_content(i, unit);
      } catch (const Reported&) {
        good = false;
      }
    }
    if (!good) throw Reported{};
  }

  void read_content(std::size_t i, ModuleUnit& unit) {
    if (value(i, "pal_kind") == nullptr) {
      fail(Code::PAL0115, node(i).where, "this node has no pal_kind: nothing says what it means",
           "add 'pal_kind=…' (docs/pan.md lists the kinds)");
    }
    const std::string& word = kind(i);
    Statement& to = contents_[i];
    to.where = node(i).where;
    to.end = node(i).where;
    if (word == "wait_for_start") {
      to.content = WaitForStart{};
    } else if (word == "wait") {
      const auto messages = parts(needed(i, "pal_message"));
      const auto senders = parts(needed(i, "pal_sender"));
      if (messages.size() != senders.size())
        fail(Code::PAL0115, node(i).where, "as many senders as messages are needed",
             "name one sender for each message");
      WaitBranches wait;
      wait.first = messages.size() > 1;
      if (const DotValue* within = value(i, "pal_within_ns"))
        wait.within = Duration(number<std::int64_t>(*within));
      for (std::size_t k = 0; k < messages.size(); ++k)
        wait.arms.push_back({{message(messages[k]), party(senders[k])}, {}, node(i).where});
      if (wait.first || wait.within) {
        to.content = std::move(wait);
      } else {
        to.content = Wait{wait.arms.front().source};
      }
    } else if (word == "send") {
      to.content = Send{message(needed(i, "pal_message")), party(needed(i, "pal_receiver"))};
    } else if (word == "complete") {
      const DotValue& code = needed(i, "pal_code");
      to.content = Complete{number<int>(code), code.where};
    } else if (word == "set") {
      Set set{name(needed(i, "pal_condition")), std::nullopt};
      if (const DotValue* truth = value(i, "pal_value")) {
        if (truth->text != "TRUE" && truth->text != "FALSE")
          fail(Code::PAL0115, truth->where, "a condition is TRUE or FALSE", "write 'pal_value=TRUE'");
        set.value = truth->text == "TRUE";
      }
      to.content = std::move(set);
    } else if (word == "read") {
      to.content = Read{name(needed(i, "pal_condition"))};
    } else if (word == "perform") {
      Perform perform{name(needed(i, "pal_activity"))};
      declare(perform.name, i, unit);
      to.content = std::move(perform);
    } else if (word == "execute") {
      to.content = Execute{party(needed(i, "pal_module"))};
    } else if (word == "nothing") {
      to.content = Nothing{};
    } else if (word == "guard") {
      guards_[i] = guard(needed(i, "pal_guard"));
    } else if (word == "until") {
      if (const DotValue* ending = value(i, "pal_guard")) guards_[i] = guard(*ending);
    } else if (word != "start" && word != "end" && word != "case" && word != "merge" && word != "repeat" &&
               word != "concurrent" && word != "join") {
      fail(Code::PAL0115, value(i, "pal_kind")->where, "there is no kind '" + word + "' of node",
           "docs/pan.md lists the kinds");
    }
  }

  /// An activity is declared by the first of its nodes that says what it reads and writes.
  void declare(const Name& activity, std::size_t i, ModuleUnit& unit) {
    ActivityHeading heading{activity, {}, {}, node(i).where};
    for (const auto& [attribute, to] :
         {std::pair("pal_reads", &heading.reads), std::pair("pal_writes", &heading.writes)}) {
      const DotValue* found = value(i, attribute);
      if (found == nullptr) continue;
      for (const DotValue& part : parts(*found)) to->push_back(name(part));
    }
    const auto same = [&](const ActivityHeading& other) { return other.name.text == activity.text; };
    if (std::none_of(unit.activities.begin(), unit.activities.end(), same))
      unit.activities.push_back(std::move(heading));
  }

  // Ways.

  std::size_t only_start() {
    std::optional<std::size_t> start;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      if (kind(i) != "start") continue;
      if (start)
        fail(Code::PAL0116, node(i).where, "the module begins twice", "keep one node of kind 'start'");
      start = i;
    }
    if (!start)
      fail(Code::PAL0116, graph_.where, "the module begins nowhere",
           "add a node with 'pal_kind=start' and an edge from it");
    return *start;
  }

  std::size_t only_way(std::size_t from) {
    if (outs_[from].empty())
      fail(Code::PAL0116, node(from).where, "no way leads on from this node",
           "draw the edge to what comes next");
    if (outs_[from].size() > 1) {
      fail(Code::PAL0116, outs_[from][1]->where, "a second way on from a node that does not split",
           "split with a node of kind 'case' or 'concurrent'");
    }
    return outs_[from].front()->to;
  }

  /// In the order of pal_branch, or of the text.
  std::vector<std::size_t> branches(std::size_t from) {
    std::vector<std::pair<int, std::size_t>> order;
    for (const DotEdge* edge : outs_[from]) {
      const auto found = edge->values.find("pal_branch");
      const int rank =
          found == edge->values.end() ? static_cast<int>(order.size()) : number<int>(found->second);
      order.emplace_back(rank, edge->to);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::size_t> result;
    for (const auto& entry : order) result.push_back(entry.second);
    if (result.empty())
      fail(Code::PAL0116, node(from).where, "no way leads on from this node",
           "draw the edges to its branches");
    return result;
  }

  /// A branch of `split`; where the branches come together must be one node, of the kind `together`.
  Statements branch(std::size_t split, std::size_t first, int depth, const char* together, Path& all) {
    Path path;
    Statements body = sequence(first, depth + 1, path);
    if (!path.at) {
      if (!all.stopped_at) all.stopped_at = path.stopped_at;
      return body;
    }
    if (kind(*path.at) != together || (all.at && *all.at != *path.at)) {
      auto& finding = diagnostics_.report(
          Code::PAL0116, node(split).where,
          std::string("the ways out of this node do not come together in one '") + together + "'",
          std::string("let each of them lead to the same node of kind '") + together + "'");
      finding.notes.push_back({node(*path.at).where, "one of them comes here"});
      if (all.at && *all.at != *path.at) finding.notes.push_back({node(*all.at).where, "another one here"});
      throw Reported{};
    }
    all.at = path.at;
    return body;
  }

  /// What follows the node where something ended.
  std::size_t behind(std::size_t mate) {
    visit(mate);
    return only_way(mate);
  }

  void visit(std::size_t i) {
    if (visited_[i]) {
      fail(Code::PAL0116, node(i).where,
           "ways meet here that did not part, or a loop closes without REPEAT and UNTIL",
           "let branches meet in a node of kind 'merge', and loops go from 'until' back to 'repeat'");
    }
    visited_[i] = true;
  }

  Statements sequence(std::size_t i, int depth, Path& path) {
    Statements result;
    if (depth > deepest_nesting)
      fail(Code::PAL0105, node(i).where, "statements are nested too deeply here",
           "take a part out into a module of its own");
    for (std::optional<std::size_t> next = i; next;) {
      const std::size_t at = *next;
      const std::string& word = kind(at);
      if (word == "end" || word == "merge" || word == "until" || word == "join") {
        path.at = at;
        return result;
      }
      visit(at);
      if (word == "start" || word == "guard") {
        fail(Code::PAL0116, node(at).where, "a node of kind '" + word + "' cannot stand here",
             "guards follow a 'case', and nothing leads to the 'start'");
      }
      Statement statement = std::move(contents_[at]);
      if (word == "case") {
        next = choose(at, depth, statement, path);
      } else if (word == "repeat") {
        next = repeat(at, depth, statement, path);
      } else if (word == "concurrent") {
        next = concurrent(at, depth, statement);
      } else if (auto* wait = std::get_if<WaitBranches>(&statement.content)) {
        next = wait_branches(at, depth, *wait, path);
      } else {
        next = only_way(at);
      }
      result.push_back(std::move(statement));
    }
    return result;
  }

  std::optional<std::size_t> on(const Path& all, Path& path) {
    if (all.at) return behind(*all.at);
    path.stopped_at = all.stopped_at;
    return std::nullopt;
  }

  std::optional<std::size_t> choose(std::size_t at, int depth, Statement& statement, Path& path) {
    Choose result;
    Path all;
    for (const std::size_t arm : branches(at)) {
      if (kind(arm) != "guard") {
        fail(Code::PAL0116, node(arm).where, "what follows a 'case' is the condition of an arm",
             "put a node of kind 'guard' between");
      }
      visit(arm);
      Guard holds = std::move(guards_[arm].value());
      result.arms.push_back(
          {std::move(holds), branch(at, only_way(arm), depth, "merge", all), node(arm).where});
    }
    statement.content = std::move(result);
    return on(all, path);
  }

  std::optional<std::size_t> wait_branches(std::size_t at, int depth, WaitBranches& wait, Path& path) {
    const auto ways = branches(at);
    const std::size_t expected = wait.arms.size() + (wait.within ? 1 : 0);
    if (ways.size() != expected) {
      fail(Code::PAL0116, node(at).where,
           "this wait needs " + std::to_string(expected) + " ways out and has " + std::to_string(ways.size()),
           "draw an edge for each message, and one for ELSE if it gives up");
    }
    Path all;
    for (std::size_t k = 0; k < ways.size(); ++k)
      (k < wait.arms.size() ? wait.arms[k].body : wait.otherwise) = branch(at, ways[k], depth, "merge", all);
    return on(all, path);
  }

  std::optional<std::size_t> repeat(std::size_t at, int depth, Statement& statement, Path& path) {
    Path body;
    Repeat result;
    result.body = branch(at, only_way(at), depth, "until", body);
    if (!body.at)
      fail(Code::PAL0116, node(at).where, "this REPEAT never comes to its UNTIL",
           "draw the edge to a node of kind 'until'");
    const std::size_t until = *body.at;
    visit(until);
    auto& outs = outs_[until];
    const auto leads_back = [&](const DotEdge* edge) { return edge->to == at; };
    const auto is_back = [&](const DotEdge* edge) { return edge->to == until; };
    const bool drawn = std::any_of(outs.begin(), outs.end(), leads_back) ||
                       std::any_of(backs_[at].begin(), backs_[at].end(), is_back) ||
                       std::any_of(backs_[until].begin(), backs_[until].end(), leads_back);
    if (!drawn)
      fail(Code::PAL0116, node(until).where, "no way leads from this UNTIL back to its REPEAT",
           "draw the edge to the node of kind 'repeat'");
    std::erase_if(outs, leads_back);
    result.until_where = node(until).where;
    statement.end = node(until).where;
    result.until = std::move(guards_[until]);
    const bool ends = result.until.has_value();
    statement.content = std::move(result);
    if (ends) return only_way(until);
    if (!outs.empty()) {
      fail(Code::PAL0116, outs.front()->where, "nothing follows a loop that goes on forever",
           "give the 'until' a pal_guard, or mark the edge to the bar that stops it with 'pal_stops=true'");
    }
    if (!stops_[until].empty()) path.stopped_at = stops_[until].front()->to;
    return std::nullopt;
  }

  std::optional<std::size_t> concurrent(std::size_t at, int depth, Statement& statement) {
    Concurrent result;
    Path all;
    for (const std::size_t block : branches(at))
      result.blocks.push_back({branch(at, block, depth, "join", all), node(at).where});
    statement.content = std::move(result);
    std::optional<std::size_t> join = all.at ? all.at : all.stopped_at ? all.stopped_at : mate(at);
    if (!join || kind(*join) != "join") {
      fail(Code::PAL0116, node(at).where, "this CONCURRENT has no 'join'",
           "draw an edge from a block to a node of kind 'join'; from one that cannot end, with "
           "'pal_stops=true'");
    }
    return behind(*join);
  }

  /// The node that pal_mate names; needed where no way leads to it.
  std::optional<std::size_t> mate(std::size_t at) const {
    const DotValue* wanted = value(at, "pal_mate");
    for (std::size_t i = 0; wanted != nullptr && i < graph_.nodes.size(); ++i) {
      const DotValue* number = value(i, "pal_node");
      if (number != nullptr && number->text == wanted->text) return i;
    }
    return std::nullopt;
  }

  const DotGraph& graph_;
  Diagnostics& diagnostics_;
  std::vector<bool> visited_;
  std::vector<std::vector<const DotEdge*>> outs_, backs_, stops_;
  std::vector<Statement> contents_;
  std::vector<std::optional<Guard>> guards_;
};

}  // namespace

Tree parse_dot(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto errors_before = diagnostics.errors();
  Tree tree;
  tree.file = file;
  if (const auto graph = parse_dot_graph(sources, file, diagnostics)) {
    if (const auto uses = graph->values.find("pal_uses"); uses != graph->values.end()) {
      for (const DotValue& path : parts(uses->second))
        tree.units.emplace_back(Uses{path.text, path.where, {}});
    }
    try {
      tree.units.emplace_back(DotModule(*graph, diagnostics).read());
    } catch (const Reported&) {
      // What is wrong has been said.
    }
  }
  tree.complete = diagnostics.errors() == errors_before;
  return tree;
}

}  // namespace pal::syntax
