// Protocol 2: the present state, texts beside the desk, questions, breakpoints, roles, holds.
#include <nlohmann/json.hpp>

#include "tests/unit/server/session_support.hpp"

using namespace pal;
using namespace pal::server;
using Json = nlohmann::json;

namespace {

struct Page : test::SessionFixture {
  explicit Page(const std::string& token = "secret") : SessionFixture(json_session) {
    const Json hello = call("hello", {{"token", token}, {"name", "ann"}});
    REQUIRE(hello.contains("result"));
    first = hello["result"];
  }
  Json call(const std::string& method, const Json& params = Json::object()) {
    const auto answers =
        say(Json{{"jsonrpc", "2.0"}, {"id", 7}, {"method", method}, {"params", params}}.dump());
    events.clear();
    Json answer;
    for (const std::string& each : answers) {
      Json message = Json::parse(each);
      if (message.contains("id")) {
        answer = std::move(message);
      } else {
        events.push_back(message["params"]);
      }
    }
    return answer;
  }
  Json result(const std::string& method, const Json& params = Json::object()) {
    const Json answer = call(method, params);
    INFO(answer.dump());
    REQUIRE(answer.contains("result"));
    return answer["result"];
  }
  std::string why(const std::string& method, const Json& params = Json::object()) {
    const Json answer = call(method, params);
    INFO(answer.dump());
    REQUIRE(answer.contains("error"));
    return answer["error"]["data"]["why"];
  }
  void load(const std::string& text) { result("operation.load", {{"main", "o"}, {"files", {{"o", text}}}}); }

  Json first;
  std::vector<Json> events;
};

const char* const asks =
    R"({"operation-format": 1, "name": "asks", "icons": [{"id": "start", "kind": "start", "next": "a"},)"
    R"({"id": "a", "kind": "skill", "skill": "quick", "parameters": {"code": 0}, "operator": {"code": {"from": 0, "to": 2}}, "next": "ask", "error": "end"},)"
    R"({"id": "ask", "kind": "question", "text": "Clean?", "answers": [{"text": "Yes", "to": "end"}, {"text": "No", "to": "a"}], "error": "end"},)"
    R"({"id": "end", "kind": "exit"}]})";

}  // namespace

TEST_CASE("hello and snapshot tell the whole present state") {
  Page page;
  CHECK(page.first["protocol"] == 2);
  CHECK(page.first["role"] == "programmer");
  CHECK(page.first["loaded"] == nullptr);
  page.load(test::endless);
  page.result("operation.set", {{"icon", "a"}, {"parameter", "code"}, {"value", 0}});
  page.result("operation.break", {{"icon", "a"}});
  page.result("operation.run");
  page.work();
  const Json snapshot = page.result("snapshot");
  CHECK(snapshot["loaded"]["files"]["o"] == test::endless);
  CHECK(snapshot["changed"][0]["before"] == nullptr);
  CHECK(snapshot["breakpoints"][0]["hits"] == 1);
  CHECK(snapshot["here"]["icon"] == "a");
  CHECK(snapshot["icons"][0]["icon"] == "a");
  CHECK(snapshot["state"] == "paused");
  CHECK(snapshot["epoch"] == page.first["epoch"]);
  CHECK(snapshot["clients"].size() == 1);
}

TEST_CASE("what another server has numbered is not taken for what is known") {
  Page page;
  const Json other = page.result("watch", {{"since", 3}, {"epoch", "another"}});
  CHECK(other["complete"] == false);
  CHECK(other["snapshot"]["cell"] == page.first["cell"]);
  const Json later = page.result("watch", {{"since", 1'000'000}});
  CHECK(later["complete"] == false);
  page.call("controls.take");
  REQUIRE(page.events.size() == 1);
  CHECK(page.events[0]["event"] == "controls");
}

TEST_CASE("a text is checked without being loaded, and each finding names its place") {
  Page page;
  std::string wrong = asks;
  wrong.replace(wrong.find("quick"), 5, "quack");
  const Json told =
      page.result("operation.check", {{"main", "é.op.json"}, {"files", {{"é.op.json", wrong}}}});
  CHECK(told["runs"] == false);
  const Json finding = told["findings"][0];
  CHECK(finding["code"] == "PAL1007");
  CHECK(finding["icon"] == "a");
  CHECK(finding["field"] == "skill");
  const std::size_t offset = finding["begin"]["offset"];
  CHECK(wrong.substr(offset, 7) == "\"quack\"");
  const Json well = page.result("operation.check", {{"main", "o"}, {"files", {{"o", test::endless}}}});
  CHECK(well["runs"] == true);
  CHECK(well["icons"][0]["unknown"] == "quick");
  CHECK(page.result("state")["operation"] == "");
  CHECK(page.result("operation.check", {{"main", "none"}, {"files", Json::object()}})["errors"] == 1);
}

TEST_CASE("what an operator may set is checked, and kept by the canonical form") {
  Page page;
  const auto errors = [&page](const std::string& limits) {
    std::string text = asks;
    const std::string given = R"("operator": {"code": {"from": 0, "to": 2}})";
    text.replace(text.find(given), given.size(), "\"operator\": " + limits);
    return page.result("operation.check", {{"main", "o"}, {"files", {{"o", text}}}})["errors"];
  };
  CHECK(errors(R"({"code": {}})") == 0);
  CHECK(errors(R"({"cold": {}})") == 1);
  CHECK(errors(R"({"code": {"from": 0, "to": 99}})") == 1);
  CHECK(errors(R"({"code": {"from": 2, "to": 1}})") == 1);
  CHECK(errors(R"({"code": 3})") == 1);
  const std::string text = page.result("operation.format", {{"text", asks}})["text"];
  CHECK(text.find(R"("operator": {"code": {"from": 0, "to": 2}})") != std::string::npos);
}

TEST_CASE("texts are formatted, laid out and compared") {
  Page page;
  const std::string text = page.result("operation.format", {{"text", test::endless}})["text"];
  CHECK(page.result("operation.format", {{"text", text}})["text"] == text);
  CHECK(page.why("operation.format", {{"text", "{"}}) == "wrong");
  const Json places =
      page.result("operation.tidy", {{"main", "o"}, {"files", {{"o", test::two_long}}}})["places"];
  REQUIRE(places.size() == 4);
  for (std::size_t i = 1; i < places.size(); ++i) CHECK(places[i - 1]["at"][0] < places[i]["at"][0]);
  CHECK(page.result("operation.difference", {{"before", text}, {"after", test::endless}})["same"] == true);
  std::string moved = text, changed = text;
  moved.replace(moved.find("\"id\": \"a\""), 9, "\"id\": \"a\", \"at\": [1, 2]");
  changed.replace(changed.find("quick"), 5, "long");
  const Json move = page.result("operation.difference", {{"before", text}, {"after", moved}});
  CHECK(move["content"] == false);
  CHECK(move["changes"][0]["change"] == "moved");
  const Json change = page.result("operation.difference", {{"before", text}, {"after", changed}});
  CHECK(change["content"] == true);
  CHECK(change["changes"][0]["fields"][0]["after"] == "long");
}

TEST_CASE("a question is answered by a client") {
  Page page;
  page.load(asks);
  page.result("watch");
  page.result("operation.run");
  std::thread cell([&page] {
    while (page.desk.work()) {
    }
  });
  for (int i = 0; i < 500 && !page.desk.status(0).question; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  REQUIRE(page.desk.status(0).question);
  CHECK(page.why("operation.answer", {{"icon", "other"}, {"answer", 0}}) == "nothing");
  CHECK(page.why("operation.answer", {{"icon", "ask"}, {"answer", "Perhaps"}}) == "wrong");
  page.result("operation.answer", {{"icon", "ask"}, {"answer", "Yes"}});
  cell.join();
  CHECK(page.result("state")["state"] == "ended");
  CHECK(page.result("state")["question"] == nullptr);
}

TEST_CASE("breakpoints are removed singly, switched off, counted and conditional") {
  Page page;
  page.load(test::endless);
  const int first = page.result("operation.break", {{"icon", "end"}})["breakpoint"];
  const Json second =
      page.result("operation.break", {{"icon", "a"}, {"condition", {{"count-of", "a"}, {"at-least", 3}}}});
  CHECK(page.result("operation.breakpoints").size() == 2);
  page.result("operation.unbreak", {{"breakpoint", first}});
  CHECK(page.why("operation.unbreak", {{"breakpoint", first}}) == "absent");
  page.result("operation.run");
  page.work();
  CHECK(page.result("state")["steps"] == 3);
  page.result("operation.break",
              {{"breakpoint", second["breakpoint"]}, {"icon", "a"}, {"every", 5}, {"enabled", true}});
  page.result("operation.resume");
  page.work();
  CHECK(page.result("state")["steps"] == 7);  // it fitted once before, and then at steps 4 to 7
  CHECK(page.why("operation.break",
                 {{"icon", "a"}, {"condition", {{"count-of", "none"}, {"at-least", 1}}}}) == "wrong");
  CHECK(page.why("operation.break", {{"icon", "a"}, {"condition", {{"count-of", "a"}}}}) == "bad-parameters");
}

TEST_CASE("what would be repeated is said before anything moves") {
  Page page;
  page.load(test::two_long);
  page.result("operation.run");
  std::thread cell([&page] { page.desk.work(); });
  page.cell.wait_until_inside();
  page.result("stop");
  cell.join();
  const Json outlook = page.result("operation.outlook");
  CHECK(outlook["token"] == "a");
  CHECK(outlook["choices"][0]["place"] == "here");
  CHECK(outlook["choices"][0]["repeats"] == true);
  CHECK(outlook["choices"][0]["skill"] == "long");
  CHECK(outlook["choices"].back()["place"] == "start");
  CHECK(page.result("operation.outlook", {{"icon", "b"}})["choices"][0]["forgets"] == true);
  CHECK(page.why("operation.outlook", {{"icon", "nowhere"}}) == "wrong");
}

TEST_CASE("a stop ends a pause") {
  Page page;
  page.load(test::endless);
  page.result("operation.step");
  page.work();
  CHECK(page.result("state")["state"] == "paused");
  page.result("stop");
  CHECK(page.result("state")["state"] == "stopped");
}

TEST_CASE("a hold lets nothing begin, of any client, until it is released") {
  Page page;
  page.load(test::endless);
  page.result("hold.set", {{"reason", "hands inside"}});
  CHECK(page.why("operation.run") == "held");
  CHECK(page.why("skill.run", {{"skill", "quick"}}) == "held");
  const ClientId bob = page.desk.enter("bob", Role::operating);
  std::optional<Refusal> refused;
  page.desk.ask(bob, ReleaseHold{}, [&](const Reply& reply) { refused = std::get<Refusal>(reply); });
  CHECK(refused->why == Refusal::Why::held);
  CHECK_FALSE(page.desk.work());
  page.result("hold.release");
  page.result("operation.step");
  CHECK(page.desk.work());
}

TEST_CASE("each role may do its part, and no more") {
  SECTION("a viewer") {
    Page page("viewers");
    CHECK(page.why("controls.take") == "role");
    CHECK(page.why("operation.load", {{"main", "o"}, {"files", {{"o", asks}}}}) == "role");
    CHECK_NOTHROW(page.result("stop"));
  }
  SECTION("an operator") {
    Page page("operators");
    CHECK(page.why("skill.run", {{"skill", "quick"}}) == "role");
    CHECK(page.why("operation.load", {{"main", "o"}, {"files", {{"o", asks}}}}) == "role");
    const ClientId bob = page.desk.enter("bob");
    page.desk.ask(bob, LoadOperation{{{"o", asks}}, "o"}, [](const Reply&) {});
    page.desk.ask(bob, ReleaseControls{}, [](const Reply&) {});
    page.result("operation.set", {{"icon", "a"}, {"parameter", "code"}, {"value", 2}});
    const Json refused = page.call("operation.set", {{"icon", "a"}, {"parameter", "code"}, {"value", 3}});
    CHECK(refused["error"]["data"]["why"] == "role");
    CHECK(refused["error"]["data"]["limit"]["high"] == 2);
    CHECK(page.result("operation.values", {{"icon", "a"}})["parameters"][0]["value"] == 2);
  }
  SECTION("a programmer may ask for less") {
    test::SessionFixture fixture(json_session);
    const auto told = fixture.say(
        R"({"jsonrpc": "2.0", "id": 1, "method": "hello", "params": {"token": "secret", "role": "viewer"}})");
    CHECK(Json::parse(told.front())["result"]["role"] == "viewer");
  }
}

TEST_CASE("the controls are asked for and handed over") {
  Page page;
  const ClientId bob = page.desk.enter("bob");
  page.result("controls.take");
  page.result("watch");
  page.desk.ask(bob, AskForControls{"my turn"}, [](const Reply&) {});
  CHECK(page.result("snapshot")["asking"][0]["name"] == "bob");
  page.result("controls.give", {{"client", bob}});
  CHECK(page.desk.status(bob).yours);
  CHECK(page.why("controls.take") == "not-yours");
  page.result("controls.take", {{"force", true}, {"reason", "bob left"}});
  CHECK(page.desk.status(page.first["client"]).yours);
  CHECK(page.why("controls.give", {{"client", 99}}) == "absent");
}

TEST_CASE("what comes behind a load waits for it, and a stop does not") {
  Page page;
  page.load(test::endless);
  CHECK(page.why("operation.load", {{"main", "o"}, {"files", {{"o", "{"}}}}) == "wrong");
  const Json answer = page.call("operation.load", {{"main", "o"}, {"files", {{"p", test::endless}}}});
  CHECK(answer["error"]["message"].get<std::string>().find("was not sent") != std::string::npos);
}
