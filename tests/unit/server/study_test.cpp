// Trials aside, and limits that channels tell: what clients are answered.
#include <nlohmann/json.hpp>

#include "server/json_live.hpp"
#include "tests/unit/server/session_support.hpp"

using namespace pal;
using namespace pal::server;

namespace {

/// Answers with what it was asked for.
struct Told final : Trials {
  TrialResult run(const Trial& trial, const std::function<bool()>& stop) override {
    asked = trial;
    TrialResult got;
    if (stop()) got.result.kind = operations::SkillResult::Kind::stopped;
    got.result.code = 3;
    got.result.figures = {{"force", 2.5}};
    got.result.measured = {{"fresh", 0.004}};
    got.end = std::chrono::seconds(2);
    return got;
  }
  Trial asked;
};

struct Trying : pal::test::SessionFixture {
  Trying() : SessionFixture(json_session) {
    context.trials = &trials;
    context.studies = &at_once;
  }
  Json call(const std::string& method, const Json& params, const char* token = "secret") {
    if (!greeted)
      say(Json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", "hello"}, {"params", {{"token", token}}}}.dump());
    greeted = true;
    const auto told = say(Json{{"jsonrpc", "2.0"}, {"id", 2}, {"method", method}, {"params", params}}.dump());
    REQUIRE_FALSE(told.empty());
    const Json answer = Json::parse(told.back());
    return answer.contains("error") ? answer["error"]["data"] : answer["result"];
  }
  Told trials;
  bool greeted = false;
};

}  // namespace

TEST_CASE("a skill is tried aside with what is run before it") {
  Trying client;
  const Json got = client.call(
      "study.try",
      {{"skill", "quick"}, {"before", {{{"skill", "quick"}}}}, {"joints", {1, 2, 3, 4, 5, 6}}, {"seed", 7}});
  CHECK(got["code"] == 3);
  CHECK(got["kind"] == "normal");
  CHECK(got["figures"]["force"] == 2.5);
  CHECK(got["measured"]["fresh"] == 0.004);
  CHECK(got["duration_s"] == 2);
  CHECK(client.trials.asked.tried.skill == "quick");
  CHECK(client.trials.asked.before.size() == 1);
  CHECK(client.trials.asked.seed == 7);
  REQUIRE(client.trials.asked.joints);
  CHECK((*client.trials.asked.joints)[5] == 6);
  CHECK(client.desk.status(1).activity == Activity::idle);
}

TEST_CASE("a trial that is wrong is refused, and so is a client that may not") {
  Trying client;
  CHECK(client.call("study.try", {{"skill", "none"}})["why"] == "wrong");
  CHECK(client.call("study.try", {{"skill", "quick"}, {"parameters", {{"nothing", 1}}}})["why"] == "wrong");
  CHECK(client.call("study.try", {{"skill", "quick"}, {"joints", {1, 2}}})["why"] == "bad-parameters");
  CHECK(client.call("study.try", {{"skill", "quick"}, {"before", {1}}})["why"] == "bad-parameters");
  Trying operating;
  CHECK(operating.call("study.try", {{"skill", "quick"}}, "operators")["why"] == "role");
  Trying without;
  without.context.trials = nullptr;
  CHECK(without.call("study.try", {{"skill", "quick"}})["why"] == "absent");
}

TEST_CASE("a channel tells which parameters are limits on it") {
  Channel channel{"force", "what presses", {{"fz", "N"}}, 1000};
  channel.limits = {
      {"press", "band", {"fz"}, 1, true, ShownLimit::Kind::band, ShownLimit::Around{"force", -1}}};
  const auto told = describe(channel)["limits"][0];
  CHECK(told["parameter"] == "band");
  CHECK(told["both"] == true);
  CHECK(told["kind"] == "band");
  CHECK(told["around"]["parameter"] == "force");
  CHECK(told["around"]["factor"] == -1);
}
