#include "server/line_events.hpp"

#include <fmt/format.h>

#include <variant>

namespace pal::server {
namespace {

/// The skill or the sensor; of a delay "-".
std::string subject(const operations::Step& step) {
  const std::string& what = step.skill.empty() ? step.sensor : step.skill;
  return what.empty() ? "-" : what;
}

struct EventWords {
  std::string operator()(const ControlsChanged& what) const {
    return "controls " + (what.holder.empty() ? "-" : what.holder);
  }
  std::string operator()(const ControlsAsked& what) const { return "asked " + what.name; }
  std::string operator()(const ClientsChanged& what) const {
    return fmt::format("clients {}", what.clients.size());
  }
  std::string operator()(const HoldChanged& what) const {
    return "hold " + (what.hold ? what.hold->by + " " + what.hold->reason : "-");
  }
  std::string operator()(const OperationLoaded& what) const { return "loaded " + what.name; }
  std::string operator()(const StateChanged& what) const {
    return fmt::format("state {} {} {}", operations::name(what.state), what.token, what.reason);
  }
  std::string operator()(const HaltAsked& what) const {
    return fmt::format("{} {}", what.stopping ? "stopping" : "pausing", what.by);
  }
  std::string operator()(const IconReached& what) const { return "icon " + what.icon; }
  std::string operator()(const StepBegins& what) const {
    return fmt::format("begins {} {} {}", what.step.number, what.step.icon.empty() ? "-" : what.step.icon,
                       subject(what.step));
  }
  std::string operator()(const StepEnds& what) const {
    return fmt::format("ends {} {} {} {}", what.step.number, what.step.icon.empty() ? "-" : what.step.icon,
                       subject(what.step), what.step.result.code);
  }
  std::string operator()(const ParameterSet& what) const {
    return fmt::format("set {} {} {}", what.icon, what.parameter, operations::to_text(what.value));
  }
  std::string operator()(const BreakpointsChanged& what) const {
    return fmt::format("breakpoints {}", what.breakpoints.size());
  }
  std::string operator()(const QuestionAsked& what) const {
    std::string text = "question " + what.question.question.icon + " " + what.question.question.text;
    for (const std::string& answer : what.question.question.answers) text += " | " + answer;
    return text;
  }
  std::string operator()(const QuestionClosed& what) const {
    return fmt::format("answered {} {}", what.icon, what.answer.value_or("-"));
  }
  std::string operator()(const StoreChanged& what) const {
    return fmt::format("stored {} {}", what.name, what.version);
  }
  std::string operator()(const LocationChanged& what) const { return "location " + what.location; }
  std::string operator()(const ServerEnds& what) const { return "ending " + what.reason; }
};

}  // namespace

std::string event_line(const Event& event) {
  return fmt::format("*{} {}", event.number, std::visit(EventWords{}, event.what));
}

}  // namespace pal::server
