// A run of a skill as a list of events: the one vocabulary for predicted and for measured runs.
//
// The analyzer writes a trace of the run that it proved to be the worst. The runtime writes a trace of what
// happened. Charts are drawn from either, and one is laid over the other. docs/reference/trace.md describes
// the file form.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "pal/trace/large_pages.hpp"

namespace pal::trace {

enum class Kind : std::uint8_t {
  ready,     // actor can run `statement` but has no processor
  start,     // actor begins or resumes `statement` on its processor
  stop,      // actor is preempted before `statement` has had its effect
  done,      // `statement` has its effect
  block,     // actor waits without a processor; subject: channel (or -1: for its blocks, or for the start)
  give_up,   // a wait WITHIN a time ended without a message; subject: channel
  put,       // actor puts a message into channel `subject`; value: serial number of the message
  take,      // actor takes it; subject: channel, value: serial
  drop,      // a message that is not wanted any more is discarded; subject: channel, value: serial
  overrun,   // a device's event found its channel full; subject: channel
  set,       // condition `subject` becomes `value`
  read,      // condition `subject` was `value`
  busy,      // a device begins to serve a request or to collect a frame
  idle,      // the device is done
  cancel,    // actor, a CONCURRENT block that cannot end, is stopped
  complete,  // the skill ends; value: completion code
  fault,     // the runtime ended the skill; value: index into faults
  broken,    // actor breaks what the environment promises; value: index into promises
};

/// Values of a `drop` of a device, instead of a serial number: it has no answer to a request; it has sent one
/// that nobody asked for.
inline constexpr std::int32_t no_answer = 0, unasked = -1;

/// "ready", "start", …: the spelling in files.
const char* name(Kind kind);

/// `actor`, `statement`, `subject` index the tables of the trace; -1: none. Times are nanoseconds from the
/// start.
struct Event {
  std::int64_t time_ns = 0;
  Kind kind = Kind::start;
  std::int32_t actor = -1;
  std::int32_t statement = -1;
  std::int32_t subject = -1;
  std::int32_t value = 0;

  friend bool operator==(const Event&, const Event&) = default;
};

/// A long run has millions of them.
using Events = std::vector<Event, LargePages<Event>>;

/// A thread, or a device.
struct Actor {
  std::string name;
  bool device = false;
  std::string processor;  // of a thread
  int priority = 0;
  std::int32_t parent = -1;  // of a block of CONCURRENT: the actor whose CONCURRENT begins it
  bool by_itself = false;  // of a device: it answers nothing, whatever its messages are called. Not in files
};

struct Statement {
  std::string module;
  std::string text;  // as in the PAL, in its canonical spelling: "TXM( motion to MC1 )"
  std::string file;
  int line = 0;
};

struct Channel {
  std::string sender;
  std::string message;
  std::string receiver;
};

struct Trace {
  std::string skill;
  std::string environment;
  std::string origin;  // "predicted", "simulated" or "measured"
  std::vector<Actor> actors;
  std::vector<Statement> statements;
  std::vector<Channel> channels;
  std::vector<std::string> conditions;
  std::vector<std::string> faults;
  std::vector<std::string> promises;  // those that were broken, in words; a file without it has none
  Events events;                      // in order of time; events at one instant in order of cause
};

/// Writes the JSON form. The same trace gives the same bytes.
void write_json(const Trace& trace, std::ostream& out);

/// Reads the JSON form. Throws std::runtime_error that says what is wrong and where.
Trace read_json(std::istream& in);

/// Chrome trace-event JSON, as Perfetto and chrome://tracing open it.
void write_chrome(const Trace& trace, std::ostream& out);

}  // namespace pal::trace
