// A cell that works and shows itself, and clients that ask for everything at once: all threads of a server
// together.
#include <atomic>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "server/access.hpp"
#include "server/client.hpp"
#include "server/server.hpp"
#include "tests/unit/server/support.hpp"

using namespace pal;
using namespace pal::server;
using namespace std::chrono_literals;
using Json = nlohmann::json;

namespace {

constexpr int rounds = 10;

Channels all_forms() {
  Channels result;
  result.push_back({"force", "", {{"fz", "N"}}, 1000, Channel::Form::numbers, [](auto raw, auto shown) {
                      shown[0] = raw[0];
                    }});
  result.push_back({"profile",
                    "",
                    {{"y", "mm"}, {"z", "mm"}},
                    0,
                    Channel::Form::profile,
                    {},
                    {},
                    [](const Profile& profile) {
                      return std::vector<ProfileMark>{{"first", {{profile.y.front(), profile.z.front()}}}};
                    }});
  result.push_back({"poses", "", {{"x", "m"}, {"y", "m"}}, 29, Channel::Form::rows});
  return result;
}

/// Each skill lasts 20 ms of the cell, which is several times as quick as the wall, and shows all of them.
class ShowingCell final : public operations::SkillRunner, public TaughtRobot {
 public:
  explicit ShowingCell(TelemetrySink& sink)
      : sink_(sink), writer_(1, {10, 100, 5ms}, [&sink](std::shared_ptr<const SampleBlock> block) {
          sink.show(std::move(block));
        }) {}

  operations::SkillResult run(const std::string&, const std::vector<operations::Parameter>&,
                              std::optional<Duration>) override {
    for (int i = 0; i < 20; ++i) {
      time_ += 1ms;
      if (sink_.watched()) writer_.record(time_)[0] = static_cast<double>(i);
    }
    if (sink_.wanted()) sink_.show(Telemetry{time_});
    Profile profile;
    profile.y = {-1, 1};
    profile.z = {200, 201};
    profile.scanned = 2;
    sink_.show(time_, profile);
    sink_.show(std::vector{std::make_shared<const Rows>(Rows{"poses", time_, {1, 2, 3, 4}})});
    std::this_thread::sleep_for(2ms);
    using Kind = operations::SkillResult::Kind;
    if (stopped_) return {Kind::stopped, 2, "stopped as asked"};
    return {Kind::normal, 0, ""};
  }
  bool delay(Duration length) override {
    time_ += length;
    return !stopped_;
  }
  operations::Reading sense(const std::string&) override {
    time_ += 10ms;
    return {20.0, {}, stopped_};
  }
  Duration now() const override { return time_; }
  void stop() noexcept override { stopped_ = true; }
  void allow() override { stopped_ = false; }

  Location here() const override { return {"", {1, 2, 3, 4, 5, 6}, {{1, 2, 3, 4, 5, 6}}}; }
  void teach(const std::string& name, const PoseFigures& pose) override { known[name] = pose; }
  void forget(const std::string& name) override { known.erase(name); }
  std::string problem_of_name(const std::string&) const override { return ""; }

  std::map<std::string, PoseFigures> known;

 private:
  TelemetrySink& sink_;
  BlockWriter writer_;
  Duration time_{};
  std::atomic<bool> stopped_ = false;
};

struct CountedTrials final : Trials {
  TrialResult run(const Trial& trial, const std::function<bool()>& stop) override {
    TrialResult got;
    if (stop()) return got;
    ++tried;
    got.result.code = static_cast<int>(trial.seed);
    return got;
  }
  std::atomic<int> tried = 0;
};

struct TemporaryFolder {
  std::string path = std::filesystem::temp_directory_path() / ("pal-at-once-" + make_token());
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
};

/// A server that offers all that one can offer.
struct WholeServer {
  WholeServer() : server(server_options()), cell(server), desk(cell, skills(), server, desk_options()) {
    server.start(desk);
    worker.emplace(desk);
  }
  ~WholeServer() {
    desk.end();
    worker.reset();
    server.stop();
  }
  ServerOptions server_options() {
    scene.bodies = {{"world", false, {}}, {"arm", true, {}}};
    scene.place = [](const PoseFigures& figures) { return ScenePose{{figures[0], figures[1], figures[2]}}; };
    ServerOptions result;
    result.tokens = {"secret", "operators", "viewers"};
    result.line_port = 0;
    result.store = &store;
    result.knowledge = &knowledge;
    result.runs = &runs;
    result.trials = &trials;
    result.scene = &scene;
    result.recording = &recording;
    result.channels = channels;
    return result;
  }
  DeskOptions desk_options() {
    DeskOptions result;
    result.sensors = {{"eye", {"mm", "what it sees"}}};
    result.locations = book.names();
    result.book = &book;
    result.robot = &cell;
    result.runs = &runs;
    result.recording = &recording;
    return result;
  }
  static operations::Skills skills() { return test::clockwork_skills(); }
  std::unique_ptr<Client> enter(const std::string& name) const {
    auto client = std::make_unique<Client>("127.0.0.1", server.port());
    client->call("hello", Json{{"token", "secret"}, {"name", name}}.dump());
    return client;
  }

  TemporaryFolder folder;
  Store store{folder.path};
  Knowledge knowledge;
  RunHistory runs{""};
  Channels channels = all_forms();
  RunRecording recording{"", channels};
  CountedTrials trials;
  Scene scene;
  Locations book{{{"HOME", {0, 0, 0, 0, 0, 0}}}, ""};
  Server server;
  ShowingCell cell;
  Desk desk;
  std::optional<test::Worker> worker;
};

/// Does its work in a thread of its own. What went wrong is told by end(): checks belong to the test's
/// thread.
class Beside {
 public:
  explicit Beside(std::function<void(const std::stop_token&)> work)
      : thread_([this, work = std::move(work)](const std::stop_token& stop) {
          try {
            work(stop);
          } catch (const std::exception& problem) {
            wrong_ = problem.what();
          }
        }) {}
  /// Waits for its end; empty: all went well.
  std::string end() {
    thread_.join();
    return wrong_;
  }
  std::string stop() {
    thread_.request_stop();
    return end();
  }

 private:
  std::string wrong_;
  std::jthread thread_;
};

/// Counts what a client is told that watches all there is.
struct Watched {
  std::uint64_t last = 0;  // event
  bool in_order = true;
  std::size_t samples = 0, profiles = 0, rows = 0, telemetry = 0;

  void take(const Json& message) {
    const std::string method = message["method"];
    const Json& params = message["params"];
    if (method == "event") {
      const std::uint64_t number = params["number"];
      in_order = in_order && (last == 0 || number == last + 1);
      last = number;
    } else if (method == "samples") {
      for (const Json& span : params["spans"]) samples += span["count"].get<std::size_t>();
    } else if (method == "profile") {
      profiles += params["marks"].size();
    } else if (method == "rows") {
      rows += params["rows"].size();
    } else if (method == "telemetry") {
      ++telemetry;
    }
  }
};

void wait_for_rest(Client& client) {
  for (int i = 0; i < 2000 && Json::parse(client.call("state"))["activity"] != "idle"; ++i)
    std::this_thread::sleep_for(5ms);
  REQUIRE(Json::parse(client.call("state"))["activity"] == "idle");
}

}  // namespace

TEST_CASE("everything at once: each client is answered while the cell works and shows itself") {
  WholeServer whole;
  const auto person = whole.enter("person");
  person->call("operation.load", Json{{"main", "o"}, {"files", {{"o", test::endless}}}}.dump());

  Watched told;
  std::atomic<bool> watches = false;
  Beside watcher([&](const std::stop_token& stop) {
    const auto client = whole.enter("watcher");
    client->call("watch", R"({"telemetry": 0.001})");
    client->call("channels.watch",
                 R"({"channels": [{"channel": "force"}, {"channel": "profile"}, {"channel": "poses"}]})");
    watches = true;
    while (!stop.stop_requested())
      if (const auto text = client->next(20ms)) told.take(Json::parse(*text));
  });
  for (int i = 0; i < 1000 && !watches; ++i) std::this_thread::sleep_for(5ms);
  REQUIRE(watches);
  person->call("operation.run");

  Beside asker([&](const std::stop_token&) {
    const auto client = whole.enter("asker");
    for (int i = 0; i < rounds; ++i) {
      for (const char* method :
           {"state", "snapshot", "clients", "skills", "sensors", "requirements", "channels.list", "scene.get",
            "scene.locations", "locations.list", "history.list", "replay.list", "operation.breakpoints"})
        client->call(method);
      client->call("operation.values", R"({"icon": "a"})");
      client->call("history.steps", R"({"skill": "quick"})");
      client->call("history.read", R"({"run": 1})");
      client->call("replay.read", R"({"run": 1, "channel": "force"})");
    }
  });
  Beside saver([&](const std::stop_token&) {
    const auto client = whole.enter("saver");
    // Longer than what the thread of the sockets reads itself.
    Json large = Json::parse(test::endless);
    large["description"] = std::string(30'000, 'x');
    const std::string text = large.dump();
    for (int i = 0; i < rounds; ++i) {
      client->call("store.save",
                   Json{{"name", "kept"}, {"text", text}, {"based_on", i}, {"note", "again"}}.dump());
      client->call("store.read", R"({"name": "kept"})");
      client->call("store.list");
      client->call("operation.check", Json{{"main", "o"}, {"files", {{"o", text}}}}.dump());
      client->call("operation.format", Json{{"text", text}}.dump());
      client->call("study.try", Json{{"skill", "quick"}, {"seed", i}}.dump());
    }
  });
  Beside scholar([&](const std::stop_token& stop) {
    for (double i = 0; !stop.stop_requested(); ++i) {
      auto facts = std::make_shared<Facts>();
      KnownRequirement fresh;
      fresh.name = "fresh";
      facts->skills["quick"].requirements.push_back(fresh);
      whole.knowledge.learn(std::move(facts));
      whole.knowledge.measure("quick", "fresh", {i, i}, false);
      std::this_thread::sleep_for(1ms);
    }
  });
  // Meanwhile one client has the controls. Breakpoints are changed between two skills.
  for (int i = 0; i < rounds; ++i) {
    person->call("operation.break", R"({"icon": "a", "code": 9})");
    person->call("operation.clear");
    person->call("operation.pause");
    wait_for_rest(*person);
    person->call("operation.set", R"({"icon": "a", "parameter": "code", "value": 0})");
    person->call("locations.teach", R"({"location": "PLACE"})");
    person->call("sensor.read", R"({"sensor": "eye"})");
    person->call("operation.resume");
  }
  CHECK(asker.end() == "");
  CHECK(saver.end() == "");
  person->call("operation.stop");
  wait_for_rest(*person);
  CHECK(scholar.stop() == "");
  // Messages on their way still come.
  std::this_thread::sleep_for(200ms);
  CHECK(watcher.stop() == "");

  CHECK(told.in_order);
  CHECK(told.last > rounds);
  CHECK(told.samples > 0);
  CHECK(told.profiles > 0);
  CHECK(told.rows > 0);
  CHECK(told.telemetry > 0);
  CHECK(whole.trials.tried == rounds);
  CHECK(whole.store.versions("kept").size() == rounds);
  CHECK(whole.book.list().back().version == rounds);
  const RunPage page = whole.runs.list(std::nullopt, 10, "");
  REQUIRE(page.runs.size() == 1);
  CHECK(page.runs.front().state == "stopped");
  CHECK(page.runs.front().steps > rounds);
  for (const char* channel : {"force", "profile", "poses"})
    CHECK_FALSE(whole.recording.read(1, channel, Duration::min(), 10).times.empty());
}
