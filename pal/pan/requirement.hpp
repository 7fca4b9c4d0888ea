// What a skill must keep, whatever its environment (docs/reference/timing.md gives the measures).
#pragma once

#include <cstdint>
#include <optional>
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

/// From a device's event, or a message, to the effect of the next of `at` that it causes. `of`: the channels
/// on which the party sends that message.
struct Response {
  std::vector<ChannelId> of;
  std::vector<StatementRef> at;
};
/// The subject of an age or a reaction: a condition, or what a device measures, given by the channels on
/// which it sends that message.
using Known = std::variant<ConditionId, std::vector<ChannelId>>;

/// From the SPC, or the device's sample, whose value a statement was decided on to that statement's effect.
struct Age {
  Known of;
  std::vector<StatementRef> at;
};
/// From a change in the world, just missed by an SPC or a sample, to the effect of the first of `at` that
/// reflects it.
struct Reaction {
  Known of;
  std::vector<StatementRef> at;
};
/// Between successive effects of `at`. The limit field of the requirement is not used.
struct Passes {
  std::vector<StatementRef> at;
  std::optional<Duration> least;
  std::optional<Duration> most;
};
/// Frames, events or answers of a device that no thread takes: of any `in` successive ones at most `most`.
struct Loss {
  std::variant<ModuleId, DeviceId> of;
  int most = 0;
  int in = 1;
};
/// From the start of the skill to its completion with this code.
struct Completing {
  int code = 0;
};
/// The greatest long-run fraction of time in which a processor is busy. The limit and the bound are
/// nanoseconds of work in a second. `processor` empty: each one.
struct Load {
  std::string processor;
};
/// How long a processor can be busy without a pause. `processor` empty: each one.
struct BusyPeriod {
  std::string processor;
};

using Measure = std::variant<Response, Age, Reaction, Passes, Loss, Completing, Load, BusyPeriod>;

/// The part of each run that is measured (docs/reference/timing.md).
struct Phase {
  std::vector<StatementRef> after;   // from when one of these is first done
  std::vector<StatementRef> during;  // or while a thread is in one of these loops, named by their REPEAT
  std::string text;                  // "after TXM( motion to MC1 ) in SM1"
};

struct Requirement {
  std::string name;
  Measure measure;
  Duration limit{};
  std::optional<Phase> phase;  // without: the whole run
  SourceSpan where;
};

}  // namespace pal::pan
