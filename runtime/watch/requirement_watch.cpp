#include "runtime/watch/requirement_watch.hpp"

#include <algorithm>

namespace pal::runtime {
namespace {

trace::Marks marks(std::span<const int> rows, std::size_t size) {
  trace::Marks result(size);
  for (const int row : rows) result[static_cast<std::size_t>(row)] = true;
  return result;
}

}  // namespace

RequirementWatch::RequirementWatch(const Wiring& wiring, const trace::Trace& tables)
    : wiring_(wiring), inheritance_(tables), worst_(wiring.requirements.size()) {
  using Measure = RequirementSpec::Measure;
  for (std::size_t r = 0; r < wiring.requirements.size(); ++r) {
    const RequirementSpec& spec = wiring.requirements[r];
    const trace::Marks at = marks(spec.at, wiring.statements.size());
    const trace::Marks channels = marks(spec.channels, wiring.channels.size());
    switch (spec.measure) {
      case Measure::response:
        watched_.push_back({r, Response{trace::ResponseMeter(tables, channels, at)}});
        break;
      case Measure::age:
        watched_.push_back({r, trace::AgeMeter(tables, spec.condition, at)});
        break;
      case Measure::sample:
        watched_.push_back({r, trace::SampleMeter(tables, channels, at)});
        break;
      case Measure::interval:
        watched_.push_back({r, trace::IntervalMeter(at)});
        break;
      case Measure::duration:
        watched_.push_back({r, Duration{}});
        break;
      case Measure::other:
        break;
    }
  }
  exceeded_.reserve(2 * watched_.size());
}

void RequirementWatch::check(const Watched& watched, const std::optional<trace::Occurrence>& seen) {
  if (!seen) return;
  const Time length(seen->length_ns());
  std::optional<Time>& worst = worst_[watched.requirement];
  worst = !worst                              ? length
          : spec(watched).most == Time::max() ? std::min(*worst, length)
                                              : std::max(*worst, length);
  if (length > spec(watched).most || length < spec(watched).least)
    exceeded_.push_back({watched.requirement, length, seen->actor, seen->statement, false});
}

void RequirementWatch::check(const Watched& watched, Response& response, const trace::Event& event,
                             std::int32_t parent) {
  const trace::ResponseMeter::Reading reading = response.meter.see(event, parent);
  if (reading.missed > 0)
    exceeded_.push_back({watched.requirement, Time::max(), event.actor, event.statement,
                         reading.last_missed_ns <= response.noted_ns});
  if (!reading.answered) return;
  const std::size_t before = exceeded_.size();
  check(watched, reading.answered);
  if (exceeded_.size() > before) exceeded_.back().noted = reading.answered->from_ns <= response.noted_ns;
}

const std::vector<Exceeded>& RequirementWatch::see(const trace::Event& event) {
  exceeded_.clear();
  const std::int32_t parent = inheritance_.begins(event);
  for (Watched& watched : watched_) {
    if (auto* response = std::get_if<Response>(&watched.meter)) {
      check(watched, *response, event, parent);
    } else if (auto* age = std::get_if<trace::AgeMeter>(&watched.meter)) {
      check(watched, age->see(event, parent));
    } else if (auto* sample = std::get_if<trace::SampleMeter>(&watched.meter)) {
      check(watched, sample->see(event, parent));
    } else if (auto* interval = std::get_if<trace::IntervalMeter>(&watched.meter)) {
      check(watched, interval->see(event));
    } else if (std::holds_alternative<Duration>(watched.meter) && event.kind == trace::Kind::complete &&
               event.value == spec(watched).code) {
      check(watched, trace::Occurrence{0, event.time_ns, event.actor, event.statement});
    }
  }
  return exceeded_;
}

Time RequirementWatch::due() const {
  Time due = Time::max();
  for (const Watched& watched : watched_) {
    const auto* response = std::get_if<Response>(&watched.meter);
    if (response == nullptr || spec(watched).most == Time::max()) continue;
    const auto* oldest = response->meter.awaiting(response->noted);
    if (oldest != nullptr) due = std::min(due, Time(oldest->time_ns) + spec(watched).most + Time(1));
  }
  return due;
}

const std::vector<Exceeded>& RequirementWatch::overdue(Time now) {
  exceeded_.clear();
  for (Watched& watched : watched_) {
    auto* response = std::get_if<Response>(&watched.meter);
    if (response == nullptr) continue;
    while (const auto* oldest = response->meter.awaiting(response->noted)) {
      const Time age = now - Time(oldest->time_ns);
      if (age <= spec(watched).most) break;
      exceeded_.push_back({watched.requirement, age, -1, -1, false});
      response->noted = oldest->number;
      response->noted_ns = oldest->time_ns;
    }
  }
  return exceeded_;
}

}  // namespace pal::runtime
