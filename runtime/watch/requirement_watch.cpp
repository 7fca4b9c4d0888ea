#include "runtime/watch/requirement_watch.hpp"

#include <algorithm>
#include <type_traits>

namespace pal::runtime {
namespace {

using trace::Kind;
using Measure = RequirementSpec::Measure;

trace::Marks marks(std::span<const int> rows, std::size_t size) {
  trace::Marks result(size);
  for (const int row : rows) result[static_cast<std::size_t>(row)] = true;
  return result;
}

/// Then its worst value is the shortest one.
bool has_least_only(const RequirementSpec& spec) {
  return spec.least > Time::zero() && spec.most == Time::max();
}

template <class Meter, class... Others>
constexpr bool is_one_of = (std::is_same_v<Meter, Others> || ...);

std::vector<trace::UsageMeter> usage(const RequirementSpec& spec, const Wiring& wiring,
                                     const trace::Trace& tables) {
  std::vector<trace::UsageMeter> meters;
  for (const int processor : spec.processors)
    meters.emplace_back(tables, std::string(wiring.processors[static_cast<std::size_t>(processor)].name));
  return meters;
}

trace::LossMeter loss(const RequirementSpec& spec, const Wiring& wiring, const trace::Trace& tables) {
  using Behaviour = DeviceTimes::Behaviour;
  using Of = trace::LossMeter::Of;
  const auto device = static_cast<std::size_t>(spec.device);
  const DeviceTimes times = device < wiring.times.size() ? wiring.times[device] : DeviceTimes{};
  bool events = times.behaviour == Behaviour::events || times.behaviour == Behaviour::sporadic;
  if (times.behaviour == Behaviour::unknown) {
    for (std::size_t c = 0; c < wiring.channels.size(); ++c)
      events = events ||
               (wiring.channels[c].sender == wiring.devices[device] &&
                std::none_of(wiring.channels.begin(), wiring.channels.end(),
                             [c](const ChannelSpec& each) { return each.answer == static_cast<int>(c); }));
  }
  const Of of = events ? Of::events : times.behaviour == Behaviour::frames ? Of::frames : Of::answers;
  return {tables, static_cast<std::int32_t>(wiring.threads.size() + device), of, spec.in,
          times.period.count()};
}

}  // namespace

RequirementWatch::RequirementWatch(const Wiring& wiring, const trace::Trace& tables, Margins* margins)
    : wiring_(wiring),
      margins_(margins),
      inheritance_(tables),
      routes_(tables),
      worst_(wiring.requirements.size()) {
  for (const ThreadSpec& thread : wiring.threads) blocks_ = blocks_ || thread.parent >= 0;
  for (const StatementSpec& statement : wiring.statements) once_ns_ += statement.cost.worst.count();
  for (const DeviceTimes& times : wiring.times)
    slowest_ns_ = std::max({slowest_ns_, times.period.count(), times.answer.worst.count()});
  for (std::size_t r = 0; r < wiring.requirements.size(); ++r) {
    watched_.push_back(watched(r, tables));
    route(r, tables);
  }
  routes_.close();
  routes_.want_everything(blocks_ && any());
  exceeded_.reserve(4 * watched_.size() + 4);
}

RequirementWatch::Watched RequirementWatch::watched(std::size_t requirement,
                                                    const trace::Trace& tables) const {
  const RequirementSpec& spec = wiring_.requirements[requirement];
  const trace::Marks at = marks(spec.at, wiring_.statements.size());
  const trace::Marks channels = marks(spec.channels, wiring_.channels.size());
  const bool whole = spec.after.empty() && spec.during.empty();
  const auto meter = [&]() -> Meter {
    switch (spec.measure) {
      case Measure::response:
        return Response{trace::ResponseMeter(tables, channels, at)};
      case Measure::age:
        return trace::AgeMeter(trace::ConditionFlow(tables, spec.condition), at);
      case Measure::sample:
        return trace::SampleMeter(trace::SampleFlow(tables, channels, kept()), at);
      case Measure::interval:
        return trace::IntervalMeter(at);
      case Measure::duration:
        break;
      case Measure::reaction:
        return trace::ConditionReactionMeter(trace::ConditionFlow(tables, spec.condition), at, whole);
      case Measure::sample_reaction:
        return trace::SampleReactionMeter(trace::SampleFlow(tables, channels, kept()), at, whole);
      case Measure::loss:
        return loss(spec, wiring_, tables);
      case Measure::load:
        return Load{usage(spec, wiring_, tables)};
      case Measure::busy:
        return Busy{usage(spec, wiring_, tables), std::vector<std::int64_t>(spec.processors.size(), -1)};
    }
    return Duration{};
  };
  Watched made{requirement, &spec, has_least_only(spec), meter(), {}};
  if (whole) return made;
  made.phase = Phase{marks(spec.after, wiring_.statements.size()), {spec.during.begin(), spec.during.end()}};
  made.counts = false;
  if (auto* response = std::get_if<Response>(&made.meter)) response->meter.end_phase();
  if (auto* lost = std::get_if<trace::LossMeter>(&made.meter)) lost->end_phase();
  return made;
}

trace::Kept RequirementWatch::kept() const {
  trace::Kept kept;
  kept.of_channel.resize(wiring_.channels.size(), -1);
  kept.used.resize(wiring_.statements.size());
  kept.written.resize(wiring_.statements.size());
  for (const KeptSpec& each : wiring_.kept) {
    const auto place = static_cast<std::size_t>(each.place);
    kept.count = std::max(kept.count, static_cast<std::size_t>(each.kept) + 1);
    if (each.how == KeptSpec::How::taken) kept.of_channel[place] = each.kept;
    if (each.how == KeptSpec::How::used) kept.used[place].push_back(each.kept);
    if (each.how == KeptSpec::How::written) kept.written[place].push_back(each.kept);
  }
  return kept;
}

/// Which events concern the requirement.
void RequirementWatch::route(std::size_t index, const trace::Trace& tables) {
  const Watched& watched = watched_[index];
  const RequirementSpec& spec = this->spec(watched);
  const auto add = [&](std::initializer_list<Kind> kinds) {
    for (const Kind kind : kinds) routes_.add(kind, index);
  };
  for (const int statement : spec.at) routes_.add(Kind::done, statement, index);
  for (const int statement : spec.after) routes_.add(Kind::done, statement, index);
  switch (spec.measure) {
    case Measure::response:
      add({Kind::put, Kind::take, Kind::drop, Kind::overrun});
      break;
    case Measure::age:
    case Measure::reaction:
      routes_.add(Kind::set, spec.condition, index);
      routes_.add(Kind::read, spec.condition, index);
      break;
    case Measure::sample:
    case Measure::sample_reaction:
      add({Kind::put, Kind::take, Kind::drop, Kind::overrun, Kind::set, Kind::read, Kind::busy});
      for (const KeptSpec& each : wiring_.kept)
        if (each.how != KeptSpec::How::taken) routes_.add(Kind::done, each.place, index);
      break;
    case Measure::interval:
      break;
    case Measure::duration:
      add({Kind::complete});
      break;
    case Measure::loss: {
      const auto device = static_cast<std::int32_t>(wiring_.threads.size()) + spec.device;
      routes_.add(Kind::busy, device, index);
      routes_.add(Kind::idle, device, index);
      add({Kind::complete});
      const std::string_view name = wiring_.devices[static_cast<std::size_t>(spec.device)];
      for (std::size_t c = 0; c < wiring_.channels.size(); ++c) {
        const ChannelSpec& channel = wiring_.channels[c];
        if (channel.sender != name && channel.receiver != name) continue;
        for (const Kind kind : {Kind::put, Kind::take, Kind::drop, Kind::overrun})
          routes_.add(kind, static_cast<std::int32_t>(c), index);
      }
      break;
    }
    case Measure::load:
    case Measure::busy: {
      const auto& meters = spec.measure == Measure::load ? std::get<Load>(watched.meter).meters
                                                         : std::get<Busy>(watched.meter).meters;
      for (std::size_t a = 0; a < tables.actors.size(); ++a) {
        const auto actor = static_cast<std::int32_t>(a);
        if (std::none_of(meters.begin(), meters.end(), [actor](const auto& each) { return each.has(actor); }))
          continue;
        for (const Kind kind : {Kind::ready, Kind::start, Kind::stop, Kind::block, Kind::cancel})
          routes_.add(kind, actor, index);
      }
      add({Kind::done, Kind::complete});
      break;
    }
  }
}

// What is measured.

void RequirementWatch::check(const Watched& watched, const trace::Occurrence& seen, bool noted) {
  const Time length(seen.length_ns());
  measured(watched, length);
  if (length > spec(watched).most || length < spec(watched).least)
    exceeded_.push_back({watched.requirement, length, seen.actor, seen.statement, noted});
}

void RequirementWatch::check_number(const Watched& watched, const std::optional<int>& lost) {
  if (!lost) return;
  const Time number(*lost);
  measured(watched, number);
  if (number > spec(watched).most) exceeded_.push_back({watched.requirement, number, -1, -1, false});
}

/// A load is of the long run. So much more than it allows may be done by now: each statement once, of what is
/// done once only, and what is asked for in one turn of the slowest device.
void RequirementWatch::check_load(const Watched& watched, Load& load, std::int64_t now_ns) {
  constexpr double second = 1e9;
  double greatest = 0;
  for (const trace::UsageMeter& meter : load.meters)
    greatest = std::max(greatest, static_cast<double>(meter.work(now_ns)));
  if (now_ns <= 0) return;
  const auto now = static_cast<double>(now_ns);
  const Time so_far(static_cast<std::int64_t>(greatest / now * second));
  worst_[watched.requirement] = so_far;
  tell(watched, so_far);
  if (spec(watched).most == Time::max()) return;
  const double limit = static_cast<double>(spec(watched).most.count()) / second;
  const bool over =
      greatest > limit * (now + static_cast<double>(slowest_ns_)) + static_cast<double>(once_ns_);
  if (over && !load.over) exceeded_.push_back({watched.requirement, *worst_[watched.requirement], -1, -1});
  load.over = over;
}

/// Shows an event to a meter.
struct RequirementWatch::See {
  RequirementWatch& watch;
  Watched& watched;
  const trace::Event& event;
  std::int32_t parent;

  void operator()(Response& response) const {
    const trace::ResponseMeter::Reading reading = response.meter.see(event, parent);
    if (event.kind == Kind::put && response.meter.counts(event)) watch.may_be_due(watched, event.time_ns);
    if (reading.missed > 0)
      watch.exceeded_.push_back({watched.requirement, Time::max(), event.actor, event.statement,
                                 reading.last_missed_ns <= response.noted_ns});
    if (reading.answered)
      watch.check(watched, reading.answered, reading.answered->from_ns <= response.noted_ns);
  }
  void operator()(trace::IntervalMeter& meter) const {
    if (watched.counts) watch.check(watched, meter.see(event));
  }
  void operator()(Duration&) const {
    if (watched.counts && event.kind == Kind::complete && event.value == watch.spec(watched).code)
      watch.check(watched, trace::Occurrence{watched.begun_ns, event.time_ns, event.actor, event.statement});
  }
  void operator()(trace::LossMeter& meter) const {
    watch.check_number(watched, meter.see(event));
    if (event.kind == Kind::complete) watch.check_number(watched, meter.finish());
  }
  void operator()(Busy& busy) const {
    for (std::size_t i = 0; i < busy.meters.size(); ++i) {
      trace::UsageMeter& meter = busy.meters[i];
      auto over = meter.see(event);
      if (event.kind == Kind::complete) over = meter.finish(event.time_ns);
      if (over) {
        watch.check(watched, over, over->from_ns == busy.noted_ns[i]);
        if (over->length_ns() > watch.spec(watched).most.count()) busy.noted_ns[i] = over->from_ns;
      }
      const auto since = meter.busy_since();
      if (since && *since != busy.noted_ns[i]) watch.may_be_due(watched, *since);
    }
  }
  void operator()(Load& load) const {
    for (trace::UsageMeter& meter : load.meters) meter.see(event);
    watch.check_load(watched, load, event.time_ns);
  }
  template <class Meter>
  requires is_one_of<Meter, trace::AgeMeter, trace::SampleMeter>
  void operator()(Meter& meter) const {
    const auto seen = meter.see(event, parent);
    if (watched.counts) watch.check(watched, seen);
  }
  template <class Meter>
  requires is_one_of<Meter, trace::ConditionReactionMeter, trace::SampleReactionMeter>
  void operator()(Meter& meter) const { watch.check(watched, meter.see(event, parent)); }
};

void RequirementWatch::look(Watched& watched, const trace::Event& event, std::int32_t parent) {
  std::visit(See{*this, watched, event, parent}, watched.meter);
  if (!watched.phase) return;
  const bool begins = !watched.counts && event.kind == Kind::done && event.statement >= 0;
  if (begins && watched.phase->after[static_cast<std::size_t>(event.statement)])
    begin_phase(watched, event.time_ns);
}

/// What is seen most often, of an event of an actor that inherits nothing. False: nothing was done.
inline bool RequirementWatch::see_usual(Watched& watched, const trace::Event& event) {
  if (watched.phase) return false;
  if (auto* response = std::get_if<Response>(&watched.meter)) {
    if (event.kind == Kind::put) {
      response->meter.put(event);
      if (response->meter.counts(event)) may_be_due(watched, event.time_ns);
      return true;
    }
    if (event.kind == Kind::take) {
      response->meter.take(event);
      return true;
    }
    trace::ResponseMeter::Birth cause;
    if (event.kind == Kind::done && response->meter.answer_oldest(event, cause)) {
      check(watched, trace::Occurrence{cause.time_ns, event.time_ns, event.actor, event.statement},
            cause.time_ns <= response->noted_ns);
      return true;
    }
  } else if (auto* interval = std::get_if<trace::IntervalMeter>(&watched.meter)) {
    check(watched, interval->see(event));
    return true;
  }
  return false;
}

const std::vector<Exceeded>& RequirementWatch::see(const trace::Event& event,
                                                   std::span<const std::uint32_t> meters) {
  exceeded_.clear();
  if (leaving_ > 0) settle_phases(-1);
  const std::int32_t parent = blocks_ ? inheritance_.begins(event) : -1;
  if (parent >= 0) {
    for (Watched& each : watched_) look(each, event, parent);
  } else {
    for (const std::uint32_t each : meters) {
      if (!see_usual(watched_[each], event)) look(watched_[each], event, parent);
    }
  }
  return exceeded_;
}

// Phases.

void RequirementWatch::begin_phase(Watched& watched, std::int64_t now_ns) {
  watched.counts = true;
  watched.begun_ns = now_ns;
  if (auto* response = std::get_if<Response>(&watched.meter)) response->meter.begin_phase();
  if (auto* lost = std::get_if<trace::LossMeter>(&watched.meter)) lost->begin_phase();
  if (auto* reaction = std::get_if<trace::ConditionReactionMeter>(&watched.meter))
    reaction->begin_phase(now_ns);
  if (auto* reaction = std::get_if<trace::SampleReactionMeter>(&watched.meter)) reaction->begin_phase(now_ns);
}

/// What has not come to its end does not count.
void RequirementWatch::end_phase(Watched& watched) {
  watched.counts = false;
  if (auto* response = std::get_if<Response>(&watched.meter)) response->meter.end_phase();
  if (auto* interval = std::get_if<trace::IntervalMeter>(&watched.meter)) interval->forget();
  if (auto* lost = std::get_if<trace::LossMeter>(&watched.meter)) check_number(watched, lost->end_phase());
  if (auto* reaction = std::get_if<trace::ConditionReactionMeter>(&watched.meter)) reaction->end_phase();
  if (auto* reaction = std::get_if<trace::SampleReactionMeter>(&watched.meter)) reaction->end_phase();
}

/// Whoever has left the last loop of a phase, unless it is thread `but_of`, has come to a statement
/// elsewhere: the phase is over.
void RequirementWatch::settle_phases(int but_of) {
  for (Watched& each : watched_) {
    if (!each.phase || each.phase->leaver < 0 || each.phase->leaver == but_of) continue;
    each.phase->leaver = -1;
    --leaving_;
    if (each.phase->after.empty() || each.counts) end_phase(each);
  }
  routes_.want_everything(leaving_ > 0 || blocks_);
}

const std::vector<Exceeded>& RequirementWatch::enter(int loop, int thread, Time now) {
  exceeded_.clear();
  if (leaving_ > 0) settle_phases(thread);
  for (Watched& each : watched_) {
    if (!each.phase) continue;
    const std::vector<int>& during = each.phase->during;
    if (std::find(during.begin(), during.end(), loop) == during.end()) continue;
    if (each.phase->inside++ > 0) continue;
    if (each.phase->leaver >= 0) {
      each.phase->leaver = -1;
      --leaving_;
    }
    if (!each.counts) begin_phase(each, now.count());
  }
  return exceeded_;
}

const std::vector<Exceeded>& RequirementWatch::leave(int loop, int thread) {
  exceeded_.clear();
  if (leaving_ > 0) settle_phases(thread);
  for (Watched& each : watched_) {
    if (!each.phase) continue;
    const std::vector<int>& during = each.phase->during;
    if (std::find(during.begin(), during.end(), loop) == during.end()) continue;
    if (--each.phase->inside > 0) continue;
    each.phase->leaver = thread;
    ++leaving_;
  }
  routes_.want_everything(leaving_ > 0 || blocks_);
  return exceeded_;
}

// What goes on for too long.

void RequirementWatch::end(Time now) {
  for (Watched& watched : watched_) {
    auto* busy = std::get_if<Busy>(&watched.meter);
    if (busy == nullptr) continue;
    for (trace::UsageMeter& meter : busy->meters) {
      if (const auto over = meter.finish(now.count())) measured(watched, Time(over->length_ns()));
    }
  }
}

Time RequirementWatch::due() {
  soonest_ = Time::max();
  Time due = Time::max();
  const auto goes_on = [&](const Watched& watched, std::int64_t since_ns) {
    due = std::min(due, Time(since_ns) + spec(watched).most + Time(1));
  };
  for (const Watched& watched : watched_) {
    if (spec(watched).most == Time::max()) continue;
    if (const auto* response = std::get_if<Response>(&watched.meter)) {
      const auto* oldest = response->meter.awaiting(response->noted);
      if (oldest != nullptr) goes_on(watched, oldest->time_ns);
    } else if (const auto* busy = std::get_if<Busy>(&watched.meter)) {
      for (std::size_t i = 0; i < busy->meters.size(); ++i) {
        const auto since = busy->meters[i].busy_since();
        if (since && *since != busy->noted_ns[i]) goes_on(watched, *since);
      }
    }
  }
  return due;
}

const std::vector<Exceeded>& RequirementWatch::overdue(Time now) {
  exceeded_.clear();
  for (Watched& watched : watched_) {
    if (auto* response = std::get_if<Response>(&watched.meter)) {
      while (const auto* oldest = response->meter.awaiting(response->noted)) {
        const Time age = now - Time(oldest->time_ns);
        if (age <= spec(watched).most) break;
        exceeded_.push_back({watched.requirement, age, -1, -1, false});
        response->noted = oldest->number;
        response->noted_ns = oldest->time_ns;
      }
    } else if (auto* busy = std::get_if<Busy>(&watched.meter)) {
      for (std::size_t i = 0; i < busy->meters.size(); ++i) {
        const auto since = busy->meters[i].busy_since();
        if (!since || *since == busy->noted_ns[i] || now - Time(*since) <= spec(watched).most) continue;
        exceeded_.push_back({watched.requirement, now - Time(*since), -1, -1, false});
        busy->noted_ns[i] = *since;
      }
    }
  }
  return exceeded_;
}

}  // namespace pal::runtime
