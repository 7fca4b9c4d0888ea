#include "programs/pal/reports/simulated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analyzer/verdict/verdict.hpp"
#include "programs/pal/reports/json_text.hpp"
#include "programs/pal/session/measure_text.hpp"

namespace pal::program {
namespace {

using Json = nlohmann::ordered_json;
using Measure = analyzer::Requirement::Measure;

std::string state_text(const Simulated& simulated, std::size_t r) {
  const Seen& seen = simulated.seen[r];
  if (seen.breaking > 0) return "broken";
  if (seen.open > 0) return "open";
  if (!seen.extreme) return "not seen";
  return simulated.problem.requirements[r].measure == Measure::load ? "seen" : "kept";
}

std::string value_text(const Simulated& simulated, std::size_t r) {
  const Seen& seen = simulated.seen[r];
  if (!seen.extreme) return "";
  return (seen.grows ? "> " : "") +
         text(figure_of(simulated.problem.requirements[r].measure, Duration(seen.extreme->value)));
}

std::string count(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string count_text(const Simulated& simulated, std::size_t r) {
  const Seen& seen = simulated.seen[r];
  std::vector<std::string> parts;
  if (seen.extreme)
    parts.push_back(fmt::format("{} of {}, in {}",
                                simulated.problem.requirements[r].at_least ? "least" : "greatest",
                                count(seen.values, "value", "values"), simulated.run_names[seen.run]));
  if (seen.breaking > 0) parts.push_back(count(seen.breaking, "run breaks it", "runs break it"));
  if (seen.open > 0)
    parts.push_back(count(seen.open, "run ends", "runs end") +
                    " with a value over the limit that may yet not count");
  if (seen.unanswered > 0) parts.push_back(count(seen.unanswered, "event", "events") + " without a response");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string runs_text(const Simulated& simulated) {
  if (simulated.runs == simulated.asked) return count(simulated.runs, "run", "runs");
  return fmt::format("{} of {} runs, then --timeout or Ctrl-C ended it", simulated.runs, simulated.asked);
}

Json row(const Simulated& simulated, std::size_t r) {
  const analyzer::Requirement& requirement = simulated.problem.requirements[r];
  const Seen& seen = simulated.seen[r];
  return {{"name", requirement.name},
          {"measure", requirement.at_least ? "least_interval" : analyzer::name(requirement.measure)},
          {"limit_ns", requirement.limit},
          {"values", seen.values},
          {"extreme_ns", seen.extreme ? Json(seen.extreme->value) : Json()},
          {"grows", seen.grows},
          {"run", seen.extreme ? Json(simulated.run_names[seen.run]) : Json()},
          {"broken_runs", seen.breaking},
          {"open_runs", seen.open},
          {"unanswered_runs", seen.unanswered}};
}

}  // namespace

std::string text(const Simulated& simulated) {
  std::string made =
      fmt::format("{} in {}: {} ({}); the skill completed in {}\n", simulated.problem.skill,
                  simulated.problem.environment, runs_text(simulated), simulated.how, simulated.completed);
  std::size_t name_width = 0, measure_width = 0;
  for (std::size_t r = 0; r < simulated.seen.size(); ++r) {
    name_width = std::max(name_width, simulated.problem.requirements[r].name.size());
    measure_width = std::max(measure_width, measure_text(simulated.problem, r).size());
  }
  for (std::size_t r = 0; r < simulated.seen.size(); ++r) {
    const analyzer::Requirement& requirement = simulated.problem.requirements[r];
    made += fmt::format("  {:8}  {:{}}  {:{}}  {:>11}  of {:>7}  {}\n", state_text(simulated, r),
                        requirement.name, name_width, measure_text(simulated.problem, r), measure_width,
                        value_text(simulated, r), whole_text(requirement.allowed().figure),
                        count_text(simulated, r));
  }
  const bool loads = std::any_of(
      simulated.problem.requirements.begin(), simulated.problem.requirements.end(),
      [](const analyzer::Requirement& requirement) { return requirement.measure == Measure::load; });
  if (loads)
    made +=
        "  A load here is that of one whole run, from its start to its end. The load that pal check proves "
        "is "
        "that of the long run: the start counts for nothing there.\n";
  for (const std::string& refused : simulated.refused) made += "  refused   " + refused + "\n";
  return made;
}

std::string json(const std::vector<Simulated>& simulations) {
  Json document;
  document["format_version"] = 1;
  document["simulations"] = Json::array();
  for (const Simulated& simulated : simulations) {
    Json made{{"skill", simulated.problem.skill}, {"environment", simulated.problem.environment},
              {"asked", simulated.asked},         {"runs", simulated.runs},
              {"completed", simulated.completed}, {"refused", simulated.refused},
              {"requirements", Json::array()}};
    for (std::size_t r = 0; r < simulated.seen.size(); ++r) made["requirements"].push_back(row(simulated, r));
    document["simulations"].push_back(std::move(made));
  }
  return json_text(document, 2) + "\n";
}

}  // namespace pal::program
