// Commands as lines of VAL, and answers from VAL's text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/drivers/val/protocol.hpp"

namespace pal::runtime::drivers::val {

/// The line of a command, without its end; empty for `clear`. Whole numbers are written as the thesis writes
/// them, others with up to three decimals. A command that no line can express is not sent; `problem` says
/// why.
struct LineOf {
  std::string line;
  std::string problem;
};
LineOf line_of(const Command& command);

/// The greatest time for its answer: `motion` for a motion; for a delay its own time and `plain`, but no
/// longer than a motion.
Time answer_time(const Command& command, Time plain, Time motion);

/// The answer, from the text that VAL showed between the line's end and the prompt (or the question of
/// POINT).
Answer read_answer(const Command& command, std::string_view shown);

}  // namespace pal::runtime::drivers::val
