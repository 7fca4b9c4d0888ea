// Devices: events, answers and frames.
#include <algorithm>

#include "analyzer/run_checker/referee.hpp"

namespace pal::analyzer::run_checker {

void Referee::open_device(DeviceId device) {
  Outside& of = devices_[device];
  const auto* event = std::get_if<pan::EventDevice>(&problem_.devices[device].behaviour);
  if (event == nullptr || of.open) return;
  of.open = true;
  of.opened = now_;
  of.first_lo = now_;
  of.first_hi = event->sporadic ? Range::unbounded : now_ + event->period.count();
  if (event->phase) of.first_lo = of.first_hi = now_ + event->phase->count();
}

void Referee::device_event(const Event& event, DeviceId device) {
  const Device& described = problem_.devices[device];
  Outside& of = devices_[device];
  const bool events = std::holds_alternative<pan::EventDevice>(described.behaviour);
  switch (event.kind) {
    case Kind::busy:
      return busy(device);
    case Kind::idle:
      return idle(device);
    case Kind::take: {
      const Channel& channel = channel_of(ChannelId::of(event.subject));
      demand(channel.receiver_device == device && slot(ChannelId::of(event.subject)).full,
             "a device takes what it has not got");
      if (channel.served) {
        demand(of.busy && of.busy_since == now_, described.name, " takes a request outside its time");
        demand(of.served.empty() || std::holds_alternative<pan::FrameDevice>(described.behaviour),
               described.name, " serves two at once");
        monitor_.serves(ChannelId::of(event.subject), of.served.empty());
        of.served.insert(ChannelId::of(event.subject));
      }
      empty(ChannelId::of(event.subject));
      return;
    }
    case Kind::put:
    case Kind::overrun:
      demand(channel_of(ChannelId::of(event.subject)).sender_device == device,
             "a device sends what is not its own");
      demand(slot(ChannelId::of(event.subject)).full == (event.kind == Kind::overrun), described.name,
             " sends into a full slot, or loses without need");
      if (events) return occurrence(device, ChannelId::of(event.subject), event.kind == Kind::overrun);
      demand(wanted(ChannelId::of(event.subject)), "a message is put that no party waits for");
      if (event.kind == Kind::overrun) {
        answered_in_vain(ChannelId::of(event.subject));
        monitor_.answers(ChannelId::of(event.subject), true);
      } else {
        of.any_put = true;
        monitor_.answers(ChannelId::of(event.subject), false);
        fill(ChannelId::of(event.subject), ProcessorId{});
      }
      delivered(device, ChannelId::of(event.subject));
      return;
    case Kind::drop:
      if (wanted(ChannelId::of(event.subject))) {
        never_answers(device, ChannelId::of(event.subject));
      } else {
        delivered(device, ChannelId::of(event.subject));
      }
      answered_in_vain(ChannelId::of(event.subject));
      return;
    default:
      broken("a device has no such event");
  }
}

void Referee::delivered(DeviceId device, ChannelId channel) {
  const ChannelId request = channel_of(channel).answers;
  Outside& of = devices_[device];
  demand(of.answers.erase(request) == 1, "a device answers what it was not asked");
  if (of.answers.empty()) monitor_.served(device, !of.any_put);
}

/// The device has no answer to what it was asked, which is no loss.
void Referee::never_answers(DeviceId device, ChannelId channel) {
  const auto* request = std::get_if<pan::RequestDevice>(&problem_.devices[device].behaviour);
  demand(request != nullptr && request->may_fail, "a message is discarded that a party waits for");
  const ChannelId asked = channel_of(channel).answers;
  demand(devices_[device].answers.erase(asked) == 1, "a device answers what it was not asked");
}

/// One more of a series with the given period, each up to `late` after it is due: narrows when the first was.
void Referee::due(DeviceId device, Nanoseconds period, Nanoseconds late) {
  Outside& of = devices_[device];
  of.first_lo = std::max(of.first_lo, now_ - of.count * period - late);
  of.first_hi = std::min(of.first_hi, now_ - of.count * period);
  demand(of.first_lo <= of.first_hi, problem_.devices[device].name, " is too early or too late");
  ++of.count;
}

void Referee::occurrence(DeviceId device, ChannelId channel, bool overrun) {
  const Device& described = problem_.devices[device];
  const auto& event = std::get<pan::EventDevice>(described.behaviour);
  Outside& of = devices_[device];
  demand(of.open && described.event == channel, described.name,
         " sends before a thread waits, or another message");
  if (event.sporadic) {
    const Nanoseconds late = event.jitter.count();
    Nanoseconds earliest = std::max(of.first_lo, now_ - late);
    if (of.count > 0) earliest = std::max(now_ - late, of.last_nominal + event.period.count());
    demand(
        earliest <= now_ && (of.count > 0 || now_ <= (event.phase ? of.first_hi + late : Range::unbounded)),
        described.name, " is too early or too late");
    of.last_nominal = earliest;
    ++of.count;
  } else {
    due(device, event.period.count(), event.jitter.count());
  }
  if (!overrun) {
    fill(channel, ProcessorId{});
    asks(channel, {});
  }
  monitor_.event(device, channel, overrun);
}

void Referee::busy(DeviceId device) {
  const Device& described = problem_.devices[device];
  Outside& of = devices_[device];
  demand(!of.busy, described.name, " serves two at once");
  of.busy = true;
  of.busy_since = now_;
  if (const auto* frames = std::get_if<pan::FrameDevice>(&described.behaviour)) {
    due(device, frames->period.count(), 0);
    if (!serves_somebody(device)) monitor_.frame_for_nobody(device);
  } else {
    demand(std::holds_alternative<pan::RequestDevice>(described.behaviour), described.name,
           " serves nothing");
    const bool asked = std::any_of(described.requests.begin(), described.requests.end(),
                                   [this](ChannelId request) { return slot(request).full; });
    demand(asked, described.name, " serves before it is asked");
  }
}

/// Whether the device takes a request at this instant.
bool Referee::serves_somebody(DeviceId device) const {
  const int actor = static_cast<int>(threads_.size()) + device.value;
  for (std::size_t e = next_of(actor, at_); e < events_.size() && events_[e].time_ns == now_;
       e = next_of(actor, e)) {
    if (events_[e].kind == Kind::idle) return false;
    if (events_[e].kind == Kind::take) return true;
  }
  return false;
}

void Referee::idle(DeviceId device) {
  const Device& described = problem_.devices[device];
  Outside& of = devices_[device];
  demand(of.busy, described.name, " ends what it has not begun");
  Range range;
  if (const auto* request = std::get_if<pan::RequestDevice>(&described.behaviour)) {
    range = {request->answer.best.count(), request->answer.worst.count()};
  } else {
    const Nanoseconds collecting = std::get<pan::FrameDevice>(described.behaviour).collecting.count();
    range = {collecting, collecting};
  }
  const Nanoseconds took = now_ - of.busy_since;
  demand(took >= range.best && took <= range.worst, described.name, " takes another time than it should");
  of.busy = false;
  of.any_put = false;
  of.answers = std::move(of.served);
  of.served.clear();
  for (ChannelId request : of.answers) monitor_.is_due(request);
}

/// A request that is to be withdrawn from its slot: a device that is idle has taken it before.
void Referee::check_not_idle(ChannelId request) const {
  const DeviceId device = channel_of(request).receiver_device;
  if (!device.valid()) return;
  const Device& described = problem_.devices[device];
  const bool on_request = std::holds_alternative<pan::RequestDevice>(described.behaviour);
  demand(!on_request || devices_[device].busy, described.name, " is idle while it has a request");
}

/// A message to a device, while time goes on.
void Referee::check_asked(ChannelId message) const {
  const Channel& channel = channel_of(message);
  const Device& described = problem_.devices[channel.receiver_device];
  const Outside& of = devices_[channel.receiver_device];
  demand(channel.served, described.name, " leaves a message in its slot");
  const bool on_request = std::holds_alternative<pan::RequestDevice>(described.behaviour);
  demand(!on_request || of.busy, described.name, " is idle while it has a request");
  const bool missed = !on_request && of.busy && of.busy_since == now_ && slot(message).put < now_;
  demand(!missed, described.name, " leaves a request out of its frame");
}

void Referee::check_device(DeviceId device, Nanoseconds next) const {
  const Device& described = problem_.devices[device];
  const Outside& of = devices_[device];
  demand(of.answers.empty(), described.name, " owes an answer");
  if (const auto* event = std::get_if<pan::EventDevice>(&described.behaviour)) {
    if (!of.open || !described.event.valid()) return;
    const Nanoseconds late = event->jitter.count();
    if (event->sporadic) {
      demand(of.count > 0 || !event->phase || next <= of.first_hi + late, described.name, " is too late");
      return;
    }
    demand(next <= of.first_hi + of.count * event->period.count() + late, described.name, " is too late");
  } else if (const auto* request = std::get_if<pan::RequestDevice>(&described.behaviour)) {
    if (!of.busy) return;
    demand(!of.served.empty(), described.name, " is busy without a request");
    demand(next <= of.busy_since + request->answer.worst.count(), described.name, " answers too late");
  } else if (const auto* frames = std::get_if<pan::FrameDevice>(&described.behaviour)) {
    demand(of.served.empty() || next <= of.busy_since + frames->collecting.count(), described.name,
           " answers too late");
    demand(next <= of.first_hi + of.count * frames->period.count(), described.name, " is too late");
  }
}

}  // namespace pal::analyzer::run_checker
