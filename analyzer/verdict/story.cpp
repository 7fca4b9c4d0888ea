#include "analyzer/verdict/story.hpp"

#include <algorithm>

#include "analyzer/problem/flow.hpp"
#include "analyzer/verdict/narrator.hpp"
#include "analyzer/verdict/origins.hpp"
#include "pal/trace/slices.hpp"

namespace pal::analyzer {
namespace {

using trace::Kind;

/// The thread whose step it is: a statement of an executed module is one step for each thread that executes
/// it.
ThreadId thread_of(const Problem& problem, StepId step) {
  const auto has = [&](const Thread& thread) {
    return follow(problem, {thread.entry},
                  [step](StepId at) { return at == step ? Course::found : Course::goes_on; });
  };
  const auto thread = std::find_if(problem.threads.begin(), problem.threads.end(), has);
  if (thread == problem.threads.end()) return {};
  return ThreadId(static_cast<std::size_t>(thread - problem.threads.begin()));
}

struct Story {
  const Problem& problem;
  const Requirement& requirement;
  const trace::Trace& trace;
  Origins origins{problem, requirement, trace};
  Narrator narrator{problem, trace};

  /// The event at which the measured statement had its effect; the number of events if there is none.
  std::size_t used_at(const Measurement& measured) const {
    const StatementId of = problem.steps[measured.step].statement;
    const ThreadId thread = thread_of(problem, measured.step);
    for (std::size_t e = trace.events.size(); e-- > 0;) {
      const trace::Event& event = trace.events[e];
      if (event.kind == Kind::done && event.statement == of.value && event.time_ns == measured.at &&
          ThreadId::of(event.actor) == thread)
        return e;
    }
    return trace.events.size();
  }

  /// What a thread knew at an event of the run.
  struct Known {
    ThreadId thread;
    std::size_t event;
  };

  /// The way of what `thread` knew last before event `until`, from its birth to that event, message by
  /// message and condition by condition.
  void known_since(ThreadId thread, std::size_t until, std::vector<Reason>& out) const {
    std::vector<std::vector<Reason>> way;  // the last piece first
    for (std::optional<Known> at = Known{thread, until}; at;) {
      const std::optional<Gained> gained = origins.gained(at->thread, at->event);
      if (!gained) break;
      const Nanoseconds to = trace.events[at->event].time_ns;
      const ThreadId here = at->thread;
      way.emplace_back();
      Nanoseconds from = trace.events[gained->event].time_ns;
      at = source(*gained, from, way.back());
      if (from < to) narrator.tell(here, from, to, way.back());
    }
    for (auto piece = way.rbegin(); piece != way.rend(); ++piece)
      out.insert(out.end(), piece->begin(), piece->end());
  }

  /// The party that had it before the one that gained it, and when; none: it was born there. `from`: since
  /// when it was on the way; what it did then comes to `out`.
  std::optional<Known> source(const Gained& gained, Nanoseconds& from, std::vector<Reason>& out) const {
    const trace::Event& event = trace.events[gained.event];
    if (event.kind == Kind::block) return Known{ThreadId::of(event.actor), gained.event};
    if (event.kind == Kind::read) return since_set(gained.event, gained.what, out);
    if (const auto left = origins.kept_since(gained.event)) return since_left(gained, *left, out);
    const auto put = origins.put_of(gained.event);
    if (!put) return std::nullopt;
    const trace::Event& putting = trace.events[*put];
    from = putting.time_ns;
    if (!narrator.is_device(putting.actor)) return Known{ThreadId::of(putting.actor), *put};
    if (gained.what.born < from) {
      const std::string message = trace.channels[static_cast<std::size_t>(putting.subject)].message;
      out.push_back(narrator.reason(gained.what.born, from, putting.actor,
                                    "takes the sample and gives " + message, -1));
    }
    return std::nullopt;
  }

  /// From where a thread left a message, to the statement of another that uses it.
  std::optional<Known> since_left(const Gained& gained, std::size_t left, std::vector<Reason>& out) const {
    const trace::Event& leaving = trace.events[left];
    const trace::Event& using_it = trace.events[gained.event];
    std::optional<Known> before = Known{ThreadId::of(leaving.actor), left};
    if (leaving.kind == Kind::take) {
      Nanoseconds from = leaving.time_ns;
      before = source({left, gained.what}, from, out);
      if (from < leaving.time_ns) narrator.tell(ThreadId::of(leaving.actor), from, leaving.time_ns, out);
    }
    if (leaving.time_ns < using_it.time_ns) {
      out.push_back(narrator.reason(leaving.time_ns, using_it.time_ns, leaving.actor,
                                    "got it by " + narrator.statement(leaving.statement).text +
                                        "; it ages until " + narrator.statement(using_it.statement).text +
                                        " uses it",
                                    leaving.statement));
      narrator.tell(ThreadId::of(leaving.actor), leaving.time_ns, using_it.time_ns, out.back().inside);
    }
    return before;
  }

  /// From the set of what a condition carries to its being read. The party that set it to a sample knew that
  /// before.
  std::optional<Known> since_set(std::size_t read, const Origin& what, std::vector<Reason>& out) const {
    const trace::Event& reading = trace.events[read];
    const std::string condition = trace.conditions[static_cast<std::size_t>(reading.subject)];
    const std::optional<std::size_t> set = origins.set_of(read);
    const Nanoseconds from = set ? trace.events[*set].time_ns : what.born;
    if (!set) {
      if (from < reading.time_ns)
        out.push_back(
            narrator.reason(from, reading.time_ns, -1, condition + " has had its value since the start", -1));
      return std::nullopt;
    }
    const trace::Event& setting = trace.events[*set];
    if (from < reading.time_ns)
      out.push_back(narrator.reason(from, reading.time_ns, setting.actor,
                                    narrator.statement(setting.statement).text + " gave " + condition +
                                        " its value; it ages until " +
                                        narrator.statement(reading.statement).text + " reads it",
                                    setting.statement));
    if (from < reading.time_ns)
      narrator.tell(
          next_to_set(ConditionId::of(reading.subject), ThreadId::of(setting.actor), reading.time_ns), from,
          reading.time_ns, out.back().inside);
    if (requirement.samples.empty()) return std::nullopt;
    return Known{ThreadId::of(setting.actor), *set};
  }

  /// The party that is to set a condition again: the thread that set it, or a block of it that sets it from
  /// then on.
  ThreadId next_to_set(ConditionId condition, ThreadId setter, Nanoseconds instant) const {
    for (const StepId s : problem.steps.ids()) {
      const Step& step = problem.steps[s];
      if (step.kind != Step::Kind::set || step.condition != condition) continue;
      const ThreadId thread = thread_of(problem, s);
      if (thread.valid() && problem.threads[thread].parent == setter && narrator.is_at_work(thread, instant))
        return thread;
    }
    return setter;
  }

  /// From what just missed the change to what reflects it, then its way.
  void reaction(ThreadId thread, std::size_t use, const Measurement& measured,
                std::vector<Reason>& out) const {
    const std::optional<Gained> gained = origins.gained(thread, use);
    if (!gained) return;
    const Origin& reflected = gained->what;
    if (reflected.born > measured.born) {
      const trace::Event& event = trace.events[reflected.event];
      if (event.kind == Kind::set) {
        narrator.tell(ThreadId::of(event.actor), measured.born, reflected.born, out);
      } else {
        out.push_back(narrator.reason(
            measured.born, reflected.born, event.actor,
            "has just missed the change; the next sample that is reflected comes after this", -1));
      }
    }
    known_since(thread, use, out);
  }

  /// The threads that had the processor, from when it had something to do until it had nothing.
  void busy(const Measurement& measured, std::vector<Reason>& out) const {
    for (const ProcessorId processor : requirement.processors) {
      std::vector<Reason> pieces;
      Nanoseconds at = measured.born;
      for (const trace::Slice& slice : narrator.slices()) {
        const bool here = slice.state == trace::State::running &&
                          problem.threads[ThreadId::of(slice.actor)].processor == processor;
        if (!here || slice.from_ns != at || slice.to_ns == at || slice.to_ns > measured.at) continue;
        pieces.push_back(
            narrator.reason(at, slice.to_ns, slice.actor, narrator.doing(slice), slice.statement));
        at = slice.to_ns;
      }
      if (at != measured.at) continue;
      out = std::move(pieces);
      return;
    }
  }

  /// The way back from a thread at an instant to the event: through the message that last came from another
  /// thread.
  void response(ThreadId thread, std::size_t event, const Measurement& measured, std::vector<Reason>& out,
                int depth) const {
    const Nanoseconds to = trace.events[event].time_ns;
    std::size_t last = trace.events.size();
    std::size_t put = 0;
    for (std::size_t e = event + 1; e-- > 0;) {
      const trace::Event& taking = trace.events[e];
      if (taking.time_ns < measured.born) break;
      if (taking.kind != Kind::take || ThreadId::of(taking.actor) != thread) continue;
      std::size_t from = trace.events.size();
      for (std::size_t p = e; p-- > 0;) {
        const trace::Event& putting = trace.events[p];
        if (putting.kind == Kind::put && putting.subject == taking.subject && putting.value == taking.value) {
          from = p;
          break;
        }
      }
      if (from == trace.events.size()) continue;
      const trace::Event& putting = trace.events[from];
      if (requirement.is_event(ChannelId::of(putting.subject)) && putting.time_ns == measured.born) {
        narrator.tell(thread, measured.born, to, out);
        return;
      }
      const bool by_thread =
          putting.actor >= 0 && !trace.actors[static_cast<std::size_t>(putting.actor)].device;
      if (last == trace.events.size() && by_thread && putting.time_ns >= measured.born) {
        last = e;
        put = from;
      }
    }
    if (last == trace.events.size() || depth == 0) {
      narrator.tell(thread, measured.born, to, out);
      return;
    }
    response(ThreadId::of(trace.events[put].actor), put, measured, out, depth - 1);
    narrator.tell(thread, trace.events[put].time_ns, to, out);
  }
};

}  // namespace

std::vector<Reason> reasons(const Problem& problem, const Requirement& requirement, const Witness& witness) {
  std::vector<Reason> out;
  if (witness.failed || witness.grows) return out;
  const Story story{problem, requirement, witness.trace};
  const Measurement& measured = witness.measured;
  if (requirement.measure == Requirement::Measure::busy) story.busy(measured, out);
  if (!measured.step.valid()) return out;
  const std::size_t use = story.used_at(measured);
  if (use == witness.trace.events.size()) return out;
  const ThreadId thread = ThreadId::of(witness.trace.events[use].actor);
  switch (requirement.measure) {
    case Requirement::Measure::age:
      story.known_since(thread, use, out);
      break;
    case Requirement::Measure::reaction:
      story.reaction(thread, use, measured, out);
      break;
    case Requirement::Measure::response:
      story.response(thread, use, measured, out, 32);
      break;
    case Requirement::Measure::interval:
    case Requirement::Measure::duration:
      story.narrator.tell(thread, measured.born, measured.at, out);
      break;
    case Requirement::Measure::loss:
    case Requirement::Measure::load:
    case Requirement::Measure::busy:
      break;
  }
  return out;
}

}  // namespace pal::analyzer
