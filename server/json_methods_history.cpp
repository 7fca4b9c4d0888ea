// The methods of the JSON protocol on what was run in the cell.
#include <array>

#include "server/json_call.hpp"
#include "server/services.hpp"

namespace pal::server {
namespace {

constexpr std::int64_t greatest_run = std::int64_t{1} << 53;

const RunHistory& history_of(const SessionContext& context) {
  if (context.runs == nullptr) fail(Refusal::Why::absent, "this server keeps no history");
  return *context.runs;
}

Json describe_run(const RunRecord& run) {
  return {{"run", run.run},
          {"kind", run.kind == RunRecord::Kind::skill ? "skill" : "operation"},
          {"name", run.name},
          {"begun", wall_text(run.begun)},
          {"ended", run.ended ? Json(wall_text(*run.ended)) : Json()},
          {"begin_s", seconds(run.begin)},
          {"end_s", run.end ? Json(seconds(*run.end)) : Json()},
          {"by", run.by},
          {"state", run.state},
          {"code", run.code ? Json(*run.code) : Json()},
          {"reason", run.reason},
          {"steps", run.steps}};
}

void list_runs(const Call& call) {
  constexpr std::int64_t usual = 50, most = 200;
  const Members& members = call.members();
  const auto before = members.may_be_whole("before", 1, greatest_run);
  const auto limit = members.may_be_whole("limit", 1, most).value_or(usual);
  call.beside(call.context().disk,
              [&runs = history_of(call.context()), before, limit,
               name = members.text("name", "")](const Workshop::Stop&) -> Json {
                const RunPage page = with_store([&] {
                  return runs.list(before ? std::optional<std::uint64_t>(*before) : std::nullopt,
                                   static_cast<std::size_t>(limit), name);
                });
                Json json{{"runs", Json::array()}, {"more", page.more}};
                for (const RunRecord& each : page.runs) json["runs"].push_back(describe_run(each));
                return json;
              });
}

void read_run(const Call& call) {
  constexpr std::int64_t usual = 200, most = 1000;
  const Members& members = call.members();
  const auto run = static_cast<std::uint64_t>(members.whole("run", 1, greatest_run));
  const auto after = static_cast<std::uint64_t>(members.may_be_whole("after", 0, greatest_run).value_or(0));
  const auto limit = static_cast<std::size_t>(members.may_be_whole("limit", 1, most).value_or(usual));
  call.beside(call.context().disk,
              [&runs = history_of(call.context()), run, after, limit](const Workshop::Stop&) -> Json {
                const RunSteps found = with_store([&] { return runs.read(run, after, limit); });
                Json json{{"run", describe_run(found.run)},
                          {"text", found.text ? Json(*found.text) : Json()},
                          {"steps", Json::array()},
                          {"more", found.more}};
                for (const RunSteps::Each& each : found.steps)
                  json["steps"].push_back(
                      {{"step", Json::parse(each.step)}, {"parameters", Json::parse(each.parameters)}});
                return json;
              });
}

void list_steps(const Call& call) {
  constexpr std::int64_t usual = 100, most = 1000;
  const Members& members = call.members();
  const auto before = members.may_be_whole("before", 1, greatest_run);
  const auto limit = members.may_be_whole("limit", 1, most).value_or(usual);
  call.beside(call.context().disk,
              [&runs = history_of(call.context()), before, limit,
               skill = members.text("skill")](const Workshop::Stop&) -> Json {
                const StepPage page = with_store([&] {
                  return runs.steps_of(skill, before ? std::optional<std::uint64_t>(*before) : std::nullopt,
                                       static_cast<std::size_t>(limit));
                });
                Json json{{"rows", Json::array()}, {"more", page.more}};
                for (const StepPage::Each& each : page.steps)
                  json["rows"].push_back({{"run", each.run},
                                          {"name", each.name},
                                          {"begun", wall_text(each.begun)},
                                          {"step", Json::parse(each.step.step)},
                                          {"parameters", Json::parse(each.step.parameters)}});
                return json;
              });
}

constexpr std::array history_methods{
    Method{"history.list", Role::viewer, false, list_runs},
    Method{"history.read", Role::viewer, false, read_run},
    Method{"history.steps", Role::viewer, false, list_steps},
};

}  // namespace

std::span<const Method> methods_of_the_history() {
  return history_methods;
}

}  // namespace pal::server
