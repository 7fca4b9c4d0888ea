#include "programs/pal/reports/loss_run.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "analyzer/runs/simulate.hpp"
#include "analyzer/verdict/narrator.hpp"
#include "pal/trace/slices.hpp"

namespace pal::program {
namespace {

using analyzer::Nanoseconds;
using trace::Event;
using trace::Kind;

const analyzer::Watch nothing_watched;

std::int32_t actor_of(const analyzer::Problem& problem, analyzer::DeviceId device) {
  return static_cast<std::int32_t>(problem.threads.size()) + device.value;
}

/// The time from one event, answer or frame of a device to the next, as far as the environment tells.
Nanoseconds distance_of(const analyzer::Device& device) {
  constexpr Nanoseconds usual = 100'000'000;
  if (const auto* frames = std::get_if<pan::FrameDevice>(&device.behaviour)) return frames->period.count();
  if (const auto* event = std::get_if<pan::EventDevice>(&device.behaviour)) return event->period.count();
  if (const auto* served = std::get_if<pan::RequestDevice>(&device.behaviour))
    return std::max<Nanoseconds>(1, 2 * served->answer.worst.count());
  return usual;
}

/// The events of a device of one kind, in order.
std::vector<Event> events_of(const trace::Trace& run, std::int32_t actor, Kind kind) {
  std::vector<Event> found;
  std::copy_if(run.events.begin(), run.events.end(), std::back_inserter(found),
               [&](const Event& event) { return event.actor == actor && event.kind == kind; });
  return found;
}

const Event* first_from(const std::vector<Event>& events, Nanoseconds instant) {
  const auto found = std::find_if(events.begin(), events.end(),
                                  [instant](const Event& event) { return event.time_ns >= instant; });
  return found == events.end() ? nullptr : &*found;
}

trace::Trace made(const analyzer::Problem& problem, std::vector<analyzer::ScriptedFiring> beginning,
                  Nanoseconds until) {
  constexpr std::size_t most_events = 200'000;
  const analyzer::Machine machine(problem, nothing_watched);
  analyzer::SimulationOptions options;
  options.until = until;
  options.max_events = most_events;
  options.beginning = std::move(beginning);
  // What comes at any time, a button for instance, comes no sooner than the run ends, which it may end.
  for (const analyzer::Device& device : problem.devices) {
    const auto* event = std::get_if<pan::EventDevice>(&device.behaviour);
    options.phases.push_back(event != nullptr && event->sporadic && options.beginning.empty() ? until : -1);
  }
  return analyzer::simulate(machine, options).trace;
}

/// The first take by a thread of something that the device put at an instant or later.
std::optional<Nanoseconds> next_taken(const trace::Trace& run, std::int32_t actor, Nanoseconds instant) {
  for (const Event& put : events_of(run, actor, Kind::put)) {
    if (put.time_ns < instant) continue;
    for (const Event& take : run.events) {
      if (take.kind == Kind::take && take.subject == put.subject && take.value == put.value)
        return take.time_ns;
    }
  }
  return std::nullopt;
}

/// Of a frame that was not requested: which thread asked too late, and what that thread did since the device
/// gave it the frame before.
void explain_frame(const analyzer::Problem& problem, analyzer::DeviceId device,
                   const analyzer::chart::Loss& loss, LossRun& shown) {
  const std::vector<analyzer::ChannelId>& requests = problem.devices[device].requests;
  const auto late = std::find_if(shown.run.events.begin(), shown.run.events.end(), [&](const Event& event) {
    return event.kind == Kind::put && event.time_ns > loss.from_ns &&
           std::find(requests.begin(), requests.end(), analyzer::ChannelId::of(event.subject)) !=
               requests.end();
  });
  if (late == shown.run.events.end()) return;
  shown.highlight =
      analyzer::chart::Highlight{loss.from_ns, late->time_ns, "asked for too late by", true, -1};
  Nanoseconds before = loss.from_ns;
  for (const Event& put : events_of(shown.run, actor_of(problem, device), Kind::put)) {
    if (put.time_ns <= loss.from_ns) before = put.time_ns;
  }
  analyzer::Narrator(problem, shown.run)
      .tell(analyzer::ThreadId::of(late->actor), before, late->time_ns, shown.reasons);
}

/// Of a message that found its slot full: how much later the one before it was taken. Also what the receiver
/// had done since that one came.
void explain_overrun(const analyzer::Problem& problem, const Event& overrun, LossRun& shown) {
  const auto& events = shown.run.events;
  const auto take = std::find_if(events.begin(), events.end(), [&](const Event& event) {
    return event.kind == Kind::take && event.subject == overrun.subject && event.time_ns > overrun.time_ns;
  });
  if (take == events.end()) return;
  shown.highlight = analyzer::chart::Highlight{overrun.time_ns, take->time_ns,
                                               "the one before is taken too late by", true, -1};
  Nanoseconds before = overrun.time_ns;
  for (const Event& event : events) {
    if (event.kind == Kind::put && event.subject == overrun.subject && event.time_ns <= overrun.time_ns)
      before = event.time_ns;
  }
  analyzer::Narrator(problem, shown.run)
      .tell(analyzer::ThreadId::of(take->actor), before, take->time_ns, shown.reasons);
}

/// The first loss that is not before an instant at which one was counted: the end of its work, or its
/// beginning.
const analyzer::chart::Loss* counted_at(const std::vector<analyzer::chart::Loss>& losses,
                                        Nanoseconds instant) {
  const auto found = std::find_if(losses.begin(), losses.end(), [instant](const analyzer::chart::Loss& loss) {
    return loss.to_ns >= instant;
  });
  return found == losses.end() ? nullptr : &*found;
}

LossRun with_loss(const Proof& proof, std::size_t index) {
  const analyzer::Problem& problem = proof.problem;
  const analyzer::Requirement& requirement = problem.requirements[index];
  const analyzer::Witness& witness = *proof.analysis.verdicts[index].witness;
  const std::int32_t actor = actor_of(problem, requirement.device);
  const Nanoseconds distance = distance_of(problem.devices[requirement.device]);
  const Nanoseconds at = witness.measured.at;
  LossRun shown;
  shown.run = made(problem, witness.script, at + 6 * distance);
  shown.losses = losses_in(problem, shown.run, requirement.device);
  const analyzer::chart::Loss* loss = counted_at(shown.losses, at);
  if (loss == nullptr) {
    // The run did not go on as it began: the proved one ends where the loss is counted.
    const analyzer::Device& device = problem.devices[requirement.device];
    const bool frames = std::holds_alternative<pan::FrameDevice>(device.behaviour);
    shown.run = witness.trace;
    shown.losses = {{device.name, at, at,
                     frames ? "lost: no request for it was open when it began"
                            : "lost: the one before it was not taken yet"}};
    shown.window = analyzer::chart::Window{0, at + std::max<Nanoseconds>(1, at / 10)};
    return shown;
  }
  const Nanoseconds next = next_taken(shown.run, actor, loss->to_ns + 1).value_or(loss->to_ns + 2 * distance);
  // As many in a row as the requirement speaks of, the last lost one, and the next.
  const Nanoseconds row = std::max<Nanoseconds>(1, requirement.in) * distance;
  shown.window = analyzer::chart::Window{std::max<Nanoseconds>(0, loss->from_ns - row - distance / 8),
                                         next + distance / 8};
  const std::vector<Event> overruns = events_of(shown.run, actor, Kind::overrun);
  const Event* overrun = first_from(overruns, loss->to_ns);
  if (overrun != nullptr && overrun->time_ns == loss->to_ns) {
    explain_overrun(problem, *overrun, shown);
  } else {
    explain_frame(problem, requirement.device, *loss, shown);
  }
  return shown;
}

/// A run of the worst times in which the device gives a few messages, all of which are taken.
std::optional<LossRun> without_loss(const analyzer::Problem& problem, analyzer::DeviceId device) {
  constexpr std::size_t wanted = 4;
  constexpr int most_tries = 8;
  const std::int32_t actor = actor_of(problem, device);
  const Nanoseconds distance = distance_of(problem.devices[device]);
  Nanoseconds until = 8 * distance;
  for (int tries = 0; tries < most_tries; ++tries, until *= 2) {
    LossRun shown;
    shown.run = made(problem, {}, until);
    const std::vector<Event> puts = events_of(shown.run, actor, Kind::put);
    if (puts.empty() || (puts.size() < wanted && tries + 1 < most_tries)) continue;
    shown.run.origin = "simulated";
    const Event& last = puts[std::min(wanted, puts.size()) - 1];
    const Nanoseconds end = next_taken(shown.run, actor, last.time_ns).value_or(last.time_ns);
    shown.window = analyzer::chart::Window{std::max<Nanoseconds>(0, puts.front().time_ns - distance),
                                           end + distance / 4};
    shown.losses = losses_in(problem, shown.run, device);
    return shown;
  }
  return std::nullopt;
}

}  // namespace

std::vector<analyzer::chart::Loss> losses_in(const analyzer::Problem& problem, const trace::Trace& run,
                                             analyzer::DeviceId device) {
  const std::int32_t actor = actor_of(problem, device);
  const std::string& name = problem.devices[device].name;
  const std::vector<Event> puts = events_of(run, actor, Kind::put);
  const std::vector<Event> overruns = events_of(run, actor, Kind::overrun);
  const bool frames = std::holds_alternative<pan::FrameDevice>(problem.devices[device].behaviour);
  std::vector<analyzer::chart::Loss> losses;
  std::vector<Nanoseconds> with_work;  // overruns that end a stretch of work
  bool counts = false;
  for (const trace::Slice& slice : trace::slices(run)) {
    if (slice.actor != actor || slice.state != trace::State::serving || slice.ending == trace::Ending::open)
      continue;
    const auto at_end = [&](const Event& event) { return event.time_ns == slice.to_ns; };
    const bool full = std::any_of(overruns.begin(), overruns.end(), at_end);
    const bool given = std::any_of(puts.begin(), puts.end(), at_end);
    counts = counts || given || full;
    if (full) with_work.push_back(slice.to_ns);
    if (full && !given)
      losses.push_back({name, slice.from_ns, slice.to_ns, "lost: the one before it was not taken yet"});
    if (frames && counts && !given && !full)
      losses.push_back({name, slice.from_ns, slice.to_ns, "lost: no request for it was open when it began"});
  }
  for (const Event& event : overruns) {
    if (std::find(with_work.begin(), with_work.end(), event.time_ns) == with_work.end())
      losses.push_back({name, event.time_ns, event.time_ns, "lost: the one before it was not taken yet"});
  }
  std::stable_sort(
      losses.begin(), losses.end(),
      [](const analyzer::chart::Loss& a, const analyzer::chart::Loss& b) { return a.from_ns < b.from_ns; });
  return losses;
}

std::optional<LossRun> loss_run(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  if (!analyzer::fits_exploration(proof.problem)) return std::nullopt;
  if (verdict.witness && !verdict.witness->failed && verdict.witness->measured.value > 0)
    return with_loss(proof, index);
  // In what is undecided or never happens there is nothing to see.
  if (verdict.state != analyzer::VerdictState::holds) return std::nullopt;
  return without_loss(proof.problem, proof.problem.requirements[index].device);
}

}  // namespace pal::program
