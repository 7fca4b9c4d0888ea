#include "pal/syntax/layout.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "pal/support/text_width.hpp"

namespace pal::syntax {

namespace {

std::size_t columns_in(std::string_view text) {
  return static_cast<std::size_t>(width(text));
}

std::size_t width_of(const Word& word) {
  return columns_in(word.text) + (word.space_before ? 1 : 0);
}

/// Where each column of a table begins, counted from the lines' indentation; the first, 0, begins there.
using Columns = std::vector<std::size_t>;

bool has_comments_inside(const Line& line) {
  return std::any_of(line.words.begin(), line.words.end(), [](const Word& w) { return !w.comments.empty(); });
}

bool continues_table(const Line& before, const Line& line) {
  return line.table == before.table && line.depth == before.depth && line.comments.empty() &&
         !line.blank_before;
}

Columns columns_of(const Line* first, const Line* last) {
  constexpr std::size_t most = 5;
  Columns starts(most, 0);
  for (std::size_t column = 1; column < most; ++column) {
    for (const auto* line = first; line != last; ++line) {
      std::size_t width = 0;
      for (const auto& word : line->words) {
        if (word.cell == column) starts[column] = std::max(starts[column], width + 1);
        if (word.cell >= column) break;
        width = word.cell != 0 ? starts[word.cell] + columns_in(word.text) : width + width_of(word);
      }
    }
  }
  return starts;
}

/// Lines of text, the comments behind them still apart.
class Page {
 public:
  void blank_line() {
    flush_comments();
    text_ += '\n';
  }

  void comment_line(std::size_t indentation, const std::string& comment) {
    flush_comments();
    text_ += std::string(indentation, ' ') + comment + '\n';
  }

  void line(const std::string& text, const std::string& comment) {
    if (comment.empty()) {
      flush_comments();
      text_ += text + '\n';
    } else {
      commented_.push_back({text, comment});
    }
  }

  std::string finish() {
    flush_comments();
    return std::move(text_);
  }

 private:
  struct Commented {
    std::string text;
    std::string comment;
  };

  void flush_comments() {
    std::size_t widest = 0;
    for (const auto& line : commented_) widest = std::max(widest, columns_in(line.text));
    for (const auto& line : commented_) {
      text_ += line.text + std::string(widest + 2 - columns_in(line.text), ' ') + line.comment + '\n';
    }
    commented_.clear();
  }

  std::string text_;
  std::vector<Commented> commented_;
};

class LineLayout {
 public:
  LineLayout(const Line& line, const Columns& columns, Page& page)
      : line_(line), columns_(columns), page_(page), indentation_(2 * static_cast<std::size_t>(line.depth)) {}

  void run() {
    begin(indentation_);
    for (std::size_t i = 0; i < line_.words.size(); ++i) {
      const auto& word = line_.words[i];
      if (!fresh_ && word.may_begin_line && !fits(i)) {
        page_.line(text_, {});
        go_on();
      }
      put(word);
      for (const auto& comment : word.comments) put(comment);
    }
    page_.line(text_, line_.trailing);
  }

 private:
  static constexpr std::size_t further_in = 4;

  std::size_t start_of(const Word& word) const {
    const auto here = used_ + (word.space_before ? 1 : 0);
    if (word.cell == 0 || broken_) return here;
    return std::max(here, indentation_ + columns_[word.cell]);
  }

  /// Whether what must stay on one line with this word stays within the width; or would not on a line of its
  /// own either.
  bool fits(std::size_t first) const {
    auto width = columns_in(line_.words[first].text);
    for (auto i = first + 1; i < line_.words.size() && !line_.words[i].may_begin_line; ++i) {
      width += width_of(line_.words[i]);
    }
    return start_of(line_.words[first]) + width <= line_width ||
           indentation_ + further_in + width > line_width;
  }

  void go_on() {
    begin(indentation_ + further_in);
    broken_ = true;
  }

  void begin(std::size_t indentation) {
    text_ = std::string(indentation, ' ');
    used_ = indentation;
    fresh_ = true;
  }

  void put(const Word& word) {
    if (!fresh_) {
      const auto start = start_of(word);
      text_.append(start - used_, ' ');
      used_ = start;
    }
    text_ += word.text;
    used_ += columns_in(word.text);
    fresh_ = false;
  }

  void put(const Comment& comment) {
    if (comment.trailing) {
      page_.line(text_, comment.text);
    } else {
      if (!fresh_) page_.line(text_, {});
      page_.comment_line(indentation_ + further_in, comment.text);
    }
    go_on();
  }

  const Line& line_;
  const Columns& columns_;
  Page& page_;
  std::size_t indentation_;
  std::string text_;
  std::size_t used_ = 0;  // columns of text_
  bool fresh_ = true;     // nothing but spaces stands in text_
  bool broken_ = false;   // text_ is not the first line
};

}  // namespace

std::string lay_out(const std::vector<Line>& lines) {
  Page page;
  Columns columns;
  std::size_t end_of_table = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& line = lines[i];
    if (i >= end_of_table) {
      end_of_table = i + 1;
      const auto goes_on = [&](std::size_t k) {
        return line.table != Table::none && k < lines.size() && continues_table(line, lines[k]) &&
               !has_comments_inside(line) && !has_comments_inside(lines[k]);
      };
      while (goes_on(end_of_table)) ++end_of_table;
      columns = columns_of(lines.data() + i, lines.data() + end_of_table);
    }
    for (const auto& comment : line.comments) {
      if (comment.blank_before) page.blank_line();
      page.comment_line(2 * static_cast<std::size_t>(comment.depth), comment.text);
    }
    if (line.blank_before) page.blank_line();
    if (!line.words.empty()) LineLayout(line, columns, page).run();
  }
  return page.finish();
}

}  // namespace pal::syntax
