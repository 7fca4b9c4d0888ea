// The log of an operation: a line of JSON a step.
#pragma once

#include <iosfwd>
#include <string>

#include "operations/executor.hpp"

namespace pal::operations {

/// {"step", "icon", "skill", "parameters", "kind", "code", "reason", "begin_s", "end_s"} on one line without
/// its end. A delay has no skill, parameters, kind, code and reason. Times are those of the cell.
std::string log_line(const Step& step);

/// Writes each step as it ends, so that a log that breaks off is whole up to there.
class StepLog final : public StepObserver {
 public:
  explicit StepLog(std::ostream& out) : out_(out) {}
  void done(const Step& step) override;

 private:
  std::ostream& out_;
};

}  // namespace pal::operations
