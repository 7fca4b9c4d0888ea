#include "pal/trace/meter.hpp"

#include <algorithm>
#include <utility>

namespace pal::trace {
namespace {

constexpr std::size_t usual_requests = 16;  // of a channel that a device is at work on
constexpr std::size_t usual_births = 64;

bool has_effect_at(const Event& event, const Marks& marks) {
  return event.kind == Kind::done && event.statement >= 0 && marks[static_cast<std::size_t>(event.statement)];
}

/// By channel: the channel of the requests that its messages answer, or -1.
std::vector<std::int32_t> requests_of(const Trace& tables) {
  std::vector<std::int32_t> requests;
  for (const Channel& answer : tables.channels) {
    const auto asks = [&answer](const Channel& channel) {
      return channel.sender == answer.receiver && channel.receiver == answer.sender &&
             channel.message == "request " + answer.message;
    };
    const auto found = std::find_if(tables.channels.begin(), tables.channels.end(), asks);
    requests.push_back(
        found == tables.channels.end() ? -1 : static_cast<std::int32_t>(found - tables.channels.begin()));
  }
  return requests;
}

std::vector<bool> devices_of(const Trace& tables) {
  std::vector<bool> devices;
  for (const Actor& actor : tables.actors) devices.push_back(actor.device);
  return devices;
}

template <class Value>
void inherit(const Event& event, std::int32_t parent, std::vector<Value>& of_actor) {
  if (parent >= 0)
    of_actor[static_cast<std::size_t>(event.actor)] = of_actor[static_cast<std::size_t>(parent)];
}

/// One list a channel; those of requests that are answered have room.
template <class Value>
std::vector<std::vector<Value>> room_for_requests(const std::vector<std::int32_t>& request_of) {
  std::vector<std::vector<Value>> lists(request_of.size());
  for (const std::int32_t request : request_of)
    if (request >= 0) lists[static_cast<std::size_t>(request)].reserve(usual_requests);
  return lists;
}

/// By channel: whether it is of requests that are answered.
Marks asked(const std::vector<std::int32_t>& request_of) {
  Marks marks(request_of.size());
  for (const std::int32_t request : request_of)
    if (request >= 0) marks[static_cast<std::size_t>(request)] = true;
  return marks;
}

/// The first of the list, which is removed; otherwise `none`.
template <class Value>
Value take_first(std::vector<Value>& list, Value none) {
  if (list.empty()) return none;
  const Value first = list.front();
  list.erase(list.begin());
  return first;
}

}  // namespace

// Ages of a condition.

std::optional<Occurrence> AgeMeter::see(const Event& event, std::int32_t parent) {
  inherit(event, parent, read_);
  if (event.kind == Kind::set && event.subject == condition_) set_ = event.time_ns;
  if (event.actor < 0) return std::nullopt;
  auto& birth = read_[static_cast<std::size_t>(event.actor)];
  if (event.kind == Kind::read && event.subject == condition_) birth = set_;
  if (!birth || !has_effect_at(event, at_)) return std::nullopt;
  return Occurrence{*birth, event.time_ns, event.actor, event.statement};
}

// Ages of samples.

SampleMeter::SampleMeter(const Trace& tables, Marks channels, Marks at)
    : channels_(std::move(channels)),
      at_(std::move(at)),
      request_(requests_of(tables)),
      asks_(asked(request_)),
      device_(devices_of(tables)),
      marks_(tables.actors.size()),
      put_(tables.channels.size()),
      answered_(tables.actors.size()),
      serving_(room_for_requests<std::int64_t>(request_)),
      on_message_(tables.channels.size()),
      on_condition_(tables.conditions.size()),
      known_(tables.actors.size()) {}

void SampleMeter::newer(std::int32_t actor, const Instant& instant) {
  Instant& known = known_[static_cast<std::size_t>(actor)];
  if (instant && (!known || *known < *instant)) known = instant;
}

std::optional<Occurrence> SampleMeter::see(const Event& event, std::int32_t parent) {
  inherit(event, parent, known_);
  if (event.actor < 0) return std::nullopt;
  const auto actor = static_cast<std::size_t>(event.actor);
  const auto subject = static_cast<std::size_t>(event.subject);
  switch (event.kind) {
    case Kind::put:
    case Kind::drop:
    case Kind::overrun: {
      Instant said = known_[actor];
      if (device_[actor]) {
        const std::int32_t request = request_[subject];
        said = event.time_ns;
        if (request >= 0) said = take_first(serving_[static_cast<std::size_t>(request)], event.time_ns);
        if (!channels_[subject]) said.reset();
        answered_[actor] = event.time_ns;
      }
      if (event.kind == Kind::put) put_[subject] = event.time_ns;
      if (event.kind == Kind::put) on_message_[subject] = said;
      break;
    }
    case Kind::take:
      if (device_[actor]) {
        if (asks_[subject])
          serving_[subject].push_back(marks_[actor] ? event.time_ns
                                                    : std::max(put_[subject], answered_[actor]));
      } else {
        newer(event.actor, on_message_[subject]);
      }
      break;
    case Kind::busy:
      marks_[actor] = true;
      break;
    case Kind::set:
      on_condition_[subject] = known_[actor];
      break;
    case Kind::read:
      newer(event.actor, on_condition_[subject]);
      break;
    default:
      break;
  }
  if (!known_[actor] || !has_effect_at(event, at_)) return std::nullopt;
  return Occurrence{*known_[actor], event.time_ns, event.actor, event.statement};
}

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
      if (is_source(event)) reading = {std::nullopt, 1, event.time_ns};
      break;
    default:
      if (has_effect_at(event, at_)) return answer(event);
  }
  return reading;
}

bool ResponseMeter::is_awaiting(const Birth& birth) const {
  const Birth* found = awaiting(birth.number - 1);
  return birth.number > 0 && found != nullptr && found->number == birth.number;
}

const ResponseMeter::Birth* ResponseMeter::awaiting(std::int64_t after) const {
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

void ResponseMeter::put(const Event& event) {
  const Birth asked_by = answered_request(event);
  if (is_source(event)) {
    on(event) = {++births_, event.time_ns};
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
    answered_request(event);
  } else if (is_source(event)) {
    std::erase_if(awaiting_, [&](const Birth& birth) { return birth.number == on(event).number; });
  }
}

ResponseMeter::Reading ResponseMeter::answer(const Event& event) {
  const Birth cause = carried_[static_cast<std::size_t>(event.actor)];
  if (!is_awaiting(cause)) return {};
  const auto older = [&cause](const Birth& birth) { return birth.number < cause.number; };
  Reading reading;
  reading.answered = Occurrence{cause.time_ns, event.time_ns, event.actor, event.statement};
  reading.missed = static_cast<int>(std::count_if(awaiting_.begin(), awaiting_.end(), older));
  if (reading.missed > 0)
    reading.last_missed_ns = awaiting_[static_cast<std::size_t>(reading.missed) - 1].time_ns;
  awaiting_.erase(awaiting_.begin(), awaiting_.begin() + reading.missed + 1);
  return reading;
}

}  // namespace pal::trace
