// Faults on demand: what is to go wrong with the lines of a cell, and when.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/drivers/wire.hpp"

namespace pal::sim {

struct PlannedFault {
  enum class Kind {
    dropout,      // nothing more comes from the device
    garble,       // one bit of each parcel that comes from it flips
    late,         // what comes from it comes later by `by`
    late_answer,  // what goes to it arrives later by `by`
    unplug,       // the cable is pulled
    takes,        // from now on a statement takes `by` of its processor: no fault of a line
  };
  runtime::Time at{};  // from the skill's beginning
  std::string device;  // takes: the statement's module
  int statement = 0;   // takes: its line
  Kind kind = Kind::dropout;
  runtime::Time by{};
  int line = 0;  // of the text that it was read from; 0: of none
};

/// A fault of a device that the cell does not have.
class NoSuchDevice final : public std::invalid_argument {
 public:
  NoSuchDevice(const std::string& cause, int line) : std::invalid_argument(cause), line_(line) {}
  int line() const { return line_; }  // PlannedFault::line

 private:
  int line_;
};

/// Where a text of faults is wrong, and why.
struct FaultTextError {
  int line = 0;
  std::string cause;
};

/// One fault a line, `#` begins a comment:
///   at 500 ms force-torque dropout
///   at 1.2 s alter late-answer 25 ms
///   at 2 s SM1:55 takes 40 ms
std::variant<std::vector<PlannedFault>, FaultTextError> read_faults(std::string_view text);

/// Makes the fault happen to the device's line, now. For faults of lines, not of statements.
void bring_about(const PlannedFault& fault, runtime::drivers::Wire& wire);

}  // namespace pal::sim
