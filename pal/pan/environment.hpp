// A workcell as a skill meets it: processors, devices, placement and times (docs/reference/language.md,
// ENVIRONMENT).
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pal/support/source.hpp"
#include "pal/support/time.hpp"

namespace pal::pan {

struct Processor {
  std::string name;
  bool preemptive = true;
  SourceSpan where;
};

/// Sends `message` every `period`, each late by up to `jitter`; sporadic: `period` is the least separation.
/// The skill's first wait for it opens the device. The first message comes within one period of that wait, or
/// at `phase` if given. `answer`, if named, is due `answer_within` after the event.
struct EventDevice {
  std::string message;
  Duration period{};
  Duration jitter{};
  bool sporadic = false;
  std::optional<Duration> phase;
  std::string answer;
  std::optional<Duration> answer_within;
};

/// Answers a request after `answer`, or, if it `may_fail`, not at all; serves one at a time.
struct RequestDevice {
  Interval answer;
  bool may_fail = false;
};

/// Runs freely: a frame starts every `period` and is collected for `collecting` <= period. A request that is
/// pending when a frame starts gets that frame at its end.
struct FrameDevice {
  Duration period{};
  Duration collecting{};
  std::optional<Duration> phase;
};

/// Also for a module without a body: its name stands for the device that it drives.
struct DeviceTiming {
  std::string device;
  std::variant<EventDevice, RequestDevice, FrameDevice> behaviour;
  SourceSpan where;
};

/// Where a thread runs. `thread` is a module ("SM1") or one of its blocks ("SM1.2"). A block without a place
/// runs where its module does. The greater priority goes first; among equals first come, first served.
struct Placement {
  std::string thread;
  std::string processor;
  int priority = 0;
  SourceSpan where;
};

struct ActivityTime {
  std::string activity;
  std::string module;  // empty: wherever the activity stands
  Interval time;
  SourceSpan where;
};

/// Processor time of the statements that are not activities. A test is a CASE, an UNTIL with conditions, or a
/// WTM that gives up.
struct Costs {
  Interval send, receive, set, read, test;
};

/// From a send's effect to the moment the receiver can have the message.
struct Latency {
  Interval within_processor, between_processors;
};

/// What the environment has for skills to use (thesis, section 2.3.3: SEC = {SD, LS, RM, GS}), by name. A
/// list that is given is complete; a list that is not given says nothing.
struct Resources {
  using List = std::optional<std::vector<std::string>>;
  List sensor_drivers;
  List logical_sensors;
  List machine_controllers;
  List skills;
};

struct Environment {
  std::string name;
  std::vector<std::string> descriptions;
  std::vector<Processor> processors;
  std::vector<DeviceTiming> devices;
  std::vector<Placement> placements;
  std::vector<ActivityTime> activities;
  Costs costs;
  Latency latency;
  SourceSpan where;
  Resources resources;
};

}  // namespace pal::pan
