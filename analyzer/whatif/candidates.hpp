// Changes of an environment that may mend a requirement, before any is tried.
#pragma once

#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer::whatif {

/// One change of an environment.
struct Change {
  enum class Kind { new_processor, priority, processor, period };
  Kind kind = Kind::priority;
  std::string of;     // the processor that is new; else the thread, or the device
  std::string value;  // "3", "P4", "20 ms"; none of a new processor

  bool operator==(const Change&) const = default;
};

/// As change() reads it: "PROCESSOR P4", "SM1.priority = 3".
std::string text(const Change& change);

/// For people: "add processor P4", "give SM1 priority 3".
std::string words(const Change& change);

/// Changes that belong together.
using Changes = std::vector<Change>;

/// The candidates, those that ask least of an engineer first. Each thread goes before or behind the others of
/// its processor. Each thread goes to another processor, or to one more. Each event or frame comes less
/// often. `problem` is of this environment.
std::vector<Changes> candidates_for(const Problem& problem, const pan::Environment& environment);

}  // namespace pal::analyzer::whatif
