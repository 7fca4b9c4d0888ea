#include "analyzer/explain.hpp"

#include <algorithm>
#include <map>

#include "runtime/trace/slices.hpp"

namespace pal::analyzer {
namespace {

using trace::Kind;
using trace::Slice;

struct Story {
  const Problem& problem;
  const trace::Trace& trace;
  std::vector<Slice> slices = trace::slices(trace);

  const trace::Statement& statement(int index) const {
    return trace.statements[static_cast<std::size_t>(index)];
  }

  Reason reason(Nanoseconds from, Nanoseconds to, int actor, std::string what, int of) const {
    Reason made{
        from, to, actor < 0 ? "" : trace.actors[static_cast<std::size_t>(actor)].name, std::move(what),
        "",   0};
    if (of >= 0) {
      made.file = statement(of).file;
      made.line = statement(of).line;
    }
    return made;
  }

  std::string doing(const Slice& slice) const {
    const std::string text = slice.statement < 0 ? "" : statement(slice.statement).text;
    switch (slice.state) {
      case trace::State::running:
        return slice.ending == trace::Ending::preempted ? "runs " + text + " until it is preempted"
                                                        : "runs " + text;
      case trace::State::ready:
        return "is kept from its processor at " + text;
      case trace::State::waiting:
        return "waits at " + text;
      case trace::State::serving:
        return "serves";
    }
    return {};
  }

  /// What a thread did in [from, to], without gaps.
  void tell(int thread, Nanoseconds from, Nanoseconds to, std::vector<Reason>& out) const {
    Nanoseconds at = from;
    for (const Slice& slice : slices) {
      if (slice.actor != thread || slice.to_ns <= at || slice.from_ns >= to) continue;
      if (slice.from_ns > at) out.push_back(reason(at, slice.from_ns, thread, "has not begun", -1));
      const Nanoseconds end = std::min<Nanoseconds>(slice.to_ns, to);
      out.push_back(
          reason(std::max<Nanoseconds>(slice.from_ns, at), end, thread, doing(slice), slice.statement));
      at = end;
    }
    if (at < to) out.push_back(reason(at, to, thread, "waits for its blocks", -1));
  }

  /// The event at which the measured statement had its effect; the number of events if there is none.
  std::size_t used_at(const Measurement& measured) const {
    const int of = problem.steps[static_cast<std::size_t>(measured.step)].statement;
    for (std::size_t e = trace.events.size(); e-- > 0;) {
      const trace::Event& event = trace.events[e];
      if (event.kind == Kind::done && event.statement == of && event.time_ns == measured.at &&
          event.actor >= 0)
        return e;
    }
    return trace.events.size();
  }

  int parent(int thread) const { return problem.threads[static_cast<std::size_t>(thread)].parent; }

  /// The read whose value counts for `thread` at the event with index `before`: its own last, or its
  /// parent's.
  std::size_t last_read(int thread, std::size_t before, int condition) const {
    for (int of = thread; of >= 0; of = parent(of)) {
      for (std::size_t e = before + 1; e-- > 0;) {
        const trace::Event& event = trace.events[e];
        if (event.kind == Kind::read && event.actor == of && event.subject == condition) return e;
      }
    }
    return trace.events.size();
  }

  void age(const Requirement& requirement, const Measurement& measured, std::vector<Reason>& out) const {
    const std::size_t use = used_at(measured);
    if (use == trace.events.size()) return;
    const int thread = trace.events[use].actor;
    const std::size_t read = last_read(thread, use, requirement.condition);
    if (read == trace.events.size()) return;
    const trace::Event& reading = trace.events[read];
    const std::string condition = trace.conditions[static_cast<std::size_t>(requirement.condition)];
    std::string what = condition + " has had its value since the start";
    int setter = -1;
    int set_statement = -1;
    for (std::size_t e = read; e-- > 0;) {
      const trace::Event& event = trace.events[e];
      if (event.kind != Kind::set || event.subject != requirement.condition) continue;
      if (event.time_ns != measured.born) continue;
      setter = event.actor;
      set_statement = event.statement;
      what = statement(event.statement).text + " gave " + condition + " its value; it ages until " +
             statement(reading.statement).text + " reads it";
      break;
    }
    if (reading.time_ns > measured.born) {
      out.push_back(reason(measured.born, reading.time_ns, setter, what, set_statement));
    }
    tell(thread, reading.time_ns, measured.at, out);
  }

  /// The way back from a thread at an instant to the event: through the message that last came from another
  /// thread.
  void response(const Requirement& requirement, int thread, std::size_t event, const Measurement& measured,
                std::vector<Reason>& out, int depth) const {
    const Nanoseconds to = trace.events[event].time_ns;
    std::size_t last = trace.events.size();
    std::size_t put = 0;
    for (std::size_t e = event + 1; e-- > 0;) {
      const trace::Event& taking = trace.events[e];
      if (taking.time_ns < measured.born) break;
      if (taking.kind != Kind::take || taking.actor != thread) continue;
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
      if (putting.subject == requirement.event && putting.time_ns == measured.born) {
        tell(thread, measured.born, to, out);
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
      tell(thread, measured.born, to, out);
      return;
    }
    response(requirement, trace.events[put].actor, put, measured, out, depth - 1);
    tell(thread, trace.events[put].time_ns, to, out);
  }
};

std::string place(const Reason& reason) {
  return reason.line == 0 ? "" : " (line " + std::to_string(reason.line) + ")";
}

std::string list(const std::vector<Reason>& reasons) {
  std::string text;
  for (const Reason& reason : reasons) {
    if (!text.empty()) text += "; ";
    text += milliseconds(reason.to - reason.from) + ": " + (reason.actor.empty() ? "" : reason.actor + " ") +
            reason.what + place(reason);
  }
  return text;
}

/// "TXM( motion to MC1 ) (line 57)"
std::string statement_at(const Problem& problem, const Measurement& measured) {
  const int index = problem.steps[static_cast<std::size_t>(measured.step)].statement;
  const Statement& statement = problem.statements[static_cast<std::size_t>(index)];
  return statement.text + (statement.line == 0 ? "" : " at line " + std::to_string(statement.line));
}

}  // namespace

std::string milliseconds(Nanoseconds time) {
  std::string text = std::to_string(time / 1'000'000);
  std::string digits = std::to_string(time % 1'000'000);
  digits.insert(0, 6 - digits.size(), '0');
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  return text + (digits.empty() ? "" : "." + digits) + " ms";
}

std::vector<Reason> reasons(const Problem& problem, const Requirement& requirement, const Witness& witness) {
  std::vector<Reason> out;
  if (witness.measured.step < 0 || witness.failed) return out;
  const Story story{problem, witness.trace};
  const std::size_t use = story.used_at(witness.measured);
  if (use == witness.trace.events.size()) return out;
  const int thread = witness.trace.events[use].actor;
  switch (requirement.measure) {
    case Requirement::Measure::age:
      story.age(requirement, witness.measured, out);
      break;
    case Requirement::Measure::response:
      story.response(requirement, thread, use, witness.measured, out, 32);
      break;
    case Requirement::Measure::interval:
    case Requirement::Measure::duration:
      story.tell(thread, witness.measured.born, witness.measured.at, out);
      break;
    case Requirement::Measure::reaction:
    case Requirement::Measure::loss:
    case Requirement::Measure::load:
    case Requirement::Measure::busy:
      break;
  }
  return out;
}

namespace {

std::string known_name(const Problem& problem, const Requirement& requirement) {
  if (requirement.samples.empty()) return problem.conditions[static_cast<std::size_t>(requirement.condition)];
  return problem.channels[static_cast<std::size_t>(requirement.samples.front())].message + " of " +
         problem.devices[static_cast<std::size_t>(requirement.device)].name;
}

std::string event_name(const Problem& problem, const Requirement& requirement) {
  return problem.channels[static_cast<std::size_t>(requirement.event)].message + " of " +
         problem.devices[static_cast<std::size_t>(requirement.device)].name;
}

/// The statements of a requirement: "TXM( motion to MC1 )".
std::string statements_of(const Problem& problem, const Requirement& requirement) {
  for (std::size_t s = 0; s < requirement.at.size(); ++s) {
    const int index = problem.steps[s].statement;
    if (requirement.at[s] && index >= 0) return problem.statements[static_cast<std::size_t>(index)].text;
  }
  return "the statement";
}

std::string failure_text(const Problem& problem, const Requirement& requirement, const Witness& witness) {
  const std::string event = event_name(problem, requirement);
  const trace::Event& last = witness.trace.events.back();
  const std::string when = milliseconds(last.time_ns);
  for (const trace::Event& each : witness.trace.events) {
    if (each.kind == Kind::overrun && each.time_ns == last.time_ns && each.subject == requirement.event) {
      return event + " at " + when + " finds the one before still in its channel, and is lost";
    }
  }
  return "at " + when + " a later " + event + " is answered while an earlier one is not";
}

/// What has not come to its end when the run of the witness does.
std::string growing_text(const Problem& problem, const Requirement& requirement,
                         const Measurement& measured) {
  const std::string since = milliseconds(measured.value) + " after " + milliseconds(measured.born);
  switch (requirement.measure) {
    case Requirement::Measure::response:
      return event_name(problem, requirement) + " at " + milliseconds(measured.born) +
             " is still without a response " + milliseconds(measured.value) + " later";
    case Requirement::Measure::reaction:
      return "what changes in the world just after " + milliseconds(measured.born) + " is not reflected by " +
             statements_of(problem, requirement) + " even " + milliseconds(measured.value) + " later";
    case Requirement::Measure::busy:
      return "busy without a pause, still " + since;
    default:
      return statements_of(problem, requirement) + " does not pass again, even " + since;
  }
}

std::string measured_text(const Problem& problem, const Requirement& requirement, const Verdict& verdict) {
  const Measurement& measured = verdict.witness->measured;
  const std::string value = milliseconds(measured.value);
  switch (requirement.measure) {
    case Requirement::Measure::response:
      return statement_at(problem, measured) + " answers " + event_name(problem, requirement) + " after " +
             value;
    case Requirement::Measure::age:
      return statement_at(problem, measured) + " was decided on a value of " +
             known_name(problem, requirement) + " that is then " + value + " old";
    case Requirement::Measure::reaction:
      return "what changes in the world just after " + known_name(problem, requirement) + " at " +
             milliseconds(measured.born) + " is first reflected by " + statement_at(problem, measured) +
             ", " + value + " later";
    case Requirement::Measure::interval:
      return statement_at(problem, measured) + " passes again after " + value;
    case Requirement::Measure::loss:
      return std::to_string(measured.value) + " of " + std::to_string(requirement.in) +
             " in a row are lost at " + milliseconds(measured.at);
    case Requirement::Measure::duration:
      return "the skill completes with " + std::to_string(requirement.code) + " after " + value;
    case Requirement::Measure::busy:
      return "busy without a pause from " + milliseconds(measured.born) + " to " + milliseconds(measured.at);
    case Requirement::Measure::load:
      break;
  }
  return {};
}

}  // namespace

std::string nothing_measured(const Requirement& requirement, bool passed) {
  if (!passed) {
    return requirement.measure == Requirement::Measure::loss ? "the device never sends anything in any run"
                                                             : "no run ever gets there";
  }
  switch (requirement.measure) {
    case Requirement::Measure::age:
      return "no run gets there with a value that it has read";
    case Requirement::Measure::reaction:
      return "no run gets there with a second value";
    case Requirement::Measure::interval:
      return "no run gets there twice";
    default:
      return "no run gets there because of the event";
  }
}

std::string explanation(const Problem& problem, const Requirement& requirement, const Verdict& verdict) {
  if (!verdict.witness) {
    if (!verdict.bound) return "no run was found that shows how long it can take";
    if (verdict.exact) return "it never is";
    return std::string("no run takes ") + (requirement.at_least ? "less" : "longer") + " than " +
           milliseconds(verdict.bound->count()) + "; none was found that takes as " +
           (requirement.at_least ? "little" : "long");
  }
  const Witness& witness = *verdict.witness;
  if (witness.failed) return failure_text(problem, requirement, witness);
  if (witness.grows) return growing_text(problem, requirement, witness.measured);
  const std::string text = measured_text(problem, requirement, verdict);
  return verdict.reasons.empty() ? text : text + ". " + list(verdict.reasons);
}

}  // namespace pal::analyzer
