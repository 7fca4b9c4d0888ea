#include "runtime/trace/measure.hpp"

#include <algorithm>
#include <deque>
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

/// The messages of one party that await a response, and who carries which.
class Causes {
 public:
  Causes(const Trace& trace, const std::string& sender, const std::string& message)
      : on_message_(trace.channels.size()), served_(trace.channels.size()), carried_(trace.actors.size()) {
    for (const Channel& channel : trace.channels) {
      awaited_.push_back(channel.sender == sender && channel.message == message);
      request_.push_back(request_of(trace, channel));
    }
    for (const Actor& actor : trace.actors) device_.push_back(actor.device);
  }

  std::vector<std::optional<std::size_t>>& carried() { return carried_; }
  bool is_source(const Event& event) const {
    return event.subject >= 0 && awaited_[static_cast<std::size_t>(event.subject)];
  }

  void put(const Event& event) {
    const std::optional<std::size_t> asked_by = answered_request(event);
    if (is_source(event)) {
      births_.push_back(event.time_ns);
      answered_.push_back(false);
      on(event) = births_.size() - 1;
    } else if (is_device(event.actor)) {
      on(event) = asked_by;
    } else {
      on(event) = carried_[static_cast<std::size_t>(event.actor)];
    }
  }

  /// One that is withdrawn before anybody took it awaits nothing.
  void drop(const Event& event) {
    const bool withdrawn = event.actor < 0;
    if (withdrawn && is_source(event) && on(event)) answered_[*on(event)] = true;
    if (!withdrawn) answered_request(event);
  }

  void overrun(const Event& event) { answered_request(event); }

  void take(const Event& event) {
    // An event that was answered is carried no further: the thread keeps the one that it has.
    if (is_device(event.actor)) {
      served_[static_cast<std::size_t>(event.subject)].push_back(on(event));
    } else if (on(event) && !answered_[*on(event)]) {
      carried_[static_cast<std::size_t>(event.actor)] = on(event);
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
  /// The answer of a device carries what its request carried; nothing else that it sends carries anything on.
  static std::optional<std::size_t> request_of(const Trace& trace, const Channel& answer) {
    for (std::size_t c = 0; c < trace.channels.size(); ++c) {
      const Channel& channel = trace.channels[c];
      const bool back = channel.sender == answer.receiver && channel.receiver == answer.sender;
      if (back && channel.message == "request " + answer.message) return c;
    }
    return std::nullopt;
  }

  bool is_device(std::int32_t actor) const { return device_[static_cast<std::size_t>(actor)]; }

  /// What was carried by the request that the device answers with this event: the oldest that it has taken.
  std::optional<std::size_t> answered_request(const Event& event) {
    const auto request = request_[static_cast<std::size_t>(event.subject)];
    if (!is_device(event.actor) || !request || served_[*request].empty()) return std::nullopt;
    const std::optional<std::size_t> carried = served_[*request].front();
    served_[*request].pop_front();
    return carried;
  }

  std::optional<std::size_t>& on(const Event& event) {
    return on_message_[static_cast<std::size_t>(event.subject)];
  }

  std::vector<bool> awaited_;                           // by channel
  std::vector<std::optional<std::size_t>> request_;     // by channel
  std::vector<bool> device_;                            // by actor
  std::vector<std::int64_t> births_;                    // by event
  std::vector<bool> answered_;                          // by event
  std::vector<std::optional<std::size_t>> on_message_;  // by channel: of the last message in its slot
  // By channel: of the requests that its device has taken and not answered yet, the oldest first.
  std::vector<std::deque<std::optional<std::size_t>>> served_;
  std::vector<std::optional<std::size_t>> carried_;  // by actor
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

Responses responses(const Trace& trace, const std::string& sender, const std::string& message,
                    const std::vector<StatementName>& at) {
  const std::vector<bool> marks = marked(trace, at);
  Inheritance inheritance(trace);
  Causes causes(trace, sender, message);
  Responses result;
  for (const Event& event : trace.events) {
    inherit(inheritance, event, causes.carried());
    if (event.kind == Kind::put) causes.put(event);
    if (event.kind == Kind::take) causes.take(event);
    if (event.kind == Kind::drop) causes.drop(event);
    if (event.kind == Kind::overrun) causes.overrun(event);
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
