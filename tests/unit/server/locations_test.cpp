// Locations: versions, names, what is kept of them; and how they are taught through the protocol.
#include "server/locations.hpp"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "server/access.hpp"
#include "server/disk_file.hpp"
#include "tests/unit/server/session_support.hpp"

using namespace pal;
using namespace pal::server;
using Json = nlohmann::json;

namespace {

struct LocationFolder {
  std::string path = std::filesystem::temp_directory_path() / ("pal-locations-" + make_token());
  ~LocationFolder() { std::filesystem::remove_all(path); }
};

const std::map<std::string, PoseFigures> made{{"HOME", {0, 0, 0, 0, 0, 0}},
                                              {"PART", {460, -200, -150, 90, 0, 0}}};

Location at(double x) {
  Location here;
  here.pose = {x, 2, 3, 4, 5, 6};
  here.joints = {1, 2, 3, 4, 5, 6};
  return here;
}

template <class Use>
Refusal::Why why(const Use& use) {
  try {
    use();
  } catch (const StoreProblem& problem) {
    return problem.refusal.why;
  }
  FAIL("it was not refused");
  return {};
}

/// A robot that counts what it is taught.
struct Robot final : TaughtRobot {
  Location here() const override {
    Location place = at(x);
    place.joints = {1, 2, 3, 4, 5, 6};
    return place;
  }
  void teach(const std::string& name, const PoseFigures& pose) override { known[name] = pose; }
  void forget(const std::string& name) override { known.erase(name); }
  std::string problem_of_name(const std::string& name) const override {
    return name == "bad name" ? "it has a space" : "";
  }
  double x = 7;
  std::map<std::string, PoseFigures> known;
};

}  // namespace

TEST_CASE("each change of a location counts its version, and an old version is refused") {
  Locations book(made, "");
  REQUIRE(book.list().size() == 2);
  CHECK(book.list()[1].version == 1);
  CHECK_FALSE(book.list()[1].changed);
  CHECK(book.teach("PART", at(1), std::nullopt, "ann").version == 2);
  CHECK(book.teach("PART", at(2), 2, "ann").version == 3);
  CHECK(why([&] { book.teach("PART", at(3), 2, "bob"); }) == Refusal::Why::newer);
  CHECK(why([&] { book.teach("PART", at(3), 0, "bob"); }) == Refusal::Why::newer);
  CHECK(why([&] { book.teach("NEW", at(3), 4, "bob"); }) == Refusal::Why::absent);
  CHECK(book.teach("NEW", at(3), 0, "bob").version == 1);
  CHECK(why([&] { book.rename("NEW", "PART", std::nullopt, "bob"); }) == Refusal::Why::exists);
  CHECK(book.rename("NEW", "PLACE", 1, "bob").pose[0] == 3);
  CHECK(why([&] { book.remove("NEW", std::nullopt); }) == Refusal::Why::absent);
  CHECK(book.remove("PART", 3) == 3);
  CHECK(book.names() == std::set<std::string>{"HOME", "PLACE"});
  CHECK(book.teach("PART", at(4), 0, "ann").version == 4);
}

TEST_CASE("what was taught is kept with the cell, what the cell is made with later comes in") {
  const LocationFolder folder;
  {
    Locations book(made, folder.path);
    book.teach("SIDE", at(11), 0, "ann");
    book.teach("PART", at(12), 1, "ann");
    book.remove("HOME", 1);
  }
  auto later = made;
  later["FRESH"] = {1, 1, 1, 1, 1, 1};
  const Locations book(later, folder.path);
  CHECK(book.names() == std::set<std::string>{"FRESH", "PART", "SIDE"});
  const auto list = book.list();
  CHECK(list[1].pose[0] == 12);
  CHECK(list[1].version == 2);
  CHECK(list[1].by == "ann");
  REQUIRE(list[1].joints);
  CHECK((*list[1].joints)[5] == 6);
  CHECK(list[1].changed);
}

TEST_CASE("a file that is no such file is refused and left as it is") {
  const LocationFolder folder;
  std::filesystem::create_directories(folder.path);
  const std::string path = folder.path + "/locations.json";
  for (const char* text :
       {"", "{", "[]", R"({"locations-format": 2})",
        R"({"locations-format": 1, "locations": {"A": {"pose": [1], "version": 1}}, "deleted": {}})",
        R"({"locations-format": 1, "locations": {"A": 7}, "deleted": {}})"}) {
    std::ofstream(path) << text;
    INFO(text);
    CHECK(why([&] { Locations(made, folder.path); }) == Refusal::Why::failed);
    CHECK(std::filesystem::file_size(path) == std::string(text).size());
  }
}

TEST_CASE("the robot is taught through the protocol, from where it is") {
  Locations book(made, "");
  Robot robot;
  struct Cell : test::SessionFixture {
    explicit Cell(const DeskOptions& options) : SessionFixture(json_session, options) {
      say(R"({"jsonrpc": "2.0", "id": 1, "method": "hello", "params": {"token": "secret", "name": "ann"}})");
      say(R"({"jsonrpc": "2.0", "id": 1, "method": "watch"})");
    }
    Json call(const std::string& method, const Json& params) {
      auto all = say(Json{{"jsonrpc", "2.0"}, {"id", 2}, {"method", method}, {"params", params}}.dump());
      for (std::string& each : work()) all.push_back(std::move(each));
      Json answer;
      events.clear();
      for (const std::string& each : all) {
        Json message = Json::parse(each);
        if (message.contains("id")) {
          answer = std::move(message);
        } else {
          events.push_back(message["params"]);
        }
      }
      INFO(answer.dump());
      return answer.contains("result") ? answer["result"] : answer["error"]["data"];
    }
    std::vector<Json> events;
  };
  DeskOptions options;
  options.book = &book;
  options.robot = &robot;
  options.locations = book.names();
  options.sensors = {{"weight", {"N", "on the scales", std::pair(0.0, 50.0)}}};
  Cell cell(options);

  const Json taught = cell.call("locations.teach", {{"location", "SIDE"}, {"based_on", 0}});
  CHECK(taught["version"] == 1);
  CHECK(taught["pose"][0] == 7);
  CHECK(taught["by"] == "ann");
  CHECK(robot.known.at("SIDE")[0] == 7);
  REQUIRE_FALSE(cell.events.empty());
  CHECK(cell.events.back()["event"] == "location");
  CHECK(cell.events.back()["change"] == "taught");
  CHECK(cell.desk.cell()->locations->contains("SIDE"));
  CHECK(cell.call("locations.teach", {{"location", "SIDE"}, {"based_on", 0}})["why"] == "newer");
  CHECK(cell.call("locations.teach", {{"location", "bad name"}})["why"] == "wrong");
  CHECK(cell.call("locations.teach", {{"location", "THERE"}, {"pose", {1, 2}}})["why"] == "bad-parameters");
  CHECK(cell.call("locations.teach", {{"location", "THERE"}, {"pose", {1, 2, 3, 4, 5, 6}}})["pose"][5] == 6);
  CHECK(robot.known.at("THERE")[0] == 1);
  CHECK(cell.call("locations.here", Json::object())["pose"][0] == 7);
  CHECK(cell.call("locations.rename", {{"location", "SIDE"}, {"to", "LEFT"}, {"based_on", 1}})["location"] ==
        "LEFT");
  CHECK_FALSE(robot.known.contains("SIDE"));
  CHECK(cell.call("locations.delete", {{"location", "SIDE"}})["why"] == "absent");
  CHECK(cell.call("locations.delete", {{"location", "LEFT"}, {"based_on", 1}}).empty());
  CHECK(cell.call("locations.delete", {{"location", "THERE"}, {"based_on", 1}}).empty());
  CHECK(robot.known.empty());
  CHECK(cell.call("locations.list", Json::object()).size() == 2);

  // Sensors.
  CHECK(cell.call("sensors", Json::object())[0]["value"] == nullptr);
  CHECK(cell.call("sensors", Json::object())[0]["high"] == 50);
  CHECK(cell.call("sensor.read", {{"sensor", "weight"}})["value"] == 20);
  CHECK(cell.call("sensors", Json::object())[0]["value"] == 20);
  CHECK(cell.call("sensor.read", {{"sensor", "colour"}})["why"] == "absent");
  CHECK(cell.call("state", Json::object())["activity"] == "idle");
}
