#include "pal/syntax/token_list.hpp"

#include <utility>

#include "PalParser.h"

namespace pal::syntax {
namespace {

using Parser = grammar::PalParser;

std::unique_ptr<antlr4::Token> copy_of(antlr4::Token* token) {
  return std::make_unique<antlr4::CommonToken>(token);
}

/// Between the token before and `next`, on the line of the former.
std::unique_ptr<antlr4::Token> made_up(std::size_t type, const antlr4::Token* before, antlr4::Token* next) {
  auto token = std::make_unique<antlr4::CommonToken>(next);
  token->setType(type);
  token->setText(" ");
  const auto at = before == nullptr ? next->getStartIndex() : before->getStopIndex() + 1;
  token->setStartIndex(at);
  token->setStopIndex(at - 1);
  if (before != nullptr) token->setLine(before->getLine());
  return token;
}

bool is_end(std::size_t type) {
  return type == Parser::END || type == Parser::END_CASE || type == Parser::END_CONCURRENT ||
         type == Parser::END_WTM;
}

void tell_ends_apart(const std::vector<antlr4::Token*>& all) {
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (!is_end(all[i]->getType())) continue;
    auto* end = static_cast<antlr4::CommonToken*>(all[i]);  // what the lexer's factory makes
    switch (all[i + 1]->getType()) {
      case Parser::CASE:
        end->setType(Parser::END_CASE);
        break;
      case Parser::CONCURRENT:
        end->setType(Parser::END_CONCURRENT);
        break;
      case Parser::WTM:
        end->setType(Parser::END_WTM);
        break;
      default:
        end->setType(Parser::END);
    }
  }
}

void tell_headers_apart(const std::vector<antlr4::Token*>& all) {
  const auto are_kind_words = [](std::size_t first, std::size_t second) {
    switch (first) {
      case Parser::SENSOR:
        return second == Parser::DRIVER;
      case Parser::LOGICAL:
        return second == Parser::SENSOR;
      case Parser::MACHINE:
        return second == Parser::CONTROLLER;
      case Parser::SKILL:
      case Parser::CONTINGENCY:
        return second == Parser::MODULE;
      default:
        return false;
    }
  };
  for (std::size_t i = 0; i + 2 < all.size(); ++i) {
    if (all[i + 2]->getType() != Parser::COLON) continue;
    if (!are_kind_words(all[i]->getType(), all[i + 1]->getType())) continue;
    static_cast<antlr4::CommonToken*>(all[i])->setType(Parser::HEADER);
  }
}

}  // namespace

void tell_words_apart(const std::vector<antlr4::Token*>& all) {
  tell_ends_apart(all);
  tell_headers_apart(all);
}

bool is_made_up(const antlr4::Token* token) {
  if (token->getTokenIndex() == INVALID_INDEX) return true;
  return token->getType() != antlr4::Token::EOF && token->getStopIndex() + 1 == token->getStartIndex();
}

std::vector<std::unique_ptr<antlr4::Token>> copy(const std::vector<antlr4::Token*>& all, std::size_t begin,
                                                 std::size_t end, const Change* change) {
  std::vector<std::unique_ptr<antlr4::Token>> result;
  result.reserve(end - begin + 8);
  const auto last = all.size() - 1;
  for (auto i = begin; i <= end && i <= last; ++i) {
    if (change != nullptr && i == change->at) {
      for (const auto type : change->added) {
        result.push_back(made_up(type, i == 0 ? nullptr : all[i - 1], all[i]));
      }
    }
    if (i == end || i == last) break;
    if (change != nullptr && i >= change->at && i < change->at + change->removed) continue;
    result.push_back(copy_of(all[i]));
  }
  result.push_back(copy_of(all[last]));
  std::vector<antlr4::Token*> seen;
  for (const auto& token : result) seen.push_back(token.get());
  tell_words_apart(seen);
  return result;
}

std::unique_ptr<antlr4::Token> TokenList::nextToken() {
  if (next_ < tokens_.size()) return std::move(tokens_[next_++]);
  return nullptr;
}

}  // namespace pal::syntax
