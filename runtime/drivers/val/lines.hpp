// Commands as lines of VAL, and answers out of VAL's text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runtime/drivers/val/command.hpp"

namespace pal::runtime::val {

/// The line of a command, without its end; empty for `clear`. Whole numbers are written as the thesis has
/// them, others with up to three decimals. Not sent is what no line can say: `problem` tells why then.
struct LineOf {
  std::string line;
  std::string problem;
};
LineOf line_of(const Command& command);

/// How long its answer may take: a motion `motion`, a delay its own time and `plain`, but no longer than a
/// motion.
Time answer_time(const Command& command, Time plain, Time motion);

/// The answer in what VAL showed between the line's end and the prompt (or the question of POINT).
Answer read_answer(const Command& command, std::string_view shown);

}  // namespace pal::runtime::val
