#include "analyzer/runs/concrete_run.hpp"

#include <algorithm>

namespace pal::analyzer {

ConcreteRun::ConcreteRun(const Machine& machine, bool record)
    : machine_(machine),
      record_(record),
      timers_(static_cast<std::size_t>(machine.timer_count())),
      serials_(machine.problem().channels.size()),
      current_(machine.problem().channels.size()) {}

Nanoseconds ConcreteRun::worked(int timer, Nanoseconds when) const {
  const Timer& of = timers_[static_cast<std::size_t>(timer)];
  return of.frozen ? of.worked : of.worked + (when - of.since);
}

void ConcreteRun::begin(Choices& choices) {
  outcome_ = machine_.initial(choices, record_);
  apply(-1);
}

bool ConcreteRun::fire(int timer, Nanoseconds now, Choices& choices) {
  Outcome outcome;
  if (!machine_.fire(state_, timer, choices, record_, outcome)) return false;
  outgrown_ = outgrown_ || outcome.too_many;
  if (outgrown_) return false;
  outcome_ = std::move(outcome);
  now_ = now;
  apply(timer);
  return true;
}

void ConcreteRun::apply(int fired) {
  started_.clear();
  if (fired >= 0) timers_[static_cast<std::size_t>(fired)] = {};
  for (const TimerChange& change : outcome_.changes) {
    Timer& timer = timers_[static_cast<std::size_t>(change.timer)];
    switch (change.kind) {
      case TimerChange::Kind::start:
        timer = {true, false, change.range, change.range.best, 0, now_};
        started_.push_back(change.timer);
        break;
      case TimerChange::Kind::stop:
        timer = {};
        break;
      case TimerChange::Kind::freeze:
        timer.worked += now_ - timer.since;
        timer.frozen = true;
        break;
      case TimerChange::Kind::resume:
        timer.frozen = false;
        timer.since = now_;
        break;
    }
  }
  record();
  for (std::size_t i = 0; i < outcome_.measured.size(); ++i) {
    const int origin = outcome_.measured[i];
    const Nanoseconds born = origin == Outcome::born_now ? now_ : births_[static_cast<std::size_t>(origin)];
    measured_.push_back({now_ - born, born, now_, outcome_.measured_steps[i]});
  }
  if (outcome_.lost >= 0) measured_.push_back({outcome_.lost, now_, now_, {}});
  std::vector<Nanoseconds> births;
  for (int origin : outcome_.origin) {
    births.push_back(origin == Outcome::born_now ? now_ : births_[static_cast<std::size_t>(origin)]);
  }
  births_ = std::move(births);
  state_ = outcome_.state;
}

void ConcreteRun::record() {
  for (trace::Event event : outcome_.events) {
    event.time_ns = now_;
    const auto channel = static_cast<std::size_t>(event.subject < 0 ? 0 : event.subject);
    if (event.kind == trace::Kind::put || (event.kind == trace::Kind::drop && event.actor >= 0)) {
      event.value = ++serials_[channel];
      if (event.kind == trace::Kind::put) current_[channel] = event.value;
    } else if (event.kind == trace::Kind::take || event.kind == trace::Kind::drop) {
      event.value = current_[channel];
    }
    events_.push_back(event);
  }
}

trace::Trace empty_trace(const Problem& problem) {
  trace::Trace trace;
  trace.skill = problem.skill;
  trace.environment = problem.environment;
  trace.origin = "predicted";
  for (const Thread& thread : problem.threads) {
    const std::string& processor = problem.processors[thread.processor].name;
    trace.actors.push_back({thread.name, false, processor, thread.priority, thread.parent.value});
  }
  for (const Device& device : problem.devices)
    trace.actors.push_back(
        {device.name, true, "", 0, -1, std::holds_alternative<pan::EventDevice>(device.behaviour)});
  for (const Statement& statement : problem.statements) {
    trace.statements.push_back({statement.module, statement.text, statement.file, statement.line});
  }
  for (const ChannelId c : problem.channels.ids()) {
    const ChannelId channel = c;
    trace.channels.push_back(
        {sender_name(problem, channel), problem.channels[c].message, receiver_name(problem, channel)});
  }
  trace.conditions.assign(problem.conditions.begin(), problem.conditions.end());
  return trace;
}

/// Behind all events of the instant, but before the device's next frame.
std::size_t ConcreteRun::place_of_end(int device, Nanoseconds at) const {
  const auto later = [](Nanoseconds time, const trace::Event& event) { return time < event.time_ns; };
  const auto behind = std::upper_bound(events_.begin(), events_.end(), at, later);
  auto place = behind;
  for (auto event = behind; event != events_.begin() && std::prev(event)->time_ns == at;) {
    --event;
    if (event->kind == trace::Kind::busy && event->actor == device) place = event;
  }
  return static_cast<std::size_t>(place - events_.begin());
}

trace::Trace ConcreteRun::trace() const {
  trace::Trace trace = empty_trace(machine_.problem());
  // A frame that no thread wanted is collected all the same; the machine does not follow it.
  std::vector<std::pair<std::size_t, trace::Event>> ends;  // each before the event of this number
  for (const DeviceId d : machine_.problem().devices.ids()) {
    const auto* frames = std::get_if<pan::FrameDevice>(&machine_.problem().devices[d].behaviour);
    if (frames == nullptr) continue;
    const auto actor = static_cast<int>(machine_.problem().threads.size() + d.index());
    std::optional<Nanoseconds> begun;
    for (const trace::Event& event : events_) {
      if (event.actor != actor) continue;
      if (event.kind == trace::Kind::idle) begun.reset();
      if (event.kind != trace::Kind::busy) continue;
      if (begun) {
        const Nanoseconds at = *begun + frames->collecting.count();
        ends.emplace_back(place_of_end(actor, at), trace::Event{at, trace::Kind::idle, actor, -1, -1, 0});
      }
      begun = event.time_ns;
    }
  }
  const auto sooner = [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second.time_ns) < std::pair(b.first, b.second.time_ns);
  };
  std::stable_sort(ends.begin(), ends.end(), sooner);
  trace.events.reserve(events_.size() + ends.size());
  auto end = ends.begin();
  for (std::size_t e = 0; e <= events_.size(); ++e) {
    for (; end != ends.end() && end->first == e; ++end) trace.events.push_back(end->second);
    if (e < events_.size()) trace.events.push_back(events_[e]);
  }
  return trace;
}

}  // namespace pal::analyzer
