#include "runtime/watch/device_watch.hpp"

#include <algorithm>
#include <utility>

namespace pal::runtime {

void DeviceWatch::expect_event(Time from, Time to) {
  from_ = from;
  to_ = times_.behaviour == Behaviour::sporadic ? Time::max() : to;
  due_ = to_ == Time::max() ? Time::max() : to_ + times_.jitter + Time(1);
  late_ = false;
}

void DeviceWatch::opened(Time now) {
  if (!sends_events() || std::exchange(open_, true)) return;
  last_ = now;
  const bool any_phase = times_.phase < Time::zero();
  expect_event(any_phase ? now : now + times_.phase, now + (any_phase ? times_.period : times_.phase));
}

Seen DeviceWatch::event(Time now) {
  if (!sends_events() || !open_) return {};
  Seen seen{Seen::What::kept, now - std::exchange(last_, now), late_};
  Time from = std::max(from_, now - times_.jitter);
  Time to = std::min(to_, now);
  if (from > to) {
    seen.what = now < from_ ? Seen::What::sooner : Seen::What::later;
    from = now - times_.jitter;  // from here on counts what has come
    to = now;
  }
  expect_event(from + times_.period, to + times_.period);
  return seen;
}

void DeviceWatch::expect_answer(Time since) {
  since_ = since;
  const Time at_most = times_.answer.worst + (times_.behaviour == Behaviour::frames ? times_.period : Time());
  due_ = asked_ > 0 ? since + at_most + Time(1) : Time::max();
  late_ = false;
}

void DeviceWatch::asked(Time now) {
  if (times_.behaviour != Behaviour::on_request && times_.behaviour != Behaviour::frames) return;
  if (asked_++ == 0) expect_answer(now);
}

void DeviceWatch::forgotten(Time now, bool busy) {
  if (asked_ == 0) return;
  --asked_;
  if (asked_ == 0 || !busy) expect_answer(now);
}

Seen DeviceWatch::answered(Time now, Time asked) {
  if (asked_ == 0) return {};
  const bool frames = times_.behaviour == Behaviour::frames;
  const Time begun = frames ? asked : std::max(asked, last_);
  const Time at_most = times_.answer.worst + (frames ? times_.period : Time());
  Seen seen{Seen::What::kept, now - begun, late_};
  if (seen.measured > at_most) seen.what = Seen::What::later;
  if (seen.measured < times_.answer.best) seen.what = Seen::What::sooner;
  last_ = now;
  --asked_;
  expect_answer(now);
  return seen;
}

Seen DeviceWatch::overdue(Time now) {
  due_ = Time::max();
  if (times_.may_fail) return {};
  late_ = true;
  return {Seen::What::later, now - (sends_events() ? last_ : since_), false};
}

}  // namespace pal::runtime
