// JSON-RPC 2.0, its errors by its rules, and events without a gap.
#include <nlohmann/json.hpp>

#include "tests/unit/server/session_support.hpp"

using namespace pal;
using namespace pal::server;
using Json = nlohmann::json;

namespace {

struct Web : test::SessionFixture {
  Web() : SessionFixture(json_session) {}
  std::vector<Json> messages(const std::vector<std::string>& texts) {
    std::vector<Json> result;
    for (const std::string& text : texts) result.push_back(Json::parse(text));
    return result;
  }
  std::vector<Json> call(const std::string& method, const Json& params = Json::object()) {
    return messages(say(Json{{"jsonrpc", "2.0"}, {"id", 7}, {"method", method}, {"params", params}}.dump()));
  }
  void enter() { REQUIRE(call("hello", {{"token", "secret"}, {"name", "ann"}}).front().contains("result")); }
  int error(const std::string& text) { return Json::parse(say(text).front())["error"]["code"]; }
};

}  // namespace

TEST_CASE("nothing is obeyed before the token") {
  Web web;
  SECTION("another method") {
    const auto answer =
        web.call(GENERATE("skill.run", "operation.run", "state", "stop", "watch"), {{"skill", "quick"}});
    CHECK(answer.front()["error"]["code"] == 1);
  }
  SECTION("a wrong one") {
    CHECK(web.call("hello", {{"token", "Secret"}}).front()["error"]["code"] == 1);
  }
  SECTION("in silence") {
    CHECK(web.say(R"({"jsonrpc": "2.0", "method": "skill.run", "params": {"skill": "quick"}})").empty());
  }
  CHECK(web.hung_up);
  CHECK_FALSE(web.session->admitted());
  CHECK_FALSE(web.desk.work());
  CHECK(web.cell.runs == 0);
}

TEST_CASE("wrong requests are answered by the rules of JSON-RPC") {
  Web web;
  web.enter();
  CHECK(web.error("{") == -32700);
  CHECK(web.error("[]") == -32600);
  CHECK(web.error("7") == -32600);
  CHECK(web.error(R"({"id": 1, "method": "state"})") == -32600);
  CHECK(web.error(R"({"jsonrpc": "2.0", "id": {}, "method": "state"})") == -32600);
  CHECK(web.error(R"({"jsonrpc": "2.0", "id": 1, "method": "fly"})") == -32601);
  CHECK(web.error(R"({"jsonrpc": "2.0", "id": 1, "method": "skill.run", "params": [1]})") == -32602);
  CHECK(web.error(R"({"jsonrpc": "2.0", "id": 1, "method": "skill.run", "params": {"skill": 3}})") == -32602);
  CHECK(web.error(R"({"jsonrpc": "2.0", "id": 1, "method": "watch", "params": {"telemetry": -1}})") ==
        -32602);
  CHECK(web.error(std::string(100'000, '[')) == -32600);
  CHECK(web.error(R"({"jsonrpc": "2.0", "id": 1, "method": "watch", "params": )" + std::string(5000, '[') +
                  std::string(5000, ']') + "}") == -32600);
  CHECK(web.say(R"({"jsonrpc": "2.0", "method": "state"})").empty());  // a notification has no answer
  CHECK_FALSE(web.hung_up);
}

TEST_CASE("a skill is answered when it has ended, an operation tells itself by events") {
  Web web;
  web.enter();
  CHECK(web.call("skill.run", {{"skill", "quick"}, {"parameters", {{"code", 4}}}}).empty());
  const auto answer = web.messages(web.work());
  REQUIRE(answer.size() == 1);
  CHECK(answer[0]["id"] == 7);
  CHECK(answer[0]["result"]["code"] == 4);
  CHECK(answer[0]["result"]["kind"] == "contingency");

  web.call("operation.load", {{"main", "o"}, {"files", {{"o", test::endless}}}});
  web.call("watch");
  web.call("operation.break", {{"icon", "end"}});
  web.call("operation.set", {{"icon", "a"}, {"parameter", "code"}, {"value", 1}});
  const auto begun = web.call("operation.run");
  CHECK(begun[0]["result"] == Json::object());
  CHECK(begun[1]["params"]["state"] == "running");
  std::vector<std::string> told;
  for (const Json& event : web.messages(web.work())) told.push_back(event["params"]["event"]);
  CHECK(told == std::vector<std::string>{"icon", "icon", "begins", "ends", "icon", "state"});
  CHECK(web.call("state").front()["result"]["reason"] == "breakpoint at end");
}

TEST_CASE("a client that comes late is told what happened before") {
  Web web;
  web.enter();
  web.call("operation.load", {{"main", "o"}, {"files", {{"o", test::endless}}}});
  web.call("operation.step");
  web.work();
  web.open();
  web.enter();
  const auto told = web.call("watch", {{"since", 0}});
  CHECK(told.front()["result"]["complete"] == true);
  for (std::size_t i = 1; i < told.size(); ++i) CHECK(told[i]["params"]["number"] == i);
  // The first client went, and this one came.
  CHECK(told.back()["params"]["event"] == "clients");
  CHECK(told[told.size() - 3]["params"]["event"] == "controls");
}
