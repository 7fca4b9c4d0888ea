// Skills, their requirements and the cell's sensors, as the JSON protocol tells them.
#include <array>

#include "operations/missing_value.hpp"
#include "server/json_values.hpp"
#include "server/pendant.hpp"

namespace pal::server {
namespace {

const char* type_name(pan::ScalarType type) {
  switch (type) {
    case pan::ScalarType::integer:
      return "integer";
    case pan::ScalarType::boolean:
      return "boolean";
    case pan::ScalarType::text:
      return "text";
    default:
      return "real";
  }
}

Json describe_parameter(const pan::Parameter& parameter) {
  Json one;
  one["name"] = parameter.name;
  one["type"] = type_name(parameter.type);
  one["unit"] = parameter.unit;
  one["default"] = describe(operations::default_of(parameter));
  if (parameter.low < parameter.high) {
    one["low"] = parameter.low;
    one["high"] = parameter.high;
  }
  one["description"] = parameter.description;
  one["location"] = parameter.location;
  return one;
}

/// The longest time of what has no parameters set.
Json describe_completion(const pan::Completion& completion, const pan::Template& skill, const Facts& facts,
                         const operations::Cell& cell) {
  static constexpr std::array kinds{"normal", "contingency", "error"};
  Json one{{"code", completion.code},
           {"kind", kinds[static_cast<std::size_t>(completion.kind)]},
           {"description", completion.description}};
  if (completion.contingency > 0) one["contingency"] = completion.contingency;
  const auto proved = facts.times.find({skill.name, completion.code});
  const auto declared = cell.longest.find({skill.name, completion.code});
  std::optional<Duration> longest;
  if (proved != facts.times.end()) {
    longest = proved->second;
  } else if (declared != cell.longest.end()) {
    longest = operations::declared_longest(skill, completion.code, {}, nullptr, cell.longest);
    one["declared"] = declared->second.text();
  }
  one["longest_s"] = longest ? Json(seconds(*longest)) : Json();
  return one;
}

}  // namespace

Json describe(const KnownRequirement& requirement) {
  static constexpr std::array verdicts{"holds", "fails", "undecided", "not-proved", "proving"};
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  return {{"name", requirement.name},
          {"text", requirement.text},
          {"verdict", verdicts[static_cast<std::size_t>(requirement.verdict)]},
          {"bound", number(requirement.bound)},
          {"limit", number(requirement.limit)},
          {"unit", requirement.unit}};
}

Json describe(const operations::Skills& skills, const Facts& facts, const operations::Cell& cell) {
  Json list = Json::array();
  for (const auto& [name, known] : skills) {
    const auto fact = facts.skills.find(name);
    const pan::Template& skill = fact == facts.skills.end() ? known : fact->second.skill;
    Json each;
    each["skill"] = name;
    each["description"] = skill.descriptions.empty() ? "" : skill.descriptions.front();
    each["descriptions"] = skill.descriptions;
    each["preconditions"] = skill.preconditions;
    each["postconditions"] = skill.postconditions;
    each["model_data"] = skill.model_data;
    each["parameters"] = Json::array();
    for (const pan::Parameter& parameter : skill.parameters)
      each["parameters"].push_back(describe_parameter(parameter));
    each["completions"] = Json::array();
    for (const pan::Completion& completion : skill.completions)
      each["completions"].push_back(describe_completion(completion, skill, facts, cell));
    each["contingencies"] = Json::array();
    for (const pan::Contingency& contingency : skill.contingencies)
      each["contingencies"].push_back(
          {{"number", contingency.number}, {"description", contingency.description}});
    each["requirements"] = Json::array();
    each["tool"] = "";
    const auto why = cell.unable.find(name);
    each["able"] = why == cell.unable.end();
    each["unable"] = why == cell.unable.end() ? "" : why->second;
    each["by_hand"] = name == skill_by_hand;
    each["environment"] = "";
    each["pictures"] = Json::array();
    if (fact != facts.skills.end()) {
      for (const KnownRequirement& requirement : fact->second.requirements)
        each["requirements"].push_back(describe(requirement));
      each["tool"] = fact->second.tool;
      each["environment"] = fact->second.environment;
      for (const SkillFacts::Picture& picture : fact->second.pictures)
        each["pictures"].push_back({{"title", picture.title}, {"path", picture.path}});
    }
    list.push_back(std::move(each));
  }
  return list;
}

Json describe(const operations::Sensors& sensors, const std::map<std::string, LastReading>& readings) {
  Json list = Json::array();
  for (const auto& [name, sensor] : sensors) {
    Json each{{"sensor", name}, {"unit", sensor.unit}, {"description", sensor.description}};
    if (sensor.range) {
      each["low"] = sensor.range->first;
      each["high"] = sensor.range->second;
    }
    const auto read = readings.find(name);
    each["value"] = read == readings.end() ? Json() : Json(read->second.value);
    if (read != readings.end()) each["time_s"] = seconds(read->second.time);
    list.push_back(std::move(each));
  }
  return list;
}

}  // namespace pal::server
