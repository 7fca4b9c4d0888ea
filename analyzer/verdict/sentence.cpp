#include "analyzer/verdict/sentence.hpp"

#include <utility>

namespace pal::analyzer {
namespace {

using trace::Kind;

/// So many pieces of a long story are told from its beginning, and as many up to its end.
constexpr std::ptrdiff_t told_at_each_end = 20;

Told place(const Reason& reason) {
  return reason.line == 0 ? Told() : " (line " + Told::line(reason.file, reason.line) + ")";
}

Told list(const std::vector<Reason>& reasons) {
  Told text;
  bool first = true;
  Nanoseconds sum = 0;
  for (const Reason& reason : abridged(reasons)) {
    if (!std::exchange(first, false)) text += "; + ";
    text += milliseconds(reason.to - reason.from) + ": " + (reason.actor.empty() ? "" : reason.actor + " ") +
            reason.what + place(reason);
    sum += reason.to - reason.from;
  }
  return text + (reasons.size() > 1 ? "; = " + milliseconds(sum) : "");
}

/// "TXM( motion to MC1 ) at line 57"
Told statement_at(const Problem& problem, const Measurement& measured) {
  const StatementId index = problem.steps[measured.step].statement;
  const Statement& statement = problem.statements[index];
  return statement.text +
         (statement.line == 0 ? Told() : " at line " + Told::line(statement.file, statement.line));
}

}  // namespace

std::vector<Reason> abridged(const std::vector<Reason>& reasons) {
  const auto size = static_cast<std::ptrdiff_t>(reasons.size());
  if (size <= 2 * told_at_each_end + 1) return reasons;
  const auto first = reasons.begin() + told_at_each_end;
  const auto last = reasons.end() - told_at_each_end;
  std::vector<Reason> told(reasons.begin(), first);
  Reason& between = told.emplace_back();
  between.from = first->from;
  for (auto each = first; each != last; ++each) between.to += each->to - each->from;
  between.to += between.from;
  between.what = std::to_string(last - first) + " more, one after the other";
  told.insert(told.end(), last, reasons.end());
  return told;
}

std::string milliseconds(Nanoseconds time) {
  std::string text = std::to_string(time / 1'000'000);
  std::string digits = std::to_string(time % 1'000'000);
  digits.insert(0, 6 - digits.size(), '0');
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  return text + (digits.empty() ? "" : "." + digits) + " ms";
}

namespace {

std::string known_name(const Problem& problem, const Requirement& requirement) {
  if (requirement.samples.empty()) return problem.conditions[requirement.condition];
  return problem.channels[requirement.samples.front()].message + " of " +
         problem.devices[requirement.device].name;
}

std::string event_name(const Problem& problem, const Requirement& requirement) {
  const ChannelId channel = requirement.events.front();
  return problem.channels[channel].message + " of " + sender_name(problem, channel);
}

/// The statements of a requirement: "TXM( motion to MC1 )".
std::string statements_of(const Problem& problem, const Requirement& requirement) {
  for (const StepId s : requirement.at.ids()) {
    const StatementId index = problem.steps[s].statement;
    if (requirement.at[s] && index.valid()) return problem.statements[index].text;
  }
  return "the statement";
}

std::string failure_text(const Problem& problem, const Requirement& requirement, const Witness& witness) {
  const std::string event = event_name(problem, requirement);
  const trace::Event& last = witness.trace.events.back();
  const std::string when = milliseconds(last.time_ns);
  for (const trace::Event& each : witness.trace.events) {
    if (each.kind == Kind::overrun && each.time_ns == last.time_ns &&
        requirement.is_event(ChannelId::of(each.subject))) {
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

Told measured_text(const Problem& problem, const Requirement& requirement, const Verdict& verdict) {
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
      return "what changes in the world just after " +
             (requirement.phase.limits() ? "" : known_name(problem, requirement) + " at ") +
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

std::string nothing_in_run(const Requirement& requirement, bool passed) {
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
    case Requirement::Measure::duration:
      return "no run completes the skill with this code";
    default:
      return "no run gets there because of the event";
  }
}

}  // namespace

std::string nothing_measured(const Requirement& requirement, bool passed) {
  if (requirement.measure == Requirement::Measure::load)
    return "every run ends, and a load is that of the long run";
  const std::string text = nothing_in_run(requirement, passed);
  return requirement.phase.limits() ? text + " " + requirement.phase.text : text;
}

Told explanation(const Problem& problem, const Requirement& requirement, const Verdict& verdict) {
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
  const Told text = measured_text(problem, requirement, verdict);
  return verdict.reasons.empty() ? text : text + ". " + list(verdict.reasons);
}

}  // namespace pal::analyzer
