#include "pal/trace/measure.hpp"

#include <algorithm>

#include "pal/trace/inheritance.hpp"

namespace pal::trace {
namespace {

Marks statements_named(const Trace& trace, const std::vector<StatementName>& at) {
  Marks marks;
  for (const Statement& statement : trace.statements) {
    const StatementName name{statement.module, statement.text, statement.line};
    marks.push_back(std::find(at.begin(), at.end(), name) != at.end());
  }
  return marks;
}

Marks channels_of(const Trace& trace, const std::string& sender, const std::string& message) {
  Marks marks;
  for (const Channel& channel : trace.channels)
    marks.push_back(channel.sender == sender && channel.message == message);
  return marks;
}

}  // namespace

std::vector<Occurrence> ages(const Trace& trace, const std::string& condition,
                             const std::vector<StatementName>& at) {
  const auto found = std::find(trace.conditions.begin(), trace.conditions.end(), condition);
  Inheritance inheritance(trace);
  AgeMeter meter(trace, static_cast<std::int32_t>(found - trace.conditions.begin()),
                 statements_named(trace, at));
  std::vector<Occurrence> result;
  for (const Event& event : trace.events) {
    if (const auto age = meter.see(event, inheritance.begins(event))) result.push_back(*age);
  }
  return result;
}

Responses responses(const Trace& trace, const std::string& sender, const std::string& message,
                    const std::vector<StatementName>& at) {
  Inheritance inheritance(trace);
  ResponseMeter meter(trace, channels_of(trace, sender, message), statements_named(trace, at));
  Responses result;
  for (const Event& event : trace.events) {
    const ResponseMeter::Reading reading = meter.see(event, inheritance.begins(event));
    if (reading.answered) result.answered.push_back(*reading.answered);
    result.missed += reading.missed;
  }
  return result;
}

const Occurrence* longest(const std::vector<Occurrence>& occurrences) {
  const auto found = std::max_element(
      occurrences.begin(), occurrences.end(),
      [](const Occurrence& a, const Occurrence& b) { return a.length_ns() < b.length_ns(); });
  return found == occurrences.end() ? nullptr : &*found;
}

}  // namespace pal::trace
