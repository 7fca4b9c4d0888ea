// The values of a measure in a run, read off its trace alone. The same for predicted and measured runs, and
// independent of the proof of a bound (docs/reference/timing.md defines the measures).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pal/trace/meter.hpp"
#include "pal/trace/spool.hpp"
#include "pal/trace/trace.hpp"

namespace pal::trace {

/// A statement, by its name, which is the same in every trace of one program.
struct StatementName {
  std::string module;
  std::string text;
  int line = 0;

  friend bool operator==(const StatementName&, const StatementName&) = default;
};

/// Ages of `condition` at each effect of a statement of `at`, in order of time. An age is the time from the
/// set whose value the thread had last read (time 0 if there was none) to the effect. Effects before any read
/// have no age.
std::vector<Occurrence> ages(const Trace& trace, const std::string& condition,
                             const std::vector<StatementName>& at);

struct Responses {
  std::vector<Occurrence> answered;  // from the event to the effect that answered it
  int missed = 0;                    // events lost by overrun, or passed over: a later one was answered first
};

/// Responses to the message `message` that `sender`, a device or a module, puts, at the effects of the
/// statements of `at`. A message that is withdrawn before it is taken awaits no response.
Responses responses(const Trace& trace, const std::string& sender, const std::string& message,
                    const std::vector<StatementName>& at);

/// The longest of these ages, and of the answered responses: the first of several, nothing if there is none.
/// The events come from `events`; of `tables` only the tables count.
std::optional<Occurrence> longest_age(const Trace& tables, const EventSource& events,
                                      const std::string& condition, const std::vector<StatementName>& at);
std::optional<Occurrence> longest_response(const Trace& tables, const EventSource& events,
                                           const std::string& sender, const std::string& message,
                                           const std::vector<StatementName>& at);

/// The longest; the first of several. Null if there is none.
const Occurrence* longest(const std::vector<Occurrence>& occurrences);

}  // namespace pal::trace
