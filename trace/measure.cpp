#include "pal/trace/measure.hpp"

#include <algorithm>

#include "pal/trace/age_meter.hpp"
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

namespace {

template <class Found>
void find_ages(const Trace& tables, const EventSource& events, const std::string& condition,
               const std::vector<StatementName>& at, Found found) {
  const auto named = std::find(tables.conditions.begin(), tables.conditions.end(), condition);
  Inheritance inheritance(tables);
  AgeMeter meter(ConditionFlow(tables, static_cast<std::int32_t>(named - tables.conditions.begin())),
                 statements_named(tables, at));
  events([&](const Event& event) {
    if (const auto age = meter.see(event, inheritance.begins(event))) found(*age);
  });
}

template <class Found>
void find_responses(const Trace& tables, const EventSource& events, const std::string& sender,
                    const std::string& message, const std::vector<StatementName>& at, Found found) {
  Inheritance inheritance(tables);
  ResponseMeter meter(tables, channels_of(tables, sender, message), statements_named(tables, at));
  events([&](const Event& event) { found(meter.see(event, inheritance.begins(event))); });
}

void keep_longer(std::optional<Occurrence>& longest, const Occurrence& one) {
  if (!longest || longest->length_ns() < one.length_ns()) longest = one;
}

}  // namespace

std::vector<Occurrence> ages(const Trace& trace, const std::string& condition,
                             const std::vector<StatementName>& at) {
  std::vector<Occurrence> result;
  find_ages(trace, events_of(trace), condition, at, [&](const Occurrence& age) { result.push_back(age); });
  return result;
}

Responses responses(const Trace& trace, const std::string& sender, const std::string& message,
                    const std::vector<StatementName>& at) {
  Responses result;
  find_responses(trace, events_of(trace), sender, message, at, [&](const ResponseMeter::Reading& reading) {
    if (reading.answered) result.answered.push_back(*reading.answered);
    result.missed += reading.missed;
  });
  return result;
}

std::optional<Occurrence> longest_age(const Trace& tables, const EventSource& events,
                                      const std::string& condition, const std::vector<StatementName>& at) {
  std::optional<Occurrence> result;
  find_ages(tables, events, condition, at, [&](const Occurrence& age) { keep_longer(result, age); });
  return result;
}

std::optional<Occurrence> longest_response(const Trace& tables, const EventSource& events,
                                           const std::string& sender, const std::string& message,
                                           const std::vector<StatementName>& at) {
  std::optional<Occurrence> result;
  find_responses(tables, events, sender, message, at, [&](const ResponseMeter::Reading& reading) {
    if (reading.answered) keep_longer(result, *reading.answered);
  });
  return result;
}

const Occurrence* longest(const std::vector<Occurrence>& occurrences) {
  const auto found = std::max_element(
      occurrences.begin(), occurrences.end(),
      [](const Occurrence& a, const Occurrence& b) { return a.length_ns() < b.length_ns(); });
  return found == occurrences.end() ? nullptr : &*found;
}

}  // namespace pal::trace
