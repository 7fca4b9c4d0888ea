#include "programs/pal/session/measure_text.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

#include "pal/support/duration_text.hpp"

namespace pal::program {
namespace {

using Measure = analyzer::Requirement::Measure;

/// The distinct statements that a requirement is about: "TXM( motion to MC1 ) in SM1".
std::string statements_text(const analyzer::Problem& problem, const analyzer::Requirement& requirement) {
  std::set<std::string> texts;
  // Mostly few of very many steps.
  const auto begin = requirement.at.begin(), end = requirement.at.end();
  for (auto at = std::find(begin, end, true); at != end; at = std::find(at + 1, end, true)) {
    const analyzer::StepId step(static_cast<std::size_t>(at - begin));
    if (!problem.steps[step].statement.valid()) continue;
    const auto& statement = problem.statements[problem.steps[step].statement];
    texts.insert(statement.text + " in " + statement.module);
  }
  std::string result;
  for (const std::string& text : texts) result += (result.empty() ? "" : " and ") + text;
  return result;
}

std::string known_text(const analyzer::Problem& problem, const analyzer::Requirement& requirement) {
  if (requirement.samples.empty()) return problem.conditions[requirement.condition];
  return problem.channels[requirement.samples.front()].message + " from " +
         problem.devices[requirement.device].name;
}

std::string event_text(const analyzer::Problem& problem, const analyzer::Requirement& requirement) {
  return problem.channels[requirement.events.front()].message;
}

std::string processor_text(const analyzer::Problem& problem, const analyzer::Requirement& requirement) {
  if (requirement.processors.size() != 1) return "each processor";
  return problem.processors[requirement.processors.front()].name;
}

std::string whole_run_text(const analyzer::Problem& problem, const analyzer::Requirement& requirement) {
  switch (requirement.measure) {
    case Measure::age:
      return "age of " + known_text(problem, requirement) + " at " + statements_text(problem, requirement);
    case Measure::reaction:
      return "reaction of " + known_text(problem, requirement) + " at " +
             statements_text(problem, requirement);
    case Measure::response:
      return "response from " + event_text(problem, requirement) + " of " +
             analyzer::sender_name(problem, requirement.events.front()) + " to " +
             statements_text(problem, requirement);
    case Measure::interval:
      return std::string(requirement.at_least ? "least" : "greatest") + " interval of " +
             statements_text(problem, requirement);
    case Measure::loss:
      return "loss of " + problem.devices[requirement.device].name +
             (requirement.in == 1 ? "" : " in " + std::to_string(requirement.in));
    case Measure::duration:
      return "duration to completion " + std::to_string(requirement.code);
    case Measure::busy:
      return "busy period of " + processor_text(problem, requirement);
    case Measure::load:
      break;
  }
  return "load of " + processor_text(problem, requirement);
}

}  // namespace

std::string measure_text(const analyzer::Problem& problem, std::size_t index) {
  const analyzer::Requirement& requirement = problem.requirements[index];
  const std::string text = whole_run_text(problem, requirement);
  return requirement.phase.limits() ? text + ", " + requirement.phase.text : text;
}

std::string short_measure_text(const analyzer::Problem& problem, std::size_t index) {
  const analyzer::Requirement& requirement = problem.requirements[index];
  const std::string known = requirement.condition.valid() ? problem.conditions[requirement.condition]
                            : requirement.samples.empty()
                                ? std::string()
                                : problem.channels[requirement.samples.front()].message;
  switch (requirement.measure) {
    case Measure::age:
      return "age of " + known;
    case Measure::reaction:
      return "reaction to " + known;
    case Measure::response:
      return "response to " + event_text(problem, requirement);
    case Measure::interval:
      return "interval";
    case Measure::duration:
      return "duration";
    case Measure::busy:
      return "busy period";
    case Measure::loss:
    case Measure::load:
      break;
  }
  return {};
}

analyzer::Figure figure_of(Measure measure, Duration value) {
  return {analyzer::unit_of(measure), value.count()};
}

std::string text(analyzer::Figure figure) {
  if (figure.unit == analyzer::Figure::Unit::count)
    return figure.value == 0 ? "none" : std::to_string(figure.value);
  if (figure.unit == analyzer::Figure::Unit::time) return to_text(Duration(figure.value));
  const auto hundredths = (figure.value + 99'999) / 100'000;  // 1e9 ns in a second are 100.00 %
  const std::string fraction = std::to_string(hundredths % 100);
  return std::to_string(hundredths / 100) +
         (hundredths % 100 == 0 ? "" : (fraction.size() < 2 ? ".0" : ".") + fraction) + " %";
}

std::string whole_text(analyzer::Figure figure) {
  if (figure.unit != analyzer::Figure::Unit::share) return text(figure);
  constexpr std::int64_t percent = 10'000'000;  // nanoseconds in a second
  std::string digits = std::to_string(percent + figure.value % percent).substr(1);
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  return std::to_string(figure.value / percent) + (digits.empty() ? "" : "." + digits) + " %";
}

std::optional<Duration> worth_telling(const analyzer::Verdict& verdict) {
  const auto shown = attained(verdict);
  return shown && (verdict.at_least || shown->count() > 0) ? shown : std::nullopt;
}

std::string bound_text(const analyzer::Verdict& verdict) {
  using State = analyzer::VerdictState;
  if (verdict.state == State::never) return verdict.measure == Measure::load ? "ends" : "never";
  if (!verdict.bound) {
    const auto shown = worth_telling(verdict);
    if (shown && !verdict.loop_growth)
      return (verdict.at_least ? "<= " : ">= ") + text(figure_of(verdict.measure, *shown));
    return verdict.state == State::undecided ? "no bound" : "unbounded";
  }
  return (verdict.exact      ? ""
          : verdict.at_least ? ">= "
                             : "<= ") +
         text(figure_of(verdict.measure, *verdict.bound));
}

}  // namespace pal::program
