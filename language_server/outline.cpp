// What a file is made of: symbols, folds, links, colours.
#include <algorithm>
#include <map>
#include <string>

#include "language_server/semantic_legend.hpp"
#include "language_server/session.hpp"
#include "language_server/text.hpp"
#include "pal/pan/dump.hpp"
#include "pal/syntax/text_tokens.hpp"

namespace pal::language_server {

namespace {

using check::Symbol;
using check::SymbolKind;

/// The protocol's kinds of symbols.
int symbol_kind(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::skill:
      return 5;
    case SymbolKind::module:
      return 2;
    case SymbolKind::device:
      return 11;
    case SymbolKind::message:
      return 23;
    case SymbolKind::field:
      return 8;
    case SymbolKind::condition:
      return 17;
    case SymbolKind::activity:
      return 12;
    case SymbolKind::parameter:
      return 13;
    case SymbolKind::requirement:
      return 24;
    case SymbolKind::contingency:
    case SymbolKind::completion:
      return 22;
    case SymbolKind::environment:
      return 3;
    case SymbolKind::processor:
      return 19;
  }
  return 13;
}

TokenType token_type(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::skill:
      return TokenType::skill;
    case SymbolKind::module:
      return TokenType::module;
    case SymbolKind::device:
      return TokenType::device;
    case SymbolKind::message:
      return TokenType::message;
    case SymbolKind::field:
      return TokenType::field;
    case SymbolKind::condition:
      return TokenType::condition;
    case SymbolKind::activity:
      return TokenType::activity;
    case SymbolKind::parameter:
      return TokenType::parameter;
    case SymbolKind::requirement:
      return TokenType::requirement;
    case SymbolKind::contingency:
    case SymbolKind::completion:
      return TokenType::code;
    case SymbolKind::environment:
      return TokenType::environment;
    case SymbolKind::processor:
      return TokenType::processor;
  }
  return TokenType::skill;
}

std::string shown_name(const Symbol& symbol) {
  if (symbol.kind == SymbolKind::contingency) return "contingency " + symbol.name;
  if (symbol.kind == SymbolKind::completion) return "completion " + symbol.name;
  return symbol.name;
}

}  // namespace

Json Session::document_symbol(const Json& params) {
  const auto path = path_in(params);
  const auto* tree = index_.tree(path);
  const auto text = workspace_.text(path);
  if (tree == nullptr || text == nullptr) return Json::array();
  const auto symbols = check::symbols_of({*tree});
  Json result = Json::array();
  for (const auto& symbol : symbols.all) {
    // A declaration that is not whole yet still holds its name.
    const auto begin = std::min(symbol.where.valid() ? symbol.where.begin : symbol.name_where.begin,
                                symbol.name_where.begin);
    const auto end =
        std::max(symbol.where.valid() ? symbol.where.end : symbol.name_where.end, symbol.name_where.end);
    Json made{{"name", shown_name(symbol)},
              {"kind", symbol_kind(symbol.kind)},
              {"detail", check::name(symbol.kind)},
              {"range", range_of(*text, begin, end)},
              {"selectionRange", range_of(*text, symbol.name_where.begin, symbol.name_where.end)}};
    const bool inside = !symbol.owner.empty() && !result.empty() && result.back()["name"] == symbol.owner;
    if (inside) {
      result.back()["children"].push_back(std::move(made));
    } else {
      result.push_back(std::move(made));
    }
  }
  return result;
}

Json Session::workspace_symbol(const Json& params) {
  const std::string query = capitals(string_of(params, "query"));
  Json result = Json::array();
  constexpr std::size_t most = 500;
  for (const auto& file : workspace_.project()) {
    const auto text = workspace_.text(file.path);
    // Most files do not have the word.
    if (text == nullptr || capitals(text->content()).find(query) == std::string::npos) continue;
    const auto* tree = index_.tree(file.path);
    if (tree == nullptr) continue;
    for (const auto& symbol : check::symbols_of({*tree}).all) {
      if (capitals(symbol.name).find(query) == std::string::npos || result.size() >= most) continue;
      result.push_back({{"name", shown_name(symbol)},
                        {"kind", symbol_kind(symbol.kind)},
                        {"containerName", symbol.owner},
                        {"location", location(symbol.name_where)}});
    }
  }
  return result;
}

Json Session::folding_range(const Json& params) {
  const auto text = workspace_.text(path_in(params));
  if (text == nullptr) return Json::array();
  Json result = Json::array();
  const auto fold = [&](std::size_t begin, std::size_t end, const char* kind) {
    const auto first = text->position(begin).line;
    const auto last = text->position(end).line;
    if (last <= first) return;
    Json made{{"startLine", first}, {"endLine", last}};
    if (kind != nullptr) made["kind"] = kind;
    result.push_back(std::move(made));
  };
  struct Open {
    std::string word;
    std::size_t at;
  };
  std::vector<Open> open;
  std::string before;
  std::size_t comments = std::string::npos, last_comment = 0;
  const auto& content = text->content();
  for (const auto& token : syntax::text_tokens(content)) {
    using Kind = syntax::TextToken::Kind;
    if (token.kind == Kind::comment) {
      const bool next = comments != std::string::npos &&
                        text->position(token.begin).line <= text->position(last_comment).line + 1;
      if (!next) {
        if (comments != std::string::npos) fold(comments, last_comment, "comment");
        comments = token.begin;
      }
      last_comment = token.begin;
      continue;
    }
    const std::string word = capitals(std::string_view(content).substr(token.begin, token.end - token.begin));
    const bool begins_line = text->line(text->position(token.begin).line).find_first_not_of(" \t") ==
                             token.begin - text->offset({text->position(token.begin).line, 0});
    if (word == "END" && !open.empty()) {
      fold(open.back().at, token.begin, nullptr);
      open.pop_back();
    } else if (word == "UNTIL" && !open.empty() && open.back().word == "REPEAT") {
      fold(open.back().at, token.begin, nullptr);
      open.pop_back();
    } else if (before != "END" && begins_line &&
               (word == "BEGIN" || word == "CASE" || word == "CONCURRENT" || word == "REPEAT" ||
                ((word == "SKILL" || word == "ENVIRONMENT") && text->position(token.begin).character == 0))) {
      open.push_back({word, token.begin});
    } else if (before == "WTM" && word == "FIRST") {
      open.push_back({word, token.begin});
    } else if (word == "WITHIN" && !open.empty() && open.back().word != "FIRST" && before == ")") {
      open.push_back({word, token.begin});
    } else if (word == ":" && open.size() == 1 && open.back().word == "SKILL" && before == "MODULE") {
      open.pop_back();  // Skill Module: is no template
    }
    before = word;
  }
  if (comments != std::string::npos) fold(comments, last_comment, "comment");
  return result;
}

Json Session::document_link(const Json& params) {
  const auto path = path_in(params);
  const auto* tree = index_.tree(path);
  const auto text = workspace_.text(path);
  Json result = Json::array();
  if (tree == nullptr || text == nullptr) return result;
  for (const auto& unit : tree->units) {
    const auto* uses = std::get_if<syntax::Uses>(&unit);
    if (uses == nullptr || uses->where.end <= uses->where.begin + 2) continue;
    result.push_back({{"range", range_of(*text, uses->where.begin + 1, uses->where.end - 1)},
                      {"target", workspace_.uri(resolve_path(path, uses->path))}});
  }
  return result;
}

Json Session::semantic_tokens(const Json& params) {
  const auto path = path_in(params);
  const auto text = workspace_.text(path);
  if (text == nullptr) return nullptr;
  const auto family = index_.family(path);
  const FileId file = index_.id(path);
  std::map<std::uint32_t, std::pair<TokenType, bool>> names;
  for (const auto& use : family->symbols.uses) {
    if (use.where.file == file)
      names[use.where.begin] = {token_type(family->symbols.all[use.symbol].kind),
                                use.role == check::UseRole::declaration};
  }
  Json data = Json::array();
  Position last;
  for (const auto& token : syntax::text_tokens(text->content())) {
    using Kind = syntax::TextToken::Kind;
    TokenType type = TokenType::keyword;
    bool declares = false;
    if (const auto named = names.find(token.begin); named != names.end()) {
      std::tie(type, declares) = named->second;
    } else if (token.kind == Kind::number) {
      type = TokenType::number;
    } else if (token.kind == Kind::text) {
      type = TokenType::string;
    } else if (token.kind == Kind::comment) {
      type = TokenType::comment;
    } else if (token.kind != Kind::keyword && token.kind != Kind::contextual) {
      continue;
    }
    const auto at = text->position(token.begin);
    const auto end = text->position(token.end);
    data.push_back(at.line - last.line);
    data.push_back(at.line == last.line ? at.character - last.character : at.character);
    data.push_back(end.character - at.character);
    data.push_back(static_cast<int>(type));
    data.push_back(declares ? 1 : 0);
    last = at;
  }
  return {{"data", std::move(data)}};
}

}  // namespace pal::language_server
