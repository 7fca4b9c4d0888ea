// A run as a chart shows it: lanes with bars and waits, arrows between them, conditions as waveforms. Plain
// data, the same for every size and style of picture, and what tests compare.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pal/trace/trace.hpp"

namespace pal::analyzer::chart {

enum class BarKind : std::uint8_t {
  computation,  // an activity
  message,      // WTM, TXM
  condition,    // SPC, RPC, CASE, UNTIL
  serving,      // a device is busy
};

/// An action on its processor, or a device at work. to_ns >= from_ns; equal if it costs nothing.
struct Bar {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  BarKind kind = BarKind::computation;
  std::string text;    // the statement, or what the device serves
  std::string module;  // in whose body the statement stands
  std::string file;
  int line = 0;
  bool resumed = false;  // goes on with a statement that was preempted
  bool finished = true;  // has its effect at to_ns; otherwise it is preempted, blocked, cancelled or open
};

enum class GapKind : std::uint8_t {
  waiting,  // for a message, a free slot, blocks or the start
  ready,    // could run, but its processor is taken
};

/// A stretch in which a thread does not run although it has not ended.
struct Gap {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  GapKind kind = GapKind::waiting;
  std::string text;      // what it waits for: "Zforce from LS1"; ready: the statement
  bool gave_up = false;  // the time of a WITHIN ran out
};

/// A thread or a device. Bars and gaps are in order of time and do not overlap.
struct Lane {
  std::string name;
  bool device = false;
  std::string processor;  // of a thread
  int priority = 0;
  std::vector<Bar> bars;
  std::vector<Gap> gaps;
};

enum class Fate : std::uint8_t { taken, dropped, undelivered };

/// A message: from the instant at which it was put to the beginning of the action that takes it, or to its
/// drop. An undelivered one has no receiver, and to_ns is the end of the run.
struct Arrow {
  std::size_t from_lane = 0;
  std::int64_t from_ns = 0;
  std::int64_t to_lane = -1;  // -1: none
  std::int64_t to_ns = 0;
  std::int64_t taken_ns = 0;  // the instant at which the slot was free again
  std::string message;
  Fate fate = Fate::taken;
};

/// An instant at which a condition was set or read, with the value that it got or had.
struct Sample {
  std::int64_t at_ns = 0;
  bool value = false;
  std::int64_t lane = -1;  // of the thread that set or read it
};

/// A condition that is set or read in the run: FALSE until its first set.
struct Waveform {
  std::string name;
  std::vector<Sample> sets;
  std::vector<Sample> reads;
};

enum class MarkKind : std::uint8_t { event, overrun, gave_up, cancelled, completion, fault, broken };

/// Something that happens at one instant. `lane` -1: to the skill as a whole.
struct Mark {
  std::int64_t at_ns = 0;
  MarkKind kind = MarkKind::event;
  std::int64_t lane = -1;
  std::string text;
};

/// Lanes are grouped by processor, each device a group of its own, in an order that keeps the arrows short.
struct Timeline {
  std::string skill;
  std::string environment;
  std::string origin;
  std::int64_t end_ns = 0;
  std::vector<Lane> lanes;
  std::vector<Arrow> arrows;
  std::vector<Waveform> waveforms;
  std::vector<Mark> marks;
};

/// The timeline of a run. The same trace gives the same timeline.
Timeline timeline(const trace::Trace& trace);

/// A stable text of the part of a timeline that touches [from_ns, to_ns], a line an item; golden tests
/// compare it.
std::string dump(const Timeline& timeline, std::int64_t from_ns, std::int64_t to_ns);
std::string dump(const Timeline& timeline);

}  // namespace pal::analyzer::chart
