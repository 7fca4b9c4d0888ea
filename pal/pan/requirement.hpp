// What a skill must keep, whatever its environment (docs/timing.md gives the measures).
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "pal/pan/ids.hpp"
#include "pal/support/source.hpp"
#include "pal/support/time.hpp"

namespace pal::pan {

/// A statement of a module's body. A requirement "at TXM( motion to MC1 )" means every such statement.
struct StatementRef {
  ModuleId module;
  NodeId node;
};

/// From a device's event to the effect of the next of `at` that it causes.
struct Response {
  ChannelId event;
  std::vector<StatementRef> at;
};
/// From the SPC whose value a statement was decided on to that statement's effect.
struct Age {
  ConditionId condition;
  std::vector<StatementRef> at;
};
/// The greatest long-run fraction of time in which a processor is busy. The limit and the bound are
/// nanoseconds of work in a second. `processor` empty: each one.
struct Load {
  std::string processor;
};

using Measure = std::variant<Response, Age, Load>;

struct Requirement {
  std::string name;
  Measure measure;
  Duration limit{};
  SourceSpan where;
};

}  // namespace pal::pan
