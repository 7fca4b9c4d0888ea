#include "pal/trace/meter.hpp"

#include <algorithm>
#include <utility>

#include "trace/requests.hpp"

namespace pal::trace {
namespace {

constexpr std::size_t usual_births = 64;

/// By channel: whether it is of requests that are answered.
Marks asked(const std::vector<std::int32_t>& request_of) {
  Marks marks(request_of.size());
  for (const std::int32_t request : request_of)
    if (request >= 0) marks[static_cast<std::size_t>(request)] = true;
  return marks;
}

}  // namespace

// Intervals.

std::optional<Occurrence> IntervalMeter::see(const Event& event) {
  if (!has_effect_at(event, at_)) return std::nullopt;
  const auto before = std::exchange(last_, event.time_ns);
  if (!before) return std::nullopt;
  return Occurrence{*before, event.time_ns, event.actor, event.statement};
}

// Responses.

ResponseMeter::ResponseMeter(const Trace& tables, Marks channels, Marks at)
    : channels_(std::move(channels)),
      at_(std::move(at)),
      request_(requests_of(tables)),
      asks_(asked(request_)),
      device_(devices_of(tables)),
      on_message_(tables.channels.size()),
      serving_(room_for_requests<Birth>(request_)),
      carried_(tables.actors.size()) {
  awaiting_.reserve(usual_births);
}

ResponseMeter::Reading ResponseMeter::see(const Event& event, std::int32_t parent) {
  inherit(event, parent, carried_);
  Reading reading;
  switch (event.kind) {
    case Kind::put:
      put(event);
      break;
    case Kind::take:
      take(event);
      break;
    case Kind::drop:
      drop(event);
      break;
    case Kind::overrun:
      answered_request(event);
      if (is_source(event) && counts_from_ != none_counts) reading = {std::nullopt, 1, event.time_ns};
      break;
    default:
      if (has_effect_at(event, at_)) return answer(event);
  }
  return reading;
}

bool ResponseMeter::is_awaiting(const Birth& birth) const {
  const Birth* found = first_after(birth.number - 1);
  return birth.number > 0 && found != nullptr && found->number == birth.number;
}

const ResponseMeter::Birth* ResponseMeter::awaiting(std::int64_t after) const {
  return counts_from_ == none_counts ? nullptr : first_after(std::max(after, counts_from_ - 1));
}

const ResponseMeter::Birth* ResponseMeter::first_after(std::int64_t after) const {
  const auto found =
      std::upper_bound(awaiting_.begin(), awaiting_.end(), after,
                       [](std::int64_t number, const Birth& birth) { return number < birth.number; });
  return found == awaiting_.end() ? nullptr : &*found;
}

/// What was carried by the request that the device answers with this event: the oldest that it has taken.
ResponseMeter::Birth ResponseMeter::answered_request(const Event& event) {
  const std::int32_t request = request_[static_cast<std::size_t>(event.subject)];
  if (request < 0 || !is_device(event.actor)) return {};
  return take_first(serving_[static_cast<std::size_t>(request)], Birth{});
}

/// Of what does not count: it can change nothing any more.
void ResponseMeter::forget_what_nobody_carries() {
  const auto carries = [](const std::vector<Birth>& list, std::int64_t number) {
    return std::any_of(list.begin(), list.end(),
                       [number](const Birth& each) { return each.number == number; });
  };
  std::erase_if(awaiting_, [&](const Birth& birth) {
    return birth.number < counts_from_ && !carries(on_message_, birth.number) &&
           !carries(carried_, birth.number) &&
           std::none_of(serving_.begin(), serving_.end(),
                        [&](const std::vector<Birth>& list) { return carries(list, birth.number); });
  });
}

void ResponseMeter::put(const Event& event) {
  const Birth asked_by = answered_request(event);
  if (is_source(event)) {
    on(event) = {++births_, event.time_ns};
    if (awaiting_.size() == awaiting_.capacity()) forget_what_nobody_carries();
    awaiting_.push_back(on(event));
  } else {
    on(event) = is_device(event.actor) ? asked_by : carried_[static_cast<std::size_t>(event.actor)];
  }
}

/// An event that was answered is carried no further: the thread keeps the one that it has.
void ResponseMeter::take(const Event& event) {
  if (is_device(event.actor)) {
    const auto channel = static_cast<std::size_t>(event.subject);
    if (asks_[channel]) serving_[channel].push_back(on(event));
  } else if (is_awaiting(on(event))) {
    carried_[static_cast<std::size_t>(event.actor)] = on(event);
  }
}

/// One that is withdrawn before it is taken awaits nothing.
void ResponseMeter::drop(const Event& event) {
  if (event.actor >= 0) {
    if (event.value != unasked) answered_request(event);
  } else if (is_source(event)) {
    std::erase_if(awaiting_, [&](const Birth& birth) { return birth.number == on(event).number; });
  }
}

ResponseMeter::Reading ResponseMeter::answer(const Event& event) {
  const Birth cause = carried_[static_cast<std::size_t>(event.actor)];
  if (!is_awaiting(cause)) return {};
  const auto place = std::find_if(awaiting_.begin(), awaiting_.end(),
                                  [&cause](const Birth& birth) { return birth.number == cause.number; });
  Reading reading;
  if (cause.number < counts_from_) {
    awaiting_.erase(place);
    return reading;
  }
  const auto first = std::find_if(awaiting_.begin(), place,
                                  [this](const Birth& birth) { return birth.number >= counts_from_; });
  reading.answered = Occurrence{cause.time_ns, event.time_ns, event.actor, event.statement};
  reading.missed = static_cast<int>(place - first);
  if (reading.missed > 0) reading.last_missed_ns = std::prev(place)->time_ns;
  awaiting_.erase(first, place + 1);
  return reading;
}

}  // namespace pal::trace
