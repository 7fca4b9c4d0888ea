#include "operations/happened.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pal::operations {
namespace {

constexpr std::size_t most_told = 50;

double in_seconds(Duration time) {
  return static_cast<double>(time.count()) / 1e9;
}

std::string times(std::size_t count) {
  return count == 1 ? "once" : count == 2 ? "twice" : fmt::format("{} times", count);
}

std::string reason(const Step& step) {
  std::string text = step.result.reason;
  if (text.ends_with('.')) text.pop_back();
  return text.empty() ? "" : ": " + text;
}

/// "ended with code 0: The tool touches the surface"
std::string ending(const Step& step) {
  if (step.result.kind == SkillResult::Kind::stopped) return "was cut off" + reason(step);
  return fmt::format("ended with code {}{}", step.result.code, reason(step));
}

/// "took 1.20 s, read 5.00 from eye and ended with code 0: The tool touches the surface"
std::string course_of(const Step& step) {
  const std::string length = fmt::format("took {:.2f} s", in_seconds(step.end - step.begin));
  if (step.skill.empty() && step.sensor.empty() && step.question.empty() &&
      step.result.kind != SkillResult::Kind::stopped)
    return length;
  std::string reading = step.reading ? fmt::format(", read {:.2f} from {}", *step.reading, step.sensor) : "";
  for (const Figure& each : step.readings)
    reading += fmt::format(", read {:.2f} from {}", each.value, each.name);
  if (!step.answer.empty()) reading += fmt::format(", was answered \"{}\"", step.answer);
  return fmt::format("{}{} and {}", length, reading, ending(step));
}

}  // namespace

Happened::Happened(const Program& program, const std::vector<Step>& steps)
    : program_(program), steps_(steps) {
  for (std::size_t i = 0; i < steps.size(); ++i)
    for (const Place& place : find_path(program, steps[i].icon)) steps_at_[place].push_back(i);
}

std::string Happened::summary() const {
  if (steps_.empty()) return "In the run nothing happened.";
  const Duration begin = steps_.front().begin, end = steps_.back().end;
  return fmt::format("The run had {} step{}, from {:.2f} s to {:.2f} s of the cell's time: {:.2f} s.",
                     steps_.size(), steps_.size() == 1 ? "" : "s", in_seconds(begin), in_seconds(end),
                     in_seconds(end - begin));
}

std::vector<std::string> Happened::course() const {
  std::vector<std::string> result;
  for (const Step& step : steps_) {
    if (result.size() == most_told) {
      result.push_back(fmt::format("{} more steps followed.", steps_.size() - most_told));
      break;
    }
    const std::string skill =
        step.skill.empty() || step.skill == step.icon ? "" : fmt::format(" ({})", step.skill);
    result.push_back(fmt::format("At {:.2f} s {}{} began, {}.", in_seconds(step.begin), step.icon, skill,
                                 course_of(step)));
  }
  return result;
}

std::size_t Happened::count(Place place) const {
  const auto found = steps_at_.find(place);
  return found == steps_at_.end() ? 0 : found->second.size();
}

std::string Happened::at(Place place) const {
  const auto found = steps_at_.find(place);
  if (found == steps_at_.end()) return "In the run the token did not come here.";
  const std::vector<std::size_t>& here = found->second;
  if (program_.operations[place.operation].icons[place.icon].kind == IconKind::sub_operation)
    return fmt::format("In the run {} step{} inside, from {:.2f} s on.", here.size(),
                       here.size() == 1 ? " was" : "s were", in_seconds(steps_[here.front()].begin));
  const auto length = [&](std::size_t i) { return steps_[i].end - steps_[i].begin; };
  if (here.size() == 1)
    return fmt::format("In the run it began at {:.2f} s, {}.", in_seconds(steps_[here.front()].begin),
                       course_of(steps_[here.front()]));
  std::map<int, std::size_t> codes;
  std::size_t cut_off = 0;
  for (const std::size_t i : here) {
    if (steps_[i].has_code()) ++codes[steps_[i].result.code];
    if (steps_[i].result.kind == SkillResult::Kind::stopped) ++cut_off;
  }
  std::vector<std::string> endings;
  for (const auto& [code, count] : codes) endings.push_back(fmt::format("code {} {}", code, times(count)));
  if (cut_off > 0) endings.push_back("cut off " + times(cut_off));
  const auto [shortest, longest] = std::minmax_element(
      here.begin(), here.end(), [&](std::size_t a, std::size_t b) { return length(a) < length(b); });
  return fmt::format("In the run it began {}, first at {:.2f} s; it took {:.2f} to {:.2f} s{}{}.",
                     times(here.size()), in_seconds(steps_[here.front()].begin),
                     in_seconds(length(*shortest)), in_seconds(length(*longest)), endings.empty() ? "" : "; ",
                     fmt::join(endings, ", "));
}

}  // namespace pal::operations
