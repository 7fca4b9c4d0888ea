// Changes of a program's text that may mend its timing. They are proposals: whether the program is still
// right, and in time, has to be checked afterwards.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::rewrite {

/// All `edits` are to be made, in one file.
struct Rewriting {
  std::string title;   // what it does, for people: "wait for motion request before pc-force is read"
  std::string module;  // empty: it changes the skill's template
  SourceSpan where;    // the first statement that it changes
  std::vector<Edit> edits;
};

/// For places where a condition is read or tested just before a wait for a message: the wait moves in front.
/// If the wait stands at the beginning of arms of the CASE that tests the condition, it moves out of them.
/// `text`: of the tree's file.
std::vector<Rewriting> read_after_wait(const syntax::Tree& tree, std::string_view text);

/// For places where a condition is set from a sensor's answer, just before a wait for a message. The wait
/// moves in front of the request for the answer. So the condition does not grow old during the wait.
std::vector<Rewriting> set_after_wait(const syntax::Tree& tree, std::string_view text);

/// For loops that request something and then wait for it: the first request moves before the loop, and each
/// next one behind the wait. The server then works meanwhile: a courier.
std::vector<Rewriting> ask_ahead(const syntax::Tree& tree, std::string_view text);

/// For requirements of `skill`: the phase (by their names, "DURING REPEAT OF …") is put behind them.
std::vector<Rewriting> limit_to_phase(const syntax::Tree& tree, const std::string& skill,
                                      const std::map<std::string, std::string>& phases);

}  // namespace pal::rewrite
