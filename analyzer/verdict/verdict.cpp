#include "analyzer/verdict/verdict.hpp"

#include <algorithm>

namespace pal::analyzer {

Statistics& Statistics::operator+=(const Statistics& other) {
  states += other.states;
  classes += other.classes;
  seconds += other.seconds;
  peak_memory = std::max(peak_memory, other.peak_memory);
  return *this;
}

Limit Verdict::allowed() const {
  return {at_least ? Limit::Sense::at_least : Limit::Sense::at_most, {unit_of(measure), limit.count()}};
}

Verdict open_verdict(const Requirement& requirement) {
  Verdict verdict;
  verdict.requirement = requirement.name;
  verdict.measure = requirement.measure;
  verdict.limit = Duration(requirement.limit);
  verdict.at_least = requirement.at_least;
  verdict.where = requirement.where;
  return verdict;
}

std::optional<Duration> attained(const Verdict& verdict) {
  if (verdict.measure == Requirement::Measure::load) return verdict.attained_load;
  if (!verdict.witness || verdict.witness->failed) return std::nullopt;
  return Duration(verdict.witness->measured.value);
}

const char* name(Verdict::State state) {
  switch (state) {
    case Verdict::State::holds:
      return "holds";
    case Verdict::State::fails:
      return "fails";
    case Verdict::State::undecided:
      return "undecided";
    case Verdict::State::never:
      return "never";
  }
  return "";
}

const char* name(Requirement::Measure measure) {
  switch (measure) {
    case Requirement::Measure::age:
      return "age";
    case Requirement::Measure::response:
      return "response";
    case Requirement::Measure::load:
      return "load";
    case Requirement::Measure::reaction:
      return "reaction";
    case Requirement::Measure::interval:
      return "interval";
    case Requirement::Measure::loss:
      return "loss";
    case Requirement::Measure::duration:
      return "duration";
    case Requirement::Measure::busy:
      return "busy";
  }
  return "";
}

const char* name(Method method) {
  return method == Method::exact ? "exact" : "compositional";
}

}  // namespace pal::analyzer
