// The description of a generated skill for the runtime: plain tables, each row found by its index.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// Processor time or latency: between `best` and `worst`, both attained.
struct Interval {
  Time best{};
  Time worst{};
};

/// One field of a message.
struct Field {
  std::string_view name;
  std::string_view unit;  // canonical spelling; empty: a plain number
  FieldKind kind = FieldKind::number;
  std::size_t count = 1;  // of values: the size of an array
};

struct ProcessorSpec {
  std::string_view name;
  bool preemptive = true;
};

/// A module with a body, or a block of a CONCURRENT.
struct ThreadSpec {
  std::string_view name;
  int processor = 0;
  int priority = 0;
  int parent = -1;      // of a block: the thread with whose CONCURRENT it becomes ready; -1: ready at time 0
  bool can_end = true;  // a block that cannot is cancelled when those that can have ended
};

/// A statement that takes part in a run. `cost`: of a WTM that takes a message, the receive.
struct StatementSpec {
  std::string_view module;
  std::string_view text;
  std::string_view file;
  int line = 0;
  Interval cost;
};

/// One slot for one message on its way. Channels from and to devices have no latency.
struct ChannelSpec {
  std::string_view sender;
  std::string_view message;
  std::string_view receiver;
  std::span<const Field> fields;
  int answer = -1;  // of a request: the channel on which its answer comes
  bool request = false;
  bool from_device = false;
  bool to_device = false;
};

/// What the environment says of a device's times.
struct DeviceTimes {
  enum class Behaviour : std::uint8_t {
    unknown,
    events,      // `message` every `period`, each late by up to `jitter`
    sporadic,    // `message`, `period` apart or more, each late by up to `jitter`
    on_request,  // an answer within `answer`
    frames       // one every `period` is collected for answer.best; requests wait for the next one
  };
  Behaviour behaviour = Behaviour::unknown;
  std::string_view message{};
  Time period{};
  Time jitter{};
  Time phase{-1};  // of events: from the first wait to the first one; negative: any
  Interval answer{};
  bool may_fail = false;  // on_request: a request may have no answer (OR NEVER)
};

/// A requirement on the skill, and what its proof relies on.
struct RequirementSpec {
  enum class Measure : std::uint8_t {
    response,         // from a message that is put into one of `channels` to a statement of `at`
    age,              // of `condition` at a statement of `at`
    sample,           // of what a device says in `channels` at a statement of `at`
    interval,         // between effects of statements of `at`
    duration,         // to the completion `code`
    reaction,         // to a change of `condition`, at a statement of `at`
    sample_reaction,  // to a change of what a device says in `channels`, at a statement of `at`
    loss,             // of `device`, among any `in` in a row; the limits are numbers
    load,             // of each of `processors`; the limits are nanoseconds of work in a second
    busy              // how long each of `processors` has something to do without a pause
  };
  std::string_view name;
  Measure measure = Measure::duration;
  Time least{};
  Time most = Time::max();
  std::span<const int> channels;
  std::span<const int> at;
  int condition = -1;
  int code = 0;
  std::span<const int> threads;  // it relies on these and on the blocks that they begin
  std::span<const int> devices;
  int device = -1;
  int in = 1;
  std::span<const int> processors{};
  // Of a requirement with a phase: it counts from when a statement of `after` was done first, or while a
  // thread is in one of the loops `during` (Thread::within). Without: it is of the whole run.
  std::span<const int> after{};
  std::span<const int> during{};
};

/// What happens to a message that a module keeps. Those are numbered from 0 on.
struct KeptSpec {
  enum class How : std::uint8_t {
    taken,   // from channel `place`
    used,    // by statement `place`, at its effect
    written  // by statement `place`, at its effect
  };
  How how = How::taken;
  int place = 0;
  int kept = 0;
};

struct Latency {
  Interval within_processor;
  Interval between_processors;
};

struct Wiring {
  std::string_view skill;
  std::string_view environment;
  std::span<const ProcessorSpec> processors;
  std::span<const ThreadSpec> threads;
  std::span<const StatementSpec> statements;
  std::span<const ChannelSpec> channels;
  std::span<const std::string_view> conditions;
  std::span<const std::string_view> devices;
  Interval test;  // of a WTM that gives up
  Latency latency;
  std::span<const DeviceTimes> times{};  // one each device; none: nothing is promised
  std::span<const RequirementSpec> requirements{};
  std::span<const KeptSpec> kept{};  // as far as a requirement is about samples
};

}  // namespace pal::runtime
