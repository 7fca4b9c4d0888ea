#include "pal/syntax/spelling.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <vector>

#include "PalParser.h"
#include "pal/support/nearest.hpp"
#include "pal/syntax/token_list.hpp"

namespace pal::syntax {

namespace {

using Parser = grammar::PalParser;

// Keywords stand in the grammar's order: the reserved ones, those that begin a unit, those that are names
// elsewhere.
bool is_keyword_token(std::size_t type) {
  return type >= Parser::WTM && type < Parser::LEFT;
}
bool is_opener(std::size_t type) {
  return type >= Parser::USES && type <= Parser::ENVIRONMENT;
}
bool is_contextual(std::size_t type) {
  return type >= Parser::ACTIVITY && type < Parser::LEFT;
}

const std::map<std::size_t, std::string>& signs() {
  static const std::map<std::size_t, std::string> table{{Parser::LEFT, "'('"},
                                                        {Parser::RIGHT, "')'"},
                                                        {Parser::COLON, "':'"},
                                                        {Parser::SEMICOLON, "';'"},
                                                        {Parser::COMMA, "','"},
                                                        {Parser::EQUAL, "'='"},
                                                        {Parser::STAR, "'*'"},
                                                        {Parser::SLASH, "'/'"},
                                                        {Parser::CARET, "'^'"},
                                                        {Parser::DOT, "'.'"},
                                                        {Parser::PERCENT, "'%'"},
                                                        {Parser::LEFT_BRACKET, "'['"},
                                                        {Parser::RIGHT_BRACKET, "']'"},
                                                        {Parser::NAME, "a name"},
                                                        {Parser::NUMBER, "a number"},
                                                        {Parser::STRING, "a text in quotes"},
                                                        {Parser::END_CASE, "'END CASE'"},
                                                        {Parser::END_CONCURRENT, "'END CONCURRENT'"},
                                                        {Parser::END_WTM, "'END WTM'"},
                                                        {antlr4::Token::EOF, "the end of the file"}};
  return table;
}

}  // namespace

bool begins_statement(std::size_t type) {
  switch (type) {
    case Parser::WTM:
    case Parser::TXM:
    case Parser::SPC:
    case Parser::RPC:
    case Parser::CASE:
    case Parser::REPEAT:
    case Parser::CONCURRENT:
    case Parser::EXECUTE:
    case Parser::DO:
      return true;
    default:
      return false;
  }
}

std::string spelling_of_type(std::size_t type) {
  const auto found = signs().find(type);
  if (found != signs().end()) return found->second;
  if (!is_keyword_token(type)) return {};
  std::vector<antlr4::Token*> none;
  // The symbolic name of a keyword is its spelling in capitals.
  static const antlr4::dfa::Vocabulary& vocabulary = []() -> const antlr4::dfa::Vocabulary& {
    static antlr4::CommonTokenStream* const no_input = nullptr;
    static Parser parser(no_input);
    return parser.getVocabulary();
  }();
  return "'" + vocabulary.getSymbolicName(type) + "'";
}

std::string word_of_type(std::size_t type) {
  switch (type) {
    case Parser::END_CASE:
    case Parser::END_CONCURRENT:
    case Parser::END_WTM:
      return "END";
    default:
      break;
  }
  const auto quoted = spelling_of_type(type);
  return quoted.starts_with("'") ? quoted.substr(1, quoted.size() - 2) : quoted;
}

std::optional<std::size_t> keyword_like(const std::string& word, const std::set<std::size_t>& types) {
  std::string capitals = word;
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::vector<std::string> words;
  for (const auto type : types) {
    if (is_keyword_token(type)) words.push_back(word_of_type(type));
  }
  const bool exact = std::find(words.begin(), words.end(), capitals) != words.end();
  const auto meant = exact ? std::optional(capitals) : nearest(capitals, words);
  if (!meant) return std::nullopt;
  return *std::find_if(types.begin(), types.end(),
                       [&](std::size_t type) { return word_of_type(type) == *meant; });
}

std::string spelling(const antlr4::Token& token) {
  constexpr std::size_t longest = 40;
  const auto type = token.getType();
  const auto text = [&] {
    auto t = token.getText();
    if (t.size() > longest) t = t.substr(0, longest) + "...";
    return t;
  };
  switch (type) {
    case antlr4::Token::EOF:
    case Parser::END_CASE:
    case Parser::END_CONCURRENT:
    case Parser::END_WTM:
      return spelling_of_type(type);
    case Parser::STRING:
    case Parser::OPEN_STRING:
      return "the text " + text();
    default:
      return is_made_up(&token) ? spelling_of_type(type) : "'" + text() + "'";
  }
}

std::string spelling(const antlr4::misc::IntervalSet& expected) {
  std::set<std::size_t> types;
  for (const auto type : expected.toList()) {
    if (type >= 0 || type == -1) types.insert(static_cast<std::size_t>(type));
  }
  std::vector<std::string> words;
  const bool statement = types.contains(Parser::WTM) && types.contains(Parser::DO);
  const bool unit = types.contains(Parser::USES) && types.contains(Parser::HEADER);
  const bool name = types.contains(Parser::NAME) && !statement;
  if (statement) words.emplace_back("a statement");
  if (name) words.emplace_back("a name");
  for (const auto type : types) {
    if (type == Parser::HEADER) continue;  // among the units
    if (statement && (begins_statement(type) || type == Parser::NAME || is_contextual(type))) continue;
    if ((name || statement) && (is_contextual(type) || is_opener(type))) continue;
    if (unit && is_opener(type)) continue;
    if (type == Parser::NAME) continue;
    auto word = spelling_of_type(type);
    if (!word.empty()) words.push_back(std::move(word));
  }
  if (unit) words.emplace_back("the next unit of the file");
  constexpr std::size_t most = 6;
  if (words.empty() || words.size() > most) return {};
  std::string result = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) {
    result += (i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return result;
}

}  // namespace pal::syntax
