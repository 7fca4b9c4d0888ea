// The answer for programs.
#include <nlohmann/json.hpp>

#include "programs/pal/reports/json_text.hpp"
#include "programs/pal/reports/whatif_answer.hpp"

namespace pal::program {
namespace {

using Json = nlohmann::ordered_json;

Json nanoseconds(const std::optional<Duration>& time) {
  return time ? Json(time->count()) : Json();
}

Json requirement(const WhatIfAnswer& answer, analyzer::RequirementId id) {
  return id.valid() ? Json(answer.requirements[id.index()]) : Json();
}

Json slack_row(const WhatIfAnswer& answer, const analyzer::whatif::Slack& slack) {
  return {{"figure", slack.figure.empty() ? Json() : Json(slack.figure)},
          {"worst_ns", slack.time.worst.count()},
          {"holds_with_growth_ns", nanoseconds(slack.holds)},
          {"fails_with_growth_ns", nanoseconds(slack.fails)},
          {"unlimited", slack.unlimited},
          {"exact", slack.exact()},
          {"requirement", requirement(answer, slack.requirement)}};
}

Json verdict_row(const analyzer::Verdict& verdict) {
  return {{"verdict", analyzer::name(verdict.state)},
          {"bound_ns", nanoseconds(verdict.bound)},
          {"exact", verdict.exact}};
}

Json made_row(const WhatIfAnswer& answer, const analyzer::whatif::Candidate& candidate) {
  if (!candidate.program.valid()) {
    Json set = Json::array();
    for (const auto& each : candidate.changes) set.push_back(text(each));
    return {{"set", std::move(set)}};
  }
  const ProgramChange& change = answer.program_changes[candidate.program.index()];
  return {{"edit", change.title},
          {"module", change.module},
          {"file", change.file},
          {"line", change.line},
          {"diff", change.difference}};
}

Json remedy_row(const WhatIfAnswer& answer, const analyzer::whatif::Remedy& remedy) {
  Json row{{"changes", Json::array()}, {"verdicts", Json::array()}};
  for (const analyzer::whatif::CandidateId id : remedy.made)
    row["changes"].push_back(made_row(answer, answer.remedies->candidates[id.index()]));
  for (std::size_t r = 0; r < remedy.after.size(); ++r)
    row["verdicts"].push_back({{"requirement", remedy.after[r].requirement},
                               {"limit_ns", remedy.after[r].limit.count()},
                               {"before", verdict_row(answer.remedies->before[r])},
                               {"after", verdict_row(remedy.after[r])}});
  return row;
}

Json remedies_row(const WhatIfAnswer& answer) {
  const analyzer::whatif::Remedies& remedies = *answer.remedies;
  Json row{{"tried", remedies.tried}, {"complete", remedies.complete}, {"found", Json::array()}};
  for (const analyzer::whatif::Remedy& remedy : remedies.found)
    row["found"].push_back(remedy_row(answer, remedy));
  row["nearest"] = remedies.nearest ? remedy_row(answer, *remedies.nearest) : Json();
  row["short_enough"] = Json::array();
  for (const analyzer::whatif::ShortEnough& each : remedies.short_enough)
    row["short_enough"].push_back({{"requirement", requirement(answer, each.requirement)},
                                   {"figure", each.figure},
                                   {"best_ns", each.time.best.count()},
                                   {"worst_ns", each.time.worst.count()},
                                   {"enough_best_ns", each.enough.best.count()},
                                   {"enough_worst_ns", each.enough.worst.count()}});
  return row;
}

Json placed_row(const WhatIfAnswer& answer, const analyzer::whatif::Placed& placed) {
  Json row;
  row["threads"] = Json::array();
  for (const analyzer::whatif::ThreadPlacement& each : placed.threads)
    row["threads"].push_back(
        {{"thread", each.thread}, {"processor", each.processor.value}, {"priority", each.priority}});
  if (placed.ruling.requirement.valid()) row["requirement"] = requirement(answer, placed.ruling.requirement);
  return row;
}

Json placements_row(const WhatIfAnswer& answer, const analyzer::whatif::Placements& on) {
  Json row{{"processors", on.processors}, {"tried", on.tried},     {"refuted", on.refuted.size()},
           {"complete", on.complete},     {"meet", Json::array()}, {"undecided", Json::array()}};
  for (const auto& placed : on.meet) row["meet"].push_back(placed_row(answer, placed));
  for (const auto& placed : on.undecided) row["undecided"].push_back(placed_row(answer, placed));
  return row;
}

}  // namespace

std::string json(const std::vector<WhatIfAnswer>& answers) {
  Json document;
  document["format_version"] = 1;
  document["what_if"] = Json::array();
  for (const WhatIfAnswer& answer : answers) {
    Json row{{"skill", answer.skill}, {"environment", answer.environment}};
    for (const auto& slack : answer.slacks) row["slack"].push_back(slack_row(answer, slack));
    if (answer.remedies) row["remedies"] = remedies_row(answer);
    if (answer.before_and_after.size() == 2) {
      const auto& before = answer.before_and_after[0].analysis.verdicts;
      const auto& after = answer.before_and_after[1].analysis.verdicts;
      for (std::size_t r = 0; r < after.size(); ++r)
        row["changed"].push_back({{"requirement", after[r].requirement},
                                  {"limit_ns", after[r].limit.count()},
                                  {"before", verdict_row(before[r])},
                                  {"after", verdict_row(after[r])}});
    }
    for (const auto& on : answer.placements) row["placements"].push_back(placements_row(answer, on));
    document["what_if"].push_back(std::move(row));
  }
  return json_text(document, 2) + "\n";
}

}  // namespace pal::program
