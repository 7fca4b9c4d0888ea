#include "pal/syntax/dot/graph.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/syntax/dot/tokens.hpp"
#include "pal/syntax/dot/vocabulary.hpp"
#include "pal/syntax/parse.hpp"

namespace pal::syntax {

namespace {

/// The nodes of one end of an edge, each once.
using Ends = std::vector<std::size_t>;

struct Defaults {
  DotValues node;
  DotValues edge;
};

class DotParser {
 public:
  DotParser(FileId file, std::string_view text, Diagnostics& diagnostics)
      : lexer_(file, text), diagnostics_(diagnostics) {
    step();
  }

  DotGraph parse() {
    if (is_word("strict")) step();
    graph_.where = token_.where;
    if (is_word("graph")) throw NotDot{token_.where, {Finding::graph_without_directions}};
    if (!is_word("digraph")) throw NotDot{token_.where, {Finding::no_digraph}};
    step();
    if (!is_sign("{")) identifier();
    statements({}, 0);
    if (token_.kind != DotToken::Kind::end) {
      throw NotDot{token_.where, {Finding::text_after_graph}};
    }
    return std::move(graph_);
  }

 private:
  void step() { token_ = lexer_.next(); }
  bool is_sign(std::string_view text) const {
    return token_.kind == DotToken::Kind::sign && token_.text == text;
  }
  /// Keywords are read in any case.
  bool is_word(std::string_view keyword) const {
    const auto same = [](char a, char b) {
      return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b - 'A' + 'a') : b);
    };
    return token_.kind == DotToken::Kind::word &&
           std::equal(keyword.begin(), keyword.end(), token_.text.begin(), token_.text.end(), same);
  }
  bool begins_group() const { return is_sign("{") || is_word("subgraph"); }

  [[noreturn]] void fail_expecting(const std::string& what) {
    throw NotDot{token_.where,
                 {either<Finding::expected_before_hyphen, Finding::expected_in_graph>(is_sign("-")), what}};
  }
  void expect(const char* text) {
    if (!is_sign(text)) fail_expecting(std::string("'") + text + "'");
    step();
  }

  DotValue identifier() {
    if (token_.kind == DotToken::Kind::sign || token_.kind == DotToken::Kind::end) fail_expecting("a name");
    const bool quoted = token_.kind == DotToken::Kind::quoted;
    DotValue result{std::move(token_.text), token_.where};
    step();
    while (quoted && is_sign("+")) {
      step();
      if (token_.kind != DotToken::Kind::quoted) fail_expecting("a text in quotes");
      result.text += token_.text;
      result.where.end = token_.where.end;
      step();
    }
    return result;
  }

  /// Layout is for the eye: only what begins with pal_ is kept.
  void keep(const DotValue& name, DotValue value, DotValues& to) {
    if (!name.text.starts_with("pal_")) return;
    if (is_dot_attribute(name.text)) {
      to.set(name.text, std::move(value));
    } else if (strange_.insert(name.text).second && strange_.size() <= most_strange) {
      report_strange_attribute(name, diagnostics_);
    }
  }

  /// `[a=b, c=d][e=f]`; an attribute without a value is `true`.
  void attributes(DotValues& to) {
    while (is_sign("[")) {
      step();
      while (!is_sign("]")) {
        const DotValue name = identifier();
        DotValue value{"true", name.where};
        if (is_sign("=")) {
          step();
          value = identifier();
        }
        keep(name, std::move(value), to);
        if (is_sign(",") || is_sign(";")) step();
      }
      step();
    }
  }

  /// A list in braces with the defaults that hold in it; gives the nodes that it names.
  Ends statements(Defaults defaults, int depth) {
    if (depth > deepest_nesting) throw NotDot{token_.where, {Finding::subgraphs_nested_too_deeply}};
    Ends all;
    std::set<std::size_t> seen;
    expect("{");
    while (!is_sign("}")) {
      if (is_word("node") || is_word("edge") || is_word("graph")) {
        DotValues of_subgraph;
        DotValues& to = is_word("node")   ? defaults.node
                        : is_word("edge") ? defaults.edge
                        : depth == 0      ? graph_.values
                                          : of_subgraph;
        step();
        attributes(to);
      } else {
        for (const std::size_t end : statement(defaults, depth)) {
          if (seen.insert(end).second) all.push_back(end);
        }
      }
      if (is_sign(";")) step();
    }
    step();
    return all;
  }

  /// `a = b`, `a [ … ]`, `a -> b -> c [ … ]` or a subgraph.
  Ends statement(const Defaults& defaults, int depth) {
    const SourceSpan begin = token_.where;
    if (!begins_group()) {
      const DotValue name = identifier();
      if (is_sign("=")) {
        step();
        DotValue value = identifier();
        if (depth == 0) keep(name, std::move(value), graph_.values);
        return {};
      }
      const std::size_t first = node(name, defaults);
      port();
      if (!is_sign("->") && !is_sign("--")) {
        describe(first, name.where);
        return {first};
      }
      return edges({first}, begin, defaults, depth);
    }
    Ends ends = group(defaults, depth);
    return is_sign("->") || is_sign("--") ? edges(std::move(ends), begin, defaults, depth) : ends;
  }

  Ends end_of_edge(const Defaults& defaults, int depth, SourceSpan& where) {
    if (begins_group()) return group(defaults, depth);
    const DotValue name = identifier();
    where.end = name.where.end;
    const std::size_t at = node(name, defaults);
    port();
    return {at};
  }

  /// From the first end on; all edges of one statement have the same attributes.
  Ends edges(Ends from, SourceSpan where, const Defaults& defaults, int depth) {
    const auto values = std::make_shared<DotValues>(defaults.edge);
    Ends all = from;
    while (is_sign("->") || is_sign("--")) {
      if (is_sign("--")) throw NotDot{token_.where, {Finding::edge_without_direction}};
      step();
      Ends to = end_of_edge(defaults, depth, where);
      if (from.size() * to.size() > most_dot_edges - graph_.edges.size()) {
        throw NotDot{where, {Finding::too_many_edges, most_dot_edges}};
      }
      for (const std::size_t a : from) {
        for (const std::size_t b : to) graph_.edges.push_back({a, b, where, values});
      }
      all.insert(all.end(), to.begin(), to.end());
      from = std::move(to);
    }
    attributes(*values);
    return all;
  }

  Ends group(const Defaults& defaults, int depth) {
    if (is_word("subgraph")) {
      step();
      if (!is_sign("{")) name_group(identifier());
    }
    return statements(defaults, depth + 1);
  }

  /// To Graphviz a second subgraph of one name is the first one again, with all that was in it.
  void name_group(const DotValue& name) {
    if (!groups_.insert(name.text).second) throw NotDot{name.where, {Finding::subgraph_twice}};
  }

  void port() {
    for (int i = 0; i < 2 && is_sign(":"); ++i) {
      step();
      identifier();
    }
  }

  std::size_t node(const DotValue& name, const Defaults& defaults) {
    const auto [found, fresh] = index_.emplace(name.text, graph_.nodes.size());
    if (fresh) {
      if (graph_.nodes.size() == most_dot_nodes) {
        throw NotDot{name.where, {Finding::too_many_nodes, most_dot_nodes}};
      }
      graph_.nodes.push_back({name.text, name.where, defaults.node});
    }
    return found->second;
  }

  void describe(std::size_t at, SourceSpan where) {
    if (!is_sign("[")) return;
    DotNode& it = graph_.nodes[at];
    it.where = where;
    attributes(it.values);
  }

  static constexpr std::size_t most_strange = 20;

  DotLexer lexer_;
  Diagnostics& diagnostics_;
  DotToken token_;
  DotGraph graph_;
  std::unordered_map<std::string, std::size_t> index_;
  std::set<std::string> groups_;
  std::set<std::string> strange_;
};

}  // namespace

const DotValue* DotValues::find(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : found->second.get();
}

bool DotValues::is_true(std::string_view name) const {
  const DotValue* value = find(name);
  return value != nullptr && value->text == "true";
}

void DotValues::set(std::string_view name, DotValue value) {
  values_.insert_or_assign(std::string(name), std::make_shared<const DotValue>(std::move(value)));
}

std::optional<DotGraph> read_dot(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  try {
    return DotParser(file, sources.text(file), diagnostics).parse();
  } catch (const NotDot& problem) {
    diagnostics.report(problem.what, problem.where);
    return std::nullopt;
  }
}

}  // namespace pal::syntax
