// Errors of the user, and how the program ends.
#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string>

namespace pal::workcell {

enum class ExitStatus : int {
  done = 0,                 // the skill ended normally or with a contingency
  wrong_specification = 1,  // the scene, the skill or a parameter is wrong
  usage = 2,                // bad command line, or a file could not be read or written
  error_completion = 3,     // the skill ended with its error completion
  hung = 4,                 // in real time: code of the skill or of a device did not return
  // 100 and its code: an EXIT of an operation (status_of() in command_line.hpp)
};

/// Ends a command: place, cause, hint (which may be empty).
class Failure : public std::runtime_error {
 public:
  Failure(ExitStatus exit_status, std::string place, std::string cause, std::string hint = {});

  ExitStatus status() const { return status_; }
  /// "workcell: error: PLACE: CAUSE" and, on a second line, the hint.
  void print(std::ostream& out) const;

 private:
  ExitStatus status_;
  std::string place_, cause_, hint_;
};

/// Throws Failure if what was written to `out` did not get there: for commands that then go on for long.
void check_told(std::ostream& out);

}  // namespace pal::workcell
