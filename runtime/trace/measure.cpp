#include "runtime/trace/measure.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "runtime/trace/inheritance.hpp"

namespace pal::trace {
namespace {

/// By statement of the trace: whether it is one of `at`.
std::vector<bool> marked(const Trace& trace, const std::vector<StatementName>& at) {
  std::vector<bool> marks;
  for (const Statement& statement : trace.statements) {
    const StatementName name{statement.module, statement.text, statement.line};
    marks.push_back(std::find(at.begin(), at.end(), name) != at.end());
  }
  return marks;
}

bool has_effect_at(const Event& event, const std::vector<bool>& marks) {
  return event.kind == Kind::done && event.statement >= 0 && marks[static_cast<std::size_t>(event.statement)];
}

template <class Value>
void inherit(Inheritance& inheritance, const Event& event, std::vector<Value>& of_actor) {
  const std::int32_t parent = inheritance.begins(event);
  if (parent >= 0)
    of_actor[static_cast<std::size_t>(event.actor)] = of_actor[static_cast<std::size_t>(parent)];
}

/// The events of one device that wait for their answer, and who carries which.
class Causes {
 public:
  Causes(const Trace& trace, const std::string& device, const std::string& message)
      : carried_(trace.actors.size()) {
    for (const Channel& channel : trace.channels) {
      from_device_.push_back(channel.sender == device && channel.message == message);
    }
  }

  std::vector<std::optional<std::size_t>>& carried() { return carried_; }
  bool is_source(const Event& event) const {
    return event.subject >= 0 && from_device_[static_cast<std::size_t>(event.subject)];
  }

  void put(const Event& event) {
    if (is_source(event)) {
      births_.push_back(event.time_ns);
      answered_.push_back(false);
      on_message_[event.value] = births_.size() - 1;
    } else if (event.actor >= 0) {
      on_message_[event.value] = carried_[static_cast<std::size_t>(event.actor)];
    }
  }

  void take(const Event& event) {
    const auto found = on_message_.find(event.value);
    // An event that was answered is carried no further: the thread keeps the one that it has.
    if (found != on_message_.end() && found->second && !answered_[*found->second] && event.actor >= 0) {
      carried_[static_cast<std::size_t>(event.actor)] = found->second;
    }
  }

  /// The birth of the event that `actor` answers now, if it carries one that is still unanswered.
  std::optional<std::int64_t> answer(std::int32_t actor) {
    const auto cause = carried_[static_cast<std::size_t>(actor)];
    if (!cause || answered_[*cause]) return std::nullopt;
    for (std::size_t i = 0; i < *cause; ++i) {
      if (!answered_[i]) ++passed_over_;
      answered_[i] = true;
    }
    answered_[*cause] = true;
    return births_[*cause];
  }

  int passed_over() const { return passed_over_; }

 private:
  std::vector<bool> from_device_;                                  // by channel
  std::vector<std::int64_t> births_;                               // by event
  std::vector<bool> answered_;                                     // by event
  std::map<std::int32_t, std::optional<std::size_t>> on_message_;  // by serial number
  std::vector<std::optional<std::size_t>> carried_;                // by actor
  int passed_over_ = 0;
};

}  // namespace

std::vector<Occurrence> ages(const Trace& trace, const std::string& condition,
                             const std::vector<StatementName>& at) {
  const std::vector<bool> marks = marked(trace, at);
  const auto found = std::find(trace.conditions.begin(), trace.conditions.end(), condition);
  const auto subject = static_cast<std::int32_t>(found - trace.conditions.begin());
  Inheritance inheritance(trace);
  std::vector<std::optional<std::int64_t>> read(trace.actors.size());
  std::int64_t set = 0;
  std::vector<Occurrence> result;
  for (const Event& event : trace.events) {
    inherit(inheritance, event, read);
    if (event.kind == Kind::set && event.subject == subject) set = event.time_ns;
    if (event.actor < 0) continue;
    auto& birth = read[static_cast<std::size_t>(event.actor)];
    if (event.kind == Kind::read && event.subject == subject) birth = set;
    if (has_effect_at(event, marks) && birth) {
      result.push_back({*birth, event.time_ns, event.actor, event.statement});
    }
  }
  return result;
}

Responses responses(const Trace& trace, const std::string& device, const std::string& message,
                    const std::vector<StatementName>& at) {
  const std::vector<bool> marks = marked(trace, at);
  Inheritance inheritance(trace);
  Causes causes(trace, device, message);
  Responses result;
  for (const Event& event : trace.events) {
    inherit(inheritance, event, causes.carried());
    if (event.kind == Kind::put) causes.put(event);
    if (event.kind == Kind::take) causes.take(event);
    if (event.kind == Kind::overrun && causes.is_source(event)) ++result.missed;
    if (!has_effect_at(event, marks)) continue;
    if (const auto birth = causes.answer(event.actor)) {
      result.answered.push_back({*birth, event.time_ns, event.actor, event.statement});
    }
  }
  result.missed += causes.passed_over();
  return result;
}

const Occurrence* longest(const std::vector<Occurrence>& occurrences) {
  const auto found = std::max_element(
      occurrences.begin(), occurrences.end(),
      [](const Occurrence& a, const Occurrence& b) { return a.length_ns() < b.length_ns(); });
  return found == occurrences.end() ? nullptr : &*found;
}

}  // namespace pal::trace
