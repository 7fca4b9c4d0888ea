#include "pal/trace/meter.hpp"

#include <algorithm>
#include <utility>

#include "trace/requests.hpp"

namespace pal::trace {
namespace {

constexpr std::size_t usual_births = 64;

}  // namespace

// Responses.

ResponseMeter::ResponseMeter(const Trace& tables, Marks channels, Marks at)
    : at_(std::move(at)), channels_(tables.channels.size()), actors_(tables.actors.size()) {
  const std::vector<std::int32_t> request_of = requests_of(tables);
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    channels_[c].request = request_of[c];
    channels_[c].is_source = channels[c];
    if (request_of[c] >= 0) channels_[static_cast<std::size_t>(request_of[c])].asks = true;
  }
  for (std::size_t a = 0; a < actors_.size(); ++a) actors_[a].device = tables.actors[a].device;
  serving_ = room_for_requests<Birth>(request_of);
  awaiting_.reserve(usual_births);
}

/// Of an event that is neither put, taken nor the effect of a statement.
ResponseMeter::Reading ResponseMeter::see_loss(const Event& event) {
  if (event.kind == Kind::drop) drop(event);
  if (event.kind != Kind::overrun) return {};
  answered_request(event);
  if (!counts(event)) return {};
  return {std::nullopt, 1, event.time_ns};
}

bool ResponseMeter::is_awaiting_later(const Birth& birth) const {
  const Birth* found = first_after(birth.number - 1);
  return found != nullptr && found->number == birth.number;
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
  const std::int32_t request = channel(event).request;
  if (request < 0 || !actor(event).device) return {};
  return take_first(serving_[static_cast<std::size_t>(request)], Birth{});
}

/// Of what does not count: it can change nothing any more.
void ResponseMeter::forget_what_nobody_carries() {
  const auto is_carried = [&](std::int64_t number) {
    const auto is = [number](const Birth& each) { return each.number == number; };
    return std::any_of(channels_.begin(), channels_.end(),
                       [&](const Channel& c) { return is(c.on_message); }) ||
           std::any_of(actors_.begin(), actors_.end(), [&](const Actor& a) { return is(a.carried); }) ||
           std::any_of(serving_.begin(), serving_.end(), [&](const std::vector<Birth>& list) {
             return std::any_of(list.begin(), list.end(), is);
           });
  };
  std::erase_if(awaiting_,
                [&](const Birth& birth) { return birth.number < counts_from_ && !is_carried(birth.number); });
}

/// One that is withdrawn before it is taken awaits nothing.
void ResponseMeter::drop(const Event& event) {
  if (event.actor >= 0) {
    if (event.value != unasked) answered_request(event);
  } else if (is_source(event)) {
    std::erase_if(awaiting_,
                  [&](const Birth& birth) { return birth.number == channel(event).on_message.number; });
  }
}

/// It answers one that is not the first, or does not count.
ResponseMeter::Reading ResponseMeter::answer_later(const Event& event) {
  const Birth cause = actor(event).carried;
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
