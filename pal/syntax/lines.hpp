// A file as canonical PAL divides it: lines of words, with the comments around and in them. Private to
// pal/syntax.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pal/syntax/gaps.hpp"
#include "pal/syntax/reading.hpp"

namespace pal::syntax {

/// A token in canonical spelling, as it stands in its line.
struct Word {
  std::string text;
  bool space_before = false;
  bool may_begin_line = false;    // if its line is too long
  std::size_t cell = 0;           // it begins this column of a table; 0: none
  std::vector<Comment> comments;  // after it, inside its line
};

/// Neighbours of one table have their columns aligned. Lines of no table are `none`.
enum class Table {
  none,
  message,
  condition,
  device,
  activity,
  slot,
  completion,
  parameter,
  requirement,
  processor,
  behaviour,
  placement,
  time,
  cost,
  latency
};

struct CommentLine {
  std::string text;
  int depth = 0;
  bool blank_before = false;
};

struct Line {
  std::vector<CommentLine> comments;  // above it
  bool blank_before = false;          // between these and it
  int depth = 0;
  Table table = Table::none;
  std::vector<Word> words;  // none: the end of the file
  std::string trailing;     // a comment behind it; empty: none
};

/// Contract: the reading is complete.
std::vector<Line> lines_of(const Reading& reading, std::string_view text);

}  // namespace pal::syntax
