// What stands between two tokens: comments and blank lines. Private to pal/syntax.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pal::syntax {

struct Comment {
  std::string text;           // from the #, without spaces at its end
  bool trailing = false;      // behind a token on its line
  std::size_t column = 0;     // of the #, from 0, in code points; of one that is not trailing
  bool blank_before = false;  // a blank line stands before it
};

struct Gap {
  std::vector<Comment> comments;
  bool blank_before_token = false;       // between the last comment, or the token before, and the token after
  std::size_t token_column = far_right;  // of the token after, from 0, if it is the first on its line

  static constexpr std::size_t far_right = static_cast<std::size_t>(-1);
};

/// Reads the text between two tokens. `at_start`: no token stands before it.
Gap read_gap(std::string_view text, bool at_start);

}  // namespace pal::syntax
