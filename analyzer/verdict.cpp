#include "analyzer/verdict.hpp"

namespace pal::analyzer {

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
