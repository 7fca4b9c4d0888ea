// The log of an operation: a line of JSON a step.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "operations/executor.hpp"

namespace pal::operations {

/// {"step", "icon", "skill", "parameters", "kind", "code", "reason", "begin_s", "end_s"} on one line without
/// its end, and "figures" if the skill reported some. A wait and a test have "sensor" and "reading", or
/// "readings" if they read several things, instead of skill and parameters; a zero has "sensor" alone; a
/// question has "question" and "answer". A delay has none of these; it has kind, code and reason only if it
/// was stopped. Times are those of the cell.
std::string log_line(const Step& step);

/// The step of a line that log_line() wrote, or of an event of a server, which has the same fields. Nothing:
/// it is not a step.
std::optional<Step> parse_log_line(const std::string& line);

/// For people: "   3  put: palletize ended with code 0 after 5.120 s: The part is at the next place."
std::string told(const Step& step);

/// For people, how an operation stands: "paused before lift after 3 steps", "running at lift after 3 steps",
/// "ended after 4 steps: exit 'done' with code 0". `state` as of name(ExecutionState); `reason` as of
/// Executor.
std::string told(const std::string& state, const std::string& token, std::size_t steps,
                 const std::string& reason);

/// Writes each step as it ends, so a log that breaks off is complete up to there.
class StepLog final : public StepObserver {
 public:
  explicit StepLog(std::ostream& out) : out_(out) {}
  void done(const Step& step) override;

 private:
  std::ostream& out_;
};

}  // namespace pal::operations
