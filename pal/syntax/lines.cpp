#include "pal/syntax/lines.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "pal/syntax/words.hpp"

namespace pal::syntax {

namespace {

using Parser = grammar::PalParser;

bool indents(std::size_t rule) {
  switch (rule) {
    case Parser::RuleStatements:
    case Parser::RuleArm:
    case Parser::RuleWaitArm:
    case Parser::RuleHeading:
    case Parser::RuleSlot:
    case Parser::RuleItem:
      return true;
    default:
      return false;
  }
}

bool begins_line(std::size_t rule) {
  switch (rule) {
    case Parser::RuleUnit:
    case Parser::RuleHeading:
    case Parser::RuleSlot:
    case Parser::RuleItem:
    case Parser::RuleStatement:
    case Parser::RuleArm:
    case Parser::RuleWaitArm:
      return true;
    default:
      return false;
  }
}

/// Reserved words that have a line of their own, or begin one.
bool is_divider(std::size_t type) {
  switch (type) {
    case Parser::BEGIN:
    case Parser::END:
    case Parser::END_CASE:
    case Parser::END_CONCURRENT:
    case Parser::END_WTM:
    case Parser::ELSE:
    case Parser::UNTIL:
      return true;
    default:
      return false;
  }
}

/// A token, and whether a line of canonical PAL begins with it.
struct Item {
  PlacedToken at;
  bool begins_line = false;
  int depth = 0;
};

/// The tokens of a parse tree, in the order of the text, without the end of the file.
class Walk {
 public:
  std::vector<Item> run(Parser::FileContext* root) {
    visit(root, 0);
    return std::move(items_);
  }

 private:
  void visit(antlr4::ParserRuleContext* context, int depth) {
    const auto rule = context->getRuleIndex();
    if (indents(rule)) ++depth;
    const auto first = items_.size();
    for (auto* child : context->children) {
      if (auto* leaf = dynamic_cast<antlr4::tree::TerminalNode*>(child)) {
        const auto* token = leaf->getSymbol();
        if (token->getType() == antlr4::Token::EOF) continue;
        items_.push_back({{token, context}, is_divider(token->getType()), depth});
      } else if (auto* inner = dynamic_cast<antlr4::ParserRuleContext*>(child)) {
        visit(inner, depth);
      }
    }
    if (begins_line(rule) && first < items_.size()) items_[first].begins_line = true;
  }

  std::vector<Item> items_;
};

class Divider {
 public:
  Divider(const Reading& reading, std::string_view text) : reading_(reading), text_(text) {}

  std::vector<Line> run() {
    const auto items = Walk().run(reading_.root());
    Position position;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const auto* previous = i == 0 ? nullptr : &items[i - 1];
      auto gap = gap_before(previous, items[i].at.token);
      if (items[i].begins_line) {
        begin_line(items[i], std::move(gap));
        position = {};
      } else {
        lines_.back().words.back().comments = std::move(gap.comments);
      }
      add_word(items[i], items[i].begins_line ? nullptr : previous, position);
    }
    end_file(items.empty() ? nullptr : &items.back());
    return std::move(lines_);
  }

 private:
  struct Position {
    std::size_t words = 0;
    std::size_t cell = 0;
  };

  Gap gap_before(const Item* previous, const antlr4::Token* token) const {
    const auto begin = previous == nullptr ? 0 : reading_.tokens().span(previous->at.token).end;
    const auto end = reading_.tokens().span(token).begin;
    return read_gap(text_.substr(begin, end - begin), previous == nullptr);
  }

  void begin_line(const Item& item, Gap gap) {
    Line line;
    line.depth = item.depth;
    line.table = table_of(item.at);
    take_comments(line, gap);
    line.blank_before = gap.blank_before_token;
    const bool blank = blank_is_due(item);
    auto& first_blank = line.comments.empty() ? line.blank_before : line.comments.front().blank_before;
    const bool has_blank = line.blank_before || std::any_of(line.comments.begin(), line.comments.end(),
                                                            [](const auto& c) { return c.blank_before; });
    if (blank && !has_blank) first_blank = true;
    if (lines_.empty() || (opens_ && !begins_unit(item))) first_blank = false;
    if (is_closer(item)) line.blank_before = false;
    column_ = gap.token_column;
    opens_ = opens(item);
    lines_.push_back(std::move(line));
  }

  /// Comments before the next line: the first may stand behind the line before.
  void take_comments(Line& line, const Gap& gap) {
    for (const auto& comment : gap.comments) {
      if (comment.trailing) {
        lines_.back().trailing = comment.text;
      } else {
        line.comments.push_back({comment.text, depth_of(comment, line, gap), comment.blank_before});
      }
    }
  }

  /// A comment before what ends or divides a block is of the block if it stands further right.
  int depth_of(const Comment& comment, const Line& next, const Gap& gap) const {
    if (lines_.empty() || comment.column <= gap.token_column) return next.depth;
    const int inner = lines_.back().depth + (opens_ ? 1 : 0);
    const bool innermost = opens_ ? comment.column > column_ : comment.column >= column_;
    return std::max(next.depth, innermost ? inner : std::min(inner, next.depth + 1));
  }

  /// Units that are long, or of another sort than the one before, stand apart.
  bool blank_is_due(const Item& item) {
    if (!begins_unit(item)) return false;
    const auto type = item.at.token->getType();
    const auto previous = std::exchange(last_unit_, type);
    const bool apart = type == Parser::HEADER || type == Parser::SKILL || type == Parser::ENVIRONMENT;
    return apart || type != previous;
  }

  static bool begins_unit(const Item& item) {
    return item.depth == 0 && !is_divider(item.at.token->getType());
  }

  static bool is_closer(const Item& item) {
    const auto type = item.at.token->getType();
    if (type == Parser::BEGIN) return item.at.in->getRuleIndex() == Parser::RuleModuleUnit;
    return is_divider(type);
  }

  /// Something inside it begins after this line.
  static bool opens(const Item& item) {
    switch (item.at.token->getType()) {
      case Parser::BEGIN:
      case Parser::REPEAT:
      case Parser::CASE:
      case Parser::CONCURRENT:
      case Parser::ELSE:
      case Parser::HEADER:
        return true;
      case Parser::SKILL:
        return item.at.in->getRuleIndex() == Parser::RuleSkillUnit;
      case Parser::ENVIRONMENT:
        return true;
      case Parser::WTM:
        return dynamic_cast<const Parser::WaitWithinContext*>(item.at.in) != nullptr ||
               dynamic_cast<const Parser::WaitForFirstContext*>(item.at.in) != nullptr;
      case Parser::LEFT:  // an arm
        return true;
      default:
        return false;
    }
  }

  void add_word(const Item& item, const Item* previous, Position& position) {
    auto& line = lines_.back();
    auto word = word_of(item.at, previous == nullptr ? nullptr : &previous->at);
    if (previous != nullptr) {
      const auto cell = cell_of(line.table, position.words, item.at, previous->at);
      if (cell > position.cell) word.cell = position.cell = cell;
    }
    ++position.words;
    line.words.push_back(std::move(word));
  }

  void end_file(const Item* last) {
    const auto gap = gap_before(last, reading_.tokens().all().back());
    Line end;
    Gap at_left = gap;
    at_left.token_column = 0;  // whatever stands before the end
    take_comments(end, at_left);
    if (end.comments.empty()) return;
    if (lines_.empty()) end.comments.front().blank_before = false;
    lines_.push_back(std::move(end));
  }

  const Reading& reading_;
  std::string_view text_;
  std::vector<Line> lines_;
  std::size_t column_ = 0;  // in the text, of the line before
  bool opens_ = false;      // the line before
  std::size_t last_unit_ = 0;
};

}  // namespace

std::vector<Line> lines_of(const Reading& reading, std::string_view text) {
  return Divider(reading, text).run();
}

}  // namespace pal::syntax
