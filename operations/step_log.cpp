#include "operations/step_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

namespace pal::operations {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kinds{"normal", "contingency", "error", "stopped"};

double seconds(Duration time) {
  return static_cast<double>(time.count()) / 1e9;
}

Duration duration(double seconds) {
  return Duration(static_cast<std::int64_t>(std::llround(seconds * 1e9)));
}

std::optional<Value> value_of(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return std::nullopt;
}

/// Throws Json::exception for what is not of its type.
std::vector<Figure> figures_of(const Json& json) {
  std::vector<Figure> result;
  for (const auto& [name, value] : json.items()) result.push_back({name, value.get<double>()});
  return result;
}

Json json_of(const std::vector<Figure>& figures) {
  Json json = Json::object();
  for (const Figure& figure : figures) json[figure.name] = figure.value;
  return json;
}

/// Throws Json::exception for what is not of its type.
std::optional<Step> step_of(const Json& line) {
  Step step;
  step.number = line.at("step").get<std::size_t>();
  step.icon = line.at("icon").get<std::string>();
  step.skill = line.value("skill", "");
  step.sensor = line.value("sensor", "");
  const Json parameters = line.value("parameters", Json::object());
  if (!parameters.is_object()) return std::nullopt;
  for (const auto& [name, json] : parameters.items()) {
    const auto value = value_of(json);
    if (!value) return std::nullopt;
    step.parameters.push_back({name, *value, {}, {}});
  }
  if (const auto reading = line.find("reading"); reading != line.end() && !reading->is_null())
    step.reading = reading->get<double>();
  step.question = line.value("question", "");
  step.answer = line.value("answer", "");
  step.readings = figures_of(line.value("readings", Json::object()));
  step.result.figures = figures_of(line.value("figures", Json::object()));
  step.result.measured = figures_of(line.value("measured", Json::object()));
  const auto kind = std::find(kinds.begin(), kinds.end(), line.value("kind", "normal"));
  if (kind == kinds.end()) return std::nullopt;
  step.result.kind = static_cast<SkillResult::Kind>(kind - kinds.begin());
  step.result.code = line.value("code", 0);
  step.result.reason = line.value("reason", "");
  const auto begin = line.at("begin_s").get<double>();
  const auto end = line.at("end_s").get<double>();
  constexpr double longest = 9e9;  // s; Duration ends there
  if (!(begin >= 0 && begin <= end && end <= longest)) return std::nullopt;
  step.begin = duration(begin);
  step.end = duration(end);
  return step;
}

}  // namespace

std::optional<Step> parse_log_line(const std::string& line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    return step_of(json);
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string log_line(const Step& step) {
  Json line;
  line["step"] = step.number;
  line["icon"] = step.icon;
  if (!step.skill.empty()) {
    line["skill"] = step.skill;
    line["parameters"] = Json::object();
    for (const Parameter& parameter : step.parameters)
      std::visit([&](const auto& value) { line["parameters"][parameter.name] = value; }, parameter.value);
  }
  if (!step.sensor.empty()) {
    line["sensor"] = step.sensor;
    if (!step.readings.empty()) {
      line["readings"] = json_of(step.readings);
    } else {
      line["reading"] = nullptr;
      if (step.reading) line["reading"] = *step.reading;
    }
  }
  if (!step.question.empty()) {
    line["question"] = step.question;
    line["answer"] = step.answer;
  }
  if (!step.result.figures.empty()) line["figures"] = json_of(step.result.figures);
  if (!step.result.measured.empty()) line["measured"] = json_of(step.result.measured);
  if (step.has_code() || step.result.kind == SkillResult::Kind::stopped) {
    line["kind"] = kinds[static_cast<std::size_t>(step.result.kind)];
    line["code"] = step.result.code;
    line["reason"] = step.result.reason;
  }
  line["begin_s"] = seconds(step.begin);
  line["end_s"] = seconds(step.end);
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string told(const Step& step) {
  const std::string begin = fmt::format("{:4}  {}: ", step.number, step.icon);
  const double length = seconds(step.end - step.begin);
  const std::string reason = step.result.reason.empty() ? "" : ": " + step.result.reason;
  const bool stopped = step.result.kind == SkillResult::Kind::stopped;
  if (!step.question.empty())
    return begin + (stopped ? fmt::format("asked, cut off after {:.3f} s", length)
                            : fmt::format("{}, code {} after {:.3f} s{}",
                                          step.answer.empty() ? "no answer" : "answered " + step.answer,
                                          step.result.code, length, reason));
  if (step.skill.empty() && step.sensor.empty())
    return begin + fmt::format("{} {:.3f} s", stopped ? "cut off after" : "waited", length);
  std::string what = step.skill;
  if (!step.sensor.empty())
    what = step.reading ? fmt::format("{} shows {:.2f}", step.sensor, *step.reading) : step.sensor;
  for (const Figure& each : step.readings)
    what = fmt::format("{}{} shows {:.2f}", &each == &step.readings.front() ? "" : what + ", ", each.name,
                       each.value);
  if (stopped && !step.sensor.empty()) return begin + fmt::format("{}, cut off after {:.3f} s", what, length);
  return begin + fmt::format("{}{} code {} after {:.3f} s{}", what, step.sensor.empty() ? " ended with" : ",",
                             step.result.code, length, reason);
}

std::string told(const std::string& state, const std::string& token, std::size_t steps,
                 const std::string& reason) {
  const std::string after = fmt::format("after {} step{}", steps, steps == 1 ? "" : "s");
  if (reason.empty()) return fmt::format("{} at {} {}", state, token.empty() ? "-" : token, after);
  if (reason.starts_with(state)) return fmt::format("{} {}", reason, after);
  return fmt::format("{} {}: {}", state, after, reason);
}

void StepLog::done(const Step& step) {
  out_ << log_line(step) << '\n' << std::flush;
}

}  // namespace pal::operations
