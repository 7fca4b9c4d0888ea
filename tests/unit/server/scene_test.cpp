// What the cell looks like, as clients are told, and rows of channels: how often, and the last ones when the
// cell stands.
#include "server/scene.hpp"

#include <cstring>
#include <nlohmann/json.hpp>

#include "server/json_live.hpp"
#include "tests/unit/server/session_support.hpp"

using namespace pal;
using namespace pal::server;
using namespace std::chrono_literals;
using Plain = nlohmann::json;  // the server has a Json of its own

namespace {

Channels row_channels() {
  Channels result;
  result.push_back({"poses", "of bodies", {{"x", "m"}, {"y", "m"}}, 29, Channel::Form::rows});
  return result;
}

std::shared_ptr<const Rows> rows_at(Duration time, std::vector<float> numbers) {
  return std::make_shared<const Rows>(Rows{"poses", time, std::move(numbers)});
}

Scene two_bodies() {
  Scene scene;
  scene.bodies = {{"world", false, {}}, {"arm", true, {{0.1, 0.2, 0.30000001192092896}, {0, 0, 1, 0}}}};
  SceneShape box;
  box.body = 1;
  box.size = {0.1, 0.2, 0.3};
  box.colour = {1, 0.5, 0, 1};
  SceneShape mesh = box;
  mesh.kind = SceneShape::Kind::mesh;
  mesh.corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.triangles = {0, 1, 2};
  scene.shapes = {box, mesh};
  scene.tip = {1, {{0, 0, 0.5}, {0, 0, 0, 1}}};
  return scene;
}

/// A view whose wall clock the test moves, and what it was sent.
struct LiveFixture {
  Channels channels = row_channels();
  std::map<std::string, std::shared_ptr<const Rows>> latest;
  std::chrono::steady_clock::time_point now{1h};
  std::vector<std::string> sent;
  SessionOutput output{[](const std::string&) {},
                       [this](const LiveMessage& message) { sent.push_back(message.make(3)); },
                       [](const std::string&) {}};
  LiveView view{output, &channels, &latest, [this] { return now; }};

  void watch(bool binary, double period) {
    Plain request{
        {"params", {{"channels", {{{"channel", "poses"}, {"binary", binary}, {"period_s", period}}}}}}};
    nlohmann::ordered_json ordered = nlohmann::ordered_json::parse(request.dump());
    view.watch_channels(Members(ordered));
  }
  std::vector<double> times() const {
    std::vector<double> result;
    for (const std::string& each : sent) result.push_back(Plain::parse(each)["params"]["time_s"]);
    return result;
  }
};

}  // namespace

TEST_CASE("clients are told what the cell looks like, with short numbers") {
  test::SessionFixture fixture(json_session);
  fixture.say(R"({"jsonrpc": "2.0", "id": 1, "method": "hello", "params": {"token": "viewers"}})");
  const auto ask = [&] {
    return Plain::parse(fixture.say(R"({"jsonrpc": "2.0", "id": 2, "method": "scene.get"})").front());
  };
  CHECK(ask()["error"]["data"]["why"] == "absent");
  const Scene scene = two_bodies();
  fixture.context.scene = &scene;
  const Plain told = ask()["result"];
  CHECK(
      told["bodies"][1] ==
      Plain(
          {{"name", "arm"}, {"moves", true}, {"position", {0.1, 0.2, 0.3}}, {"turn", {0.0, 0.0, 1.0, 0.0}}}));
  CHECK(told["shapes"][0]["kind"] == "box");
  CHECK_FALSE(told["shapes"][0].contains("corners"));
  CHECK(told["shapes"][1]["corners"].size() == 9);
  CHECK(told["shapes"][1]["triangles"] == Plain({0, 1, 2}));
  CHECK(told["tip"]["body"] == 1);
  CHECK(told["tip"]["position"][2] == 0.5);
}

TEST_CASE("locations are placed in the scene by the robot's own meaning of a pose") {
  Locations book({{"HOME", {100, 0, 0, 0, 0, 90}}}, "");
  DeskOptions options;
  options.book = &book;
  test::SessionFixture fixture(json_session, options);
  Scene scene = two_bodies();
  scene.place = [](const PoseFigures& figures) {
    return ScenePose{{figures[0] / 1000, 0, 0.7}, {0, 0, 0, 1}};
  };
  fixture.context.scene = &scene;
  fixture.say(R"({"jsonrpc": "2.0", "id": 1, "method": "hello", "params": {"token": "viewers"}})");
  const Plain told = Plain::parse(
      fixture.say(R"({"jsonrpc": "2.0", "id": 2, "method": "scene.locations"})").front())["result"];
  REQUIRE(told.size() == 1);
  CHECK(told[0]["location"] == "HOME");
  CHECK(told[0]["position"] == Plain({0.1, 0.0, 0.7}));
}

TEST_CASE("rows come as text or as numbers of four bytes") {
  LiveFixture live;
  live.watch(false, 0.001);
  live.view.show(rows_at(1s, {1, 2, 3, 4}));
  const Plain text = Plain::parse(live.sent.at(0));
  CHECK(text["method"] == "rows");
  CHECK(text["params"]["rows"] == Plain({{1.0, 2.0}, {3.0, 4.0}}));
  CHECK(text["params"]["dropped"] == 3);
  live.watch(true, 0.001);
  live.view.show(rows_at(2s, {1, 2, 3, 4, 5, 6}));
  const std::string& bytes = live.sent.at(1);
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data(), sizeof length);
  const Plain head = Plain::parse(bytes.substr(4, length));
  CHECK(head == Plain({{"channel", "poses"}, {"time_s", 2.0}, {"rows", 3}, {"fields", 2}, {"dropped", 3}}));
  REQUIRE(bytes.size() == 4 + length + 6 * sizeof(float));
  float last = 0;
  std::memcpy(&last, bytes.data() + bytes.size() - sizeof last, sizeof last);
  CHECK(last == 6);
}

TEST_CASE("rows come at most 30 times in a second of the wall, however quick the cell is") {
  LiveFixture live;
  live.watch(false, 0.001);
  // A cell that is a hundred times as quick as the wall, for two seconds of it.
  for (int i = 0; i < 2000; ++i) {
    live.now += 1ms;
    live.view.show(rows_at(i * 100ms, {0, 0}));
  }
  CHECK(live.sent.size() >= 55);
  CHECK(live.sent.size() <= 62);
}

TEST_CASE("rows of a cell at the pace of the wall come all, though some are early") {
  LiveFixture live;
  live.watch(false, 0.034);
  for (int i = 0; i < 100; ++i) {
    live.now += i % 2 == 0 ? 24ms : 44ms;
    live.view.show(rows_at(i * 34ms, {0, 0}));
  }
  CHECK(live.sent.size() == 100);
}

TEST_CASE("the last rows come although they were too early, once no others follow") {
  LiveFixture live;
  live.watch(false, 0.5);
  live.view.show(rows_at(1s, {0, 0}));
  live.now += 40ms;
  live.view.show(rows_at(1040ms, {1, 0}));
  live.view.catch_up();
  CHECK(live.times() == std::vector<double>{1});
  live.now += 120ms;
  live.view.catch_up();
  live.view.catch_up();
  CHECK(live.times() == std::vector<double>{1, 1.04});
}

TEST_CASE("who begins to watch gets the last rows at once: the cell may stand") {
  LiveFixture live;
  live.latest["poses"] = rows_at(7s, {1, 2});
  live.watch(false, 0.034);
  live.view.begin();
  CHECK(live.times() == std::vector<double>{7});
}
