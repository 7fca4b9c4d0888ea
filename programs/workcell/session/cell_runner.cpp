#include "programs/workcell/session/cell_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "operations/icon_times.hpp"
#include "pal/support/duration_text.hpp"
#include "programs/workcell/session/needed_tool.hpp"
#include "sim/cell/sensor_range.hpp"

namespace pal::workcell {
namespace {

using operations::SkillResult;

pan::ScalarType type_of(runtime::ParameterType type) {
  switch (type) {
    case runtime::ParameterType::integer:
      return pan::ScalarType::integer;
    case runtime::ParameterType::boolean:
      return pan::ScalarType::boolean;
    case runtime::ParameterType::text:
      return pan::ScalarType::text;
    case runtime::ParameterType::real:
      break;
  }
  return pan::ScalarType::real;
}

pan::Completion::Kind kind_of(runtime::CompletionSpec::Kind kind) {
  switch (kind) {
    case runtime::CompletionSpec::Kind::contingency:
      return pan::Completion::Kind::contingency;
    case runtime::CompletionSpec::Kind::error:
      return pan::Completion::Kind::error;
    case runtime::CompletionSpec::Kind::normal:
      break;
  }
  return pan::Completion::Kind::normal;
}

pan::Template template_of(const runtime::SkillDescription& description) {
  pan::Template result;
  result.name = description.name;
  for (const std::string_view text : description.descriptions) result.descriptions.emplace_back(text);
  for (const runtime::ParameterSpec& spec : description.parameters) {
    pan::Parameter parameter;
    parameter.name = spec.name;
    parameter.type = type_of(spec.type);
    parameter.location = spec.location;
    parameter.unit = spec.unit;
    parameter.low = spec.low;
    parameter.high = spec.high;
    parameter.default_value = spec.default_value;
    parameter.default_text = spec.default_text;
    parameter.description = spec.description;
    result.parameters.push_back(std::move(parameter));
  }
  for (const runtime::CompletionSpec& spec : description.completions) {
    pan::Completion completion;
    completion.code = spec.code;
    completion.kind = kind_of(spec.kind);
    completion.description = spec.description;
    result.completions.push_back(std::move(completion));
  }
  return result;
}

runtime::ParameterValue value_of(const operations::Parameter& parameter) {
  if (const auto* text = std::get_if<std::string>(&parameter.value))
    return {.name = parameter.name, .text = *text};
  if (const auto* truth = std::get_if<bool>(&parameter.value)) return {parameter.name, *truth ? 1.0 : 0.0};
  return {parameter.name, std::get<double>(parameter.value)};
}

/// With the first promise that was broken, unless the skill has ended because of it.
std::string reason_of(const runtime::Outcome& outcome) {
  if (outcome.broken_promises.empty()) return outcome.reason;
  const runtime::BrokenPromise& broken = outcome.broken_promises.front();
  if (outcome.reason.find(broken.promise) != std::string::npos) return outcome.reason;
  const std::size_t others = outcome.broken_promises.size() - 1;
  return fmt::format("{}{} broken promise: {}{}", outcome.reason, outcome.reason.ends_with('.') ? "" : ";",
                     runtime::in_words(broken), others == 0 ? "" : fmt::format("; and {} more", others));
}

SkillResult::Kind kind_of(const runtime::Skill& skill, const runtime::Outcome& outcome) {
  if (outcome.fault) return SkillResult::Kind::error;
  for (const runtime::CompletionSpec& completion : skill.description().completions) {
    if (completion.code != outcome.code) continue;
    if (completion.kind == runtime::CompletionSpec::Kind::normal) return SkillResult::Kind::normal;
    if (completion.kind == runtime::CompletionSpec::Kind::contingency) return SkillResult::Kind::contingency;
  }
  return SkillResult::Kind::error;
}

/// A skill looks at its values when it begins; this begins one of its own, which goes no further.
operations::RefusedTogether refused_together(const std::vector<KnownSkill>& skills) {
  return [&skills](const std::string& name,
                   const std::vector<operations::Parameter>& given) -> std::optional<std::string> {
    const auto known =
        std::find_if(skills.begin(), skills.end(), [&](const KnownSkill& each) { return each.name == name; });
    if (known == skills.end()) return std::nullopt;
    const auto skill = known->make();
    try {
      skill->reset_parameters();
      for (const operations::Parameter& each : given) {
        const runtime::ParameterValue value = value_of(each);
        if (value.text)
          skill->set_text_parameter(value.name, *value.text);
        else
          skill->set_parameter(value.name, value.value);
      }
      skill->start();
    } catch (const runtime::ParameterError& problem) {
      return problem.what();
    }
    return std::nullopt;
  };
}

}  // namespace

operations::Skills templates_of(const std::vector<KnownSkill>& skills) {
  operations::Skills result;
  for (const KnownSkill& known : skills) result.emplace(known.name, template_of(known.make()->description()));
  return result;
}

operations::DeclaredTimes longest_of(const std::vector<KnownSkill>& skills) {
  operations::DeclaredTimes result;
  for (const KnownSkill& known : skills)
    for (const auto& [code, time] : known.declared.longest)
      result.emplace(std::pair(known.name, code), time.seconds);
  return result;
}

operations::Sensors sensors_of(const sim::Cell& cell) {
  operations::Sensors result;
  for (const sim::SensorSpec& sensor : cell.sensors())
    result[sensor.name] = {sensor.unit, sensor.description, sim::sensor_range(sensor.name)};
  return result;
}

std::set<std::string> locations_of(sim::Cell& cell) {
  std::set<std::string> result;
  for (const auto& [name, place] : cell.val_store().locations) result.insert(name);
  return result;
}

operations::Cell cell_of(sim::Cell& cell, const std::vector<KnownSkill>& skills, const sim::Scene& scene,
                         const std::vector<std::string>& folders) {
  operations::Cell result{
      templates_of(skills), sensors_of(cell),        figures_of_skills(), locations_of(cell), {},
      longest_of(skills),   refused_together(skills)};
  for (const KnownSkill& known : skills)
    if (const auto why = lacking_tool(*known.make(), scene, folders)) result.unable.emplace(known.name, *why);
  return result;
}

CellRunner::CellRunner(sim::Cell& cell, const std::vector<KnownSkill>& skills, runtime::CostPolicy times,
                       std::uint64_t seed, OnInterrupt on_interrupt, runtime::MessageObserver* messages)
    : cell_(cell),
      known_(skills),
      templates_(templates_of(skills)),
      longest_(longest_of(skills)),
      times_(times),
      seed_(seed),
      on_interrupt_(on_interrupt),
      figures_(messages) {
  take_new_control();
}

void CellRunner::take_new_control() {
  const auto next = std::make_shared<runtime::RunControl>();
  {
    const std::lock_guard lock(mutex_);
    control_ = next;
  }
  if (on_interrupt_ != OnInterrupt::stop) return;
  interrupt_.reset();
  interrupt_.emplace(*of_signals_.emplace_back(next));
}

std::shared_ptr<runtime::RunControl> CellRunner::control() const {
  const std::lock_guard lock(mutex_);
  return control_;
}

SkillResult CellRunner::run(const std::string& name, const std::vector<operations::Parameter>& parameters,
                            std::optional<Duration> limit) {
  runtime::Skill* skill = find(name);
  if (skill == nullptr) return {SkillResult::Kind::error, -1, "the cell has no skill '" + name + "'"};
  const sim::ToolKind tool = cell_.workcell().tool_kind();
  if (const auto needed = needed_tool(*skill); needed && *needed != tool)
    return {SkillResult::Kind::error, -1,
            fmt::format("skill {} needs the tool {}, and the cell's tool is {}", name,
                        sim::to_string(*needed), sim::to_string(tool))};
  std::vector<runtime::ParameterValue> values;
  for (const operations::Parameter& parameter : parameters) values.push_back(value_of(parameter));
  runtime::RunOptions options;
  options.costs = times_;
  options.seed = seed_++;
  const auto stops = control();
  options.control = stops.get();
  options.observer = &figures_;
  if (limit) options.horizon = std::min(options.horizon, *limit);
  options.trace_capacity = 1U << 14U;
  options.on_broken_promise = on_broken_promise_;
  figures_.begin(cell_.workcell());
  if (margins_ != nullptr) options.margins = margins_->begin(*skill);
  const runtime::Outcome outcome = cell_.run(*skill, values, options);
  SkillResult result{kind_of(*skill, outcome), outcome.code, reason_of(outcome)};
  if (margins_ != nullptr) result.measured = margins_->end();
  const auto longest =
      operations::declared_longest(templates_.at(name), outcome.code, parameters, nullptr, longest_);
  if (longest && outcome.duration > *longest)
    result.reason +=
        fmt::format("{}broken promise: {} took {}, at most {} is declared", result.reason.empty() ? "" : "; ",
                    name, to_text(outcome.duration), to_text(*longest));
  if (outcome.fault && stops->stopping()) {
    result.kind = SkillResult::Kind::stopped;
  } else if (outcome.fault && limit && outcome.duration >= *limit) {
    result.over_time = true;
  }
  // What cut a skill off may have left motions that the arm has accepted: no skill begins before it is at
  // rest.
  if (outcome.fault) cell_.rest(runtime::Time::zero());
  result.figures = figures_.end(cell_.workcell(), outcome.duration);
  return result;
}

std::optional<std::string> CellRunner::zero(const std::string& sensor) {
  return cell_.zero(sensor, control().get());
}

void CellRunner::ask(const operations::Question& question) {
  if (person_ != nullptr) person_->ask(question);
}

operations::Reply CellRunner::answer() {
  if (control()->stopping()) return {{}, {}, true};
  return person_ != nullptr ? person_->answer() : SkillRunner::answer();
}

void CellRunner::withdraw() {
  if (person_ != nullptr) person_->withdraw();
}

bool CellRunner::delay(Duration time) {
  constexpr Duration grain = std::chrono::milliseconds(20);
  const auto stops = control();
  const Duration end = now() + time;
  while (now() < end && !stops->stopping()) cell_.station().idle(std::min(grain, end - now()));
  return !stops->stopping();
}

operations::Reading CellRunner::sense(const std::string& sensor) {
  sim::Cell::Sensed sensed = cell_.sense(sensor, control().get());
  return {sensed.value, std::move(sensed.problem), sensed.stopped};
}

Duration CellRunner::now() const {
  return cell_.station().now();
}

void CellRunner::stop() noexcept {
  control()->stop();
}

void CellRunner::allow() {
  if (control()->stopping()) take_new_control();
}

runtime::Skill* CellRunner::find(const std::string& name) {
  if (const auto made = made_.find(name); made != made_.end()) return made->second.get();
  for (const KnownSkill& known : known_)
    if (known.name == name) return made_.emplace(name, known.make()).first->second.get();
  return nullptr;
}

}  // namespace pal::workcell
