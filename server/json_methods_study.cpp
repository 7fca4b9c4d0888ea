// The method of the JSON protocol that tries a skill aside, without the cell.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "server/json_call.hpp"
#include "server/program_check.hpp"

namespace pal::server {
namespace {

constexpr std::size_t most_before = 200;

Trial::Skill skill_of(const Json& object, const operations::Cell& cell) {
  if (!object.is_object() || !object.contains("skill") || !object["skill"].is_string())
    fail(bad_parameters, "each of 'before' has the name of a skill: \"skill\"");
  RunSkill command{object["skill"], {}, false};
  if (const auto given = object.find("parameters"); given != object.end()) {
    if (!given->is_object()) fail(bad_parameters, "'parameters' must be an object");
    for (const auto& [name, value] : given->items())
      command.parameters.push_back({name, value_of(name, value), {}, {}});
  }
  if (auto refusal = mistake_in(command, cell)) throw problem_of(*refusal);
  return {std::move(command.skill), std::move(command.parameters)};
}

Json figures_json(const std::vector<operations::Figure>& figures) {
  Json json = Json::object();
  for (const operations::Figure& each : figures) json[each.name] = each.value;
  return json;
}

void try_skill(const Call& call) {
  SessionContext& context = call.context();
  if (context.trials == nullptr || context.studies == nullptr)
    fail(Refusal::Why::absent, "this server tries nothing aside");
  const auto cell = context.desk.cell();
  const Members& members = call.members();
  Trial trial;
  Json tried{{"skill", members.text("skill")}};
  if (const Json* parameters = members.find("parameters")) tried["parameters"] = *parameters;
  trial.tried = skill_of(tried, *cell);
  if (const Json* before = members.find("before")) {
    if (!before->is_array() || before->size() > most_before)
      fail(bad_parameters, fmt::format("'before' is a list of at most {} skills", most_before));
    for (const Json& each : *before) trial.before.push_back(skill_of(each, *cell));
  }
  if (const Json* joints = members.find("joints")) {
    constexpr double whole_turn = 360;
    const auto fits = [](const Json& each) {
      return each.is_number() && std::abs(each.get<double>()) <= whole_turn;
    };
    if (!joints->is_array() || joints->size() != 6 || !std::ranges::all_of(*joints, fits))
      fail(bad_parameters, "'joints' are six numbers, -360 to 360 deg");
    trial.joints = joints->get<std::array<double, 6>>();
  }
  constexpr std::int64_t greatest_seed = std::int64_t{1} << 53;
  trial.seed = static_cast<std::uint64_t>(members.may_be_whole("seed", 0, greatest_seed).value_or(1));
  call.beside(*context.studies,
              [&trials = *context.trials, trial = std::move(trial)](const Workshop::Stop& stop) -> Json {
                static constexpr std::array kinds{"normal", "contingency", "error", "stopped"};
                const TrialResult got = trials.run(trial, stop);
                return {{"kind", kinds[static_cast<std::size_t>(got.result.kind)]},
                        {"code", got.result.code},
                        {"reason", got.result.reason},
                        {"figures", figures_json(got.result.figures)},
                        {"measured", figures_json(got.result.measured)},
                        {"duration_s", seconds(got.end - got.begin)}};
              });
}

constexpr std::array study_methods{Method{"study.try", Role::programmer, false, try_skill}};

}  // namespace

std::span<const Method> methods_of_studies() {
  return study_methods;
}

}  // namespace pal::server
