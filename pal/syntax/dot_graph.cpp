#include "pal/syntax/dot_graph.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "pal/syntax/parse.hpp"

namespace pal::syntax {

namespace {

struct Token {
  enum class Kind { word, text, sign, end };
  Kind kind = Kind::end;
  std::string text;
  SourceSpan where;
};

/// Ends the reading; caught in this file.
struct NotDot {
  SourceSpan where;
  std::string message;
};

class Lexer {
 public:
  Lexer(FileId file, std::string_view text) : file_(file), text_(text) {}

  Token next() {
    skip();
    const std::size_t begin = at_;
    if (at_ == text_.size()) return {Token::Kind::end, "", span(begin)};
    const char c = text_[at_];
    if (c == '"') return quoted();
    if (c == '<') return html();
    if (in_word(c)) {
      while (at_ < text_.size() && in_word(text_[at_])) ++at_;
      return {Token::Kind::word, std::string(text_.substr(begin, at_ - begin)), span(begin)};
    }
    at_ += text_.substr(at_, 2) == "->" || text_.substr(at_, 2) == "--" ? 2 : 1;
    if (at_ == begin + 1 && c == '-') {
      while (at_ < text_.size() && in_word(text_[at_])) ++at_;
      return {Token::Kind::word, std::string(text_.substr(begin, at_ - begin)), span(begin)};
    }
    return {Token::Kind::sign, std::string(text_.substr(begin, at_ - begin)), span(begin)};
  }

 private:
  static bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' ||
           static_cast<unsigned char>(c) > 127;
  }
  SourceSpan span(std::size_t begin) const {
    return {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
  }
  void skip() {
    while (at_ < text_.size()) {
      const bool line_begins = at_ == 0 || text_[at_ - 1] == '\n';
      if (std::isspace(static_cast<unsigned char>(text_[at_]))) {
        ++at_;
      } else if (text_.substr(at_, 2) == "//" || (text_[at_] == '#' && line_begins)) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (text_.substr(at_, 2) == "/*") {
        const std::size_t begin = at_;
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) {
          at_ += 2;
          throw NotDot{span(begin), "this comment has no end"};
        }
        at_ = end + 2;
      } else {
        return;
      }
    }
  }
  Token quoted() {
    const std::size_t begin = at_++;
    std::string value;
    while (at_ < text_.size() && text_[at_] != '"') {
      if (text_[at_] == '\\' && at_ + 1 < text_.size() && (text_[at_ + 1] == '"' || text_[at_ + 1] == '\n')) {
        ++at_;
        if (text_[at_] == '"') value += '"';
      } else {
        value += text_[at_];
      }
      ++at_;
    }
    if (at_ == text_.size()) {
      at_ = begin + 1;
      throw NotDot{span(begin), "this text has no closing quote"};
    }
    ++at_;
    return {Token::Kind::text, std::move(value), span(begin)};
  }
  Token html() {
    const std::size_t begin = at_;
    std::size_t depth = 0;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '<') ++depth;
      if (text_[at_] == '>' && --depth == 0) {
        ++at_;
        return {Token::Kind::text, std::string(text_.substr(begin, at_ - begin)), span(begin)};
      }
    }
    at_ = begin + 1;
    throw NotDot{span(begin), "this '<' has no '>'"};
  }

  FileId file_;
  std::string_view text_;
  std::size_t at_ = 0;
};

class DotParser {
 public:
  DotParser(FileId file, std::string_view text) : lexer_(file, text) { step(); }

  DotGraph parse() {
    if (word("strict")) step();
    graph_.where = token_.where;
    if (word("graph")) throw NotDot{token_.where, "the graph has no directions: 'digraph' is needed"};
    if (!word("digraph")) throw NotDot{token_.where, "'digraph' is expected"};
    step();
    if (!sign("{")) identifier();
    statements(Defaults(), 0);
    if (token_.kind != Token::Kind::end) throw NotDot{token_.where, "after the graph nothing is expected"};
    return std::move(graph_);
  }

 private:
  struct Defaults {
    DotValues node, edge;
  };
  using Ends = std::vector<std::size_t>;

  void step() { token_ = lexer_.next(); }
  bool sign(std::string_view text) const { return token_.kind == Token::Kind::sign && token_.text == text; }
  /// Keywords are read in any case.
  bool word(std::string_view keyword) const {
    return token_.kind == Token::Kind::word && token_.text.size() == keyword.size() &&
           std::equal(keyword.begin(), keyword.end(), token_.text.begin(),
                      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
  }
  void expect(const char* text) {
    if (!sign(text)) throw NotDot{token_.where, std::string("'") + text + "' is expected"};
    step();
  }

  DotValue identifier() {
    if (token_.kind != Token::Kind::word && token_.kind != Token::Kind::text)
      throw NotDot{token_.where, "a name is expected"};
    DotValue result{token_.text, token_.where};
    const bool text = token_.kind == Token::Kind::text;
    step();
    while (text && sign("+")) {
      step();
      if (token_.kind != Token::Kind::text) throw NotDot{token_.where, "a text is expected after '+'"};
      result.text += token_.text;
      result.where.end = token_.where.end;
      step();
    }
    return result;
  }

  void attributes(DotValues& to) {
    while (sign("[")) {
      step();
      while (!sign("]")) {
        const DotValue name = identifier();
        expect("=");
        to[name.text] = identifier();
        if (sign(",") || sign(";")) step();
      }
      step();
    }
  }

  Ends statements(Defaults defaults, int depth) {
    if (depth > deepest_nesting) throw NotDot{token_.where, "subgraphs are nested too deeply"};
    Ends all;
    expect("{");
    while (!sign("}")) {
      if (word("node") || word("edge") || word("graph")) {
        DotValues inner;
        DotValues& to = word("node")   ? defaults.node
                        : word("edge") ? defaults.edge
                        : depth == 0   ? graph_.values
                                       : inner;
        step();
        attributes(to);
      } else {
        const Ends ends = statement(defaults, depth);
        all.insert(all.end(), ends.begin(), ends.end());
      }
      if (sign(";")) step();
    }
    step();
    return all;
  }

  Ends statement(const Defaults& defaults, int depth) {
    const SourceSpan begin = token_.where;
    bool subgraph = sign("{") || word("subgraph");
    Ends ends;
    if (!subgraph) {
      const DotValue name = identifier();
      if (sign("=")) {
        step();
        const DotValue value = identifier();
        if (depth == 0) graph_.values[name.text] = value;
        return {};
      }
      ends = {node(name, defaults)};
      port();
    } else {
      ends = group(defaults, depth);
    }
    const std::size_t first_edge = graph_.edges.size();
    Ends all = ends;
    while (sign("->") || sign("--")) {
      if (sign("--")) throw NotDot{token_.where, "'->' is expected: the graph has directions"};
      step();
      SourceSpan where = begin;
      Ends next;
      if (sign("{") || word("subgraph")) {
        next = group(defaults, depth);
      } else {
        const DotValue name = identifier();
        where.end = name.where.end;
        next = {node(name, defaults)};
        port();
      }
      // Groups at both ends make an edge of every pair; no module's graph has use for many.
      if (ends.size() * next.size() > 10000) throw NotDot{where, "this makes too many edges"};
      for (const std::size_t from : ends) {
        for (const std::size_t to : next) graph_.edges.push_back({from, to, where, defaults.edge});
      }
      all.insert(all.end(), next.begin(), next.end());
      ends = std::move(next);
      subgraph = true;
    }
    DotValues given;
    attributes(given);
    if (!subgraph) {
      for (auto& [name, value] : given) graph_.nodes[ends.front()].values[name] = value;
    }
    for (std::size_t i = first_edge; i < graph_.edges.size(); ++i) {
      for (const auto& [name, value] : given) graph_.edges[i].values[name] = value;
    }
    return all;
  }

  Ends group(const Defaults& defaults, int depth) {
    if (word("subgraph")) {
      step();
      if (!sign("{")) identifier();
    }
    return statements(defaults, depth + 1);
  }

  void port() {
    for (int i = 0; i < 2 && sign(":"); ++i) {
      step();
      identifier();
    }
  }

  std::size_t node(const DotValue& name, const Defaults& defaults) {
    const auto [found, fresh] = index_.emplace(name.text, graph_.nodes.size());
    if (fresh) graph_.nodes.push_back({name.text, name.where, defaults.node});
    return found->second;
  }

  Lexer lexer_;
  Token token_;
  DotGraph graph_;
  std::map<std::string, std::size_t> index_;
};

}  // namespace

std::optional<DotGraph> parse_dot_graph(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  try {
    return DotParser(file, sources.text(file)).parse();
  } catch (const NotDot& problem) {
    diagnostics.report(Code::PAL0114, problem.where, problem.message,
                       "write the graph as 'digraph NAME { … }'");
    return std::nullopt;
  }
}

}  // namespace pal::syntax
