#include "server/line_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace pal::server {
namespace {

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// As the parameter's type has it. Nothing: it is no such value.
std::optional<operations::Value> typed_value(const std::string& text, pan::ScalarType type) {
  if (type == pan::ScalarType::text) return text;
  if (type == pan::ScalarType::boolean) {
    if (text == "1" || text == "true") return true;
    if (text == "0" || text == "false") return false;
    return std::nullopt;
  }
  if (const auto value = number_in(text)) return *value;
  return std::nullopt;
}

}  // namespace

Words words_of(const std::string& line) {
  std::istringstream in(line);
  Words words;
  for (std::string word; in >> word;) words.push_back(std::move(word));
  return words;
}

FromWords<RunSkill> run_skill_of(const pan::Template& skill, const Words& words) {
  RunSkill command{words.front(), {}};
  for (std::size_t i = 1; i < words.size(); ++i) {
    // name=value, or a value at the place of its parameter.
    const std::size_t equals = words[i].find('=');
    const std::string name = equals == std::string::npos ? "" : words[i].substr(0, equals);
    const auto parameter =
        equals == std::string::npos
            ? skill.parameters.begin() + static_cast<std::ptrdiff_t>(std::min(i - 1, skill.parameters.size()))
            : std::find_if(skill.parameters.begin(), skill.parameters.end(),
                           [&](const pan::Parameter& each) { return each.name == name; });
    if (parameter == skill.parameters.end())
      return name.empty() ? fmt::format("{} has {} parameters", skill.name, skill.parameters.size())
                          : fmt::format("{} has no parameter '{}'", skill.name, name);
    const auto value =
        typed_value(equals == std::string::npos ? words[i] : words[i].substr(equals + 1), parameter->type);
    if (!value) return fmt::format("'{}' is no value of {}", words[i], parameter->name);
    command.parameters.push_back({parameter->name, *value, {}, {}});
  }
  return command;
}

SetParameter set_parameter_of(const Words& words) {
  if (words[3] == "true" || words[3] == "false") return {words[1], words[2], words[3] == "true"};
  if (const auto value = number_in(words[3])) return {words[1], words[2], *value};
  return {words[1], words[2], words[3]};
}

FromWords<SetBreakpoint> set_breakpoint_of(const Words& words) {
  operations::Breakpoint breakpoint{words[1], {}};
  if (words.size() == 3) {
    const auto code = number_in(words[2]);
    if (!code || !(std::abs(*code) <= 1e6)) return std::string("a completion code is a whole number");
    breakpoint.code = static_cast<int>(*code);
  }
  return SetBreakpoint{std::move(breakpoint)};
}

AnswerQuestion answer_of(const Words& words) {
  const auto place = number_in(words[2]);
  if (words.size() == 3 && place && *place >= 0 && *place <= 1000)
    return {words[1], static_cast<std::size_t>(*place)};
  std::string text;
  for (std::size_t i = 2; i < words.size(); ++i) text += (i == 2 ? "" : " ") + words[i];
  return {words[1], text};
}

}  // namespace pal::server
