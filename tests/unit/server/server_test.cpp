// The server with real sockets on this machine, and clients that mean ill.
#include "server/server.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <ctime>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "server/client.hpp"
#include "tests/unit/server/support.hpp"

using namespace pal;
using namespace pal::server;
using namespace std::chrono_literals;
using Json = nlohmann::json;

namespace {

ServerOptions options() {
  ServerOptions result;
  result.tokens = {"secret", "operators", "viewers"};
  result.line_port = 0;
  result.line_terminal = true;
  result.admit_within = 300ms;
  return result;
}

struct Served {
  explicit Served(ServerOptions given = options(), DeskOptions desk_options = {})
      : server(std::move(given)), desk(cell, test::clockwork_skills(), server, std::move(desk_options)) {
    server.start(desk);
    worker.emplace(desk);
  }
  ~Served() {
    desk.end();
    worker.reset();
    server.stop();
  }
  std::unique_ptr<Client> enter(const std::string& name) {
    auto client = std::make_unique<Client>("127.0.0.1", server.port());
    client->call("hello", Json{{"token", "secret"}, {"name", name}}.dump());
    return client;
  }
  void load(Client& client, const char* text) {
    client.call("operation.load", Json{{"main", "o"}, {"files", {{"o", text}}}}.dump());
  }
  /// Until the desk's state is this.
  void wait_for(operations::ExecutionState state) {
    for (int i = 0; i < 500 && desk.status(0).state != state; ++i) std::this_thread::sleep_for(10ms);
    REQUIRE(desk.status(0).state == state);
  }

  test::Clockwork cell;
  Server server;
  Desk desk;
  std::optional<test::Worker> worker;
};

/// Bytes in and out, without anything that would mend them.
class Raw {
 public:
  explicit Raw(std::uint16_t port) : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in where{};
    where.sin_family = AF_INET;
    where.sin_port = htons(port);
    where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(::connect(descriptor_, reinterpret_cast<sockaddr*>(&where), sizeof where) == 0);
  }
  explicit Raw(const std::string& terminal)
      : descriptor_(::open(terminal.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    REQUIRE(descriptor_ >= 0);
  }
  ~Raw() { ::close(descriptor_); }
  Raw(const Raw&) = delete;
  Raw& operator=(const Raw&) = delete;
  void write(const std::string& bytes) {
    // A client that hangs up in between is no mistake here.
    if (::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0 && errno == ENOTSOCK)
      REQUIRE(::write(descriptor_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  }
  /// Until this is read, the far side hangs up, or five seconds are over.
  std::string read_until(const std::string& end) {
    std::string text;
    pollfd what{descriptor_, POLLIN, 0};
    while (text.find(end) == std::string::npos && ::poll(&what, 1, 5000) > 0) {
      std::array<char, 4096> bytes{};
      const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
      if (count <= 0) return text + "<end>";
      text.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int descriptor_;
};

/// "2026-11-24T09:30:00.123Z".
std::chrono::system_clock::time_point time_of(const std::string& wall) {
  std::tm parts{};
  int milliseconds = 0;
  std::istringstream text(wall);
  char point = 0;
  text >> std::get_time(&parts, "%Y-%m-%dT%H:%M:%S") >> point >> milliseconds;
  REQUIRE(point == '.');
  return std::chrono::system_clock::from_time_t(::timegm(&parts)) + std::chrono::milliseconds(milliseconds);
}

}  // namespace

TEST_CASE("clients of both protocols run the same skills") {
  Served served;
  const auto web = served.enter("web");
  CHECK(Json::parse(web->call("skill.run", R"({"skill": "quick", "parameters": {"code": 3}})"))["code"] == 3);
  web->call("controls.release");
  Raw line(*served.server.line_port());
  line.write("token secret\r");
  CHECK(line.read_until("\n") == "#0\r\n");
  line.write("quick 3\r");
  CHECK(line.read_until("\n") == "#3\r\n");
  line.write("release\r");
  CHECK(line.read_until("\n") == "#0\r\n");
  {
    Raw terminal(served.server.terminal());
    terminal.write("token secret\r");
    CHECK(terminal.read_until("\n") == "#0\r\n");
    terminal.write("quick 4\r");
    CHECK(terminal.read_until("\n") == "#4\r\n");
  }
  // The next user of the terminal shows the token again.
  std::this_thread::sleep_for(200ms);
  Raw next(served.server.terminal());
  next.write("quick 4\r");
  CHECK(next.read_until("\n").rfind("!say 'token'", 0) == 0);
  CHECK(served.cell.runs == 3);
}

TEST_CASE("a client without token or rights moves nothing and is disconnected") {
  Served served;
  SECTION("a wrong token") {
    Client client("127.0.0.1", served.server.port());
    CHECK_THROWS_AS(client.call("hello", R"({"token": "Secret"})"), RemoteError);
    CHECK_THROWS(client.receive(2s));
  }
  SECTION("none at all, in time") {
    Client client("127.0.0.1", served.server.port());
    CHECK_THROWS(client.receive(2s));
    Raw line(*served.server.line_port());
    CHECK(line.read_until("x") == "<end>");
  }
  SECTION("a page of another site") {
    CHECK_THROWS(Client("127.0.0.1", served.server.port(), "http://evil.example"));
    CHECK_NOTHROW(Client("127.0.0.1", served.server.port(),
                         "http://127.0.0.1:" + std::to_string(served.server.port())));
  }
  SECTION("another site's name for this machine") {
    Raw raw(served.server.port());
    raw.write(
        "GET / HTTP/1.1\r\nHost: evil.example\r\nUpgrade: websocket\r\nConnection: upgrade\r\n"
        "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
    CHECK(raw.read_until("<").rfind("HTTP/1.1 403", 0) == 0);
  }
  SECTION("no WebSocket") {
    Raw raw(served.server.port());
    raw.write("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
    const std::string answer = raw.read_until("<end>");
    CHECK(answer.starts_with("HTTP/1.1 404"));
    CHECK(answer.find("started without one (--page FOLDER)") != std::string::npos);
  }
  SECTION("a header without end") {
    Raw raw(served.server.port());
    raw.write("GET / HTTP/1.1\r\nA: " + std::string(100'000, 'a'));
    CHECK(raw.read_until("<end>").find("<end>") != std::string::npos);
  }
  SECTION("a hello as long as an operation") {
    Client client("127.0.0.1", served.server.port());
    CHECK_THROWS([&] {
      client.send(std::string(100'000, ' '));
      client.receive(2s);
    }());
  }
  SECTION("a frame that is announced too large") {
    const auto client = served.enter("ann");
    CHECK_THROWS([&] {
      client->send(std::string(std::size_t{2} << 20, ' '));
      for (int i = 0; i < 10; ++i) client->receive(1s);
    }());
  }
  CHECK(served.cell.runs == 0);
  CHECK_NOTHROW(served.enter("another"));  // and the server lives
}

TEST_CASE("clients without a token keep nobody out, and are let go oldest first") {
  ServerOptions patient = options();
  patient.admit_within = 10s;
  patient.most_unknown = 8;
  Served served(patient);
  const auto ann = served.enter("ann");
  served.load(*ann, test::two_long);
  ann->call("operation.run");
  served.cell.wait_until_inside();
  std::vector<std::unique_ptr<Raw>> crowd;
  for (int i = 0; i < 40; ++i)
    crowd.push_back(std::make_unique<Raw>(i % 2 == 0 ? served.server.port() : *served.server.line_port()));
  const auto bob = served.enter("bob");
  CHECK_NOTHROW(bob->call("operation.stop"));
  served.wait_for(operations::ExecutionState::stopped);
  CHECK(crowd.front()->read_until("<end>") == "<end>");
}

TEST_CASE("a server whose places are taken still takes a stop, by both protocols") {
  ServerOptions few = options();
  few.line_terminal = false;
  few.most_clients = 1;
  few.most_extra = 2;
  Served served(few);
  const auto only = served.enter("only");
  served.load(*only, test::two_long);
  only->call("operation.run");
  served.cell.wait_until_inside();
  const auto second = served.enter("second");
  CHECK_THROWS_WITH(second->call("controls.take"),
                    "a viewer may not do that; the places for clients are taken: look, pause and stop");
  SECTION("JSON") {
    CHECK_NOTHROW(second->call("stop"));
  }
  SECTION("lines") {
    Raw line(*served.server.line_port());
    line.write("token secret\rstop\r");
    CHECK(line.read_until("#0\r\n#0\r\n") == "#0\r\n#0\r\n");
  }
  served.wait_for(operations::ExecutionState::stopped);
  // More of them only drive one another out.
  std::vector<std::unique_ptr<Client>> more;
  for (int i = 0; i < 5; ++i) more.push_back(served.enter("more"));
  CHECK_NOTHROW(more.back()->call("stop"));
  CHECK(Json::parse(only->call("state")).at("yours") == true);
}

TEST_CASE("a skill alone stops within a second when its client goes, unless that was asked for") {
  Served served;
  const bool goes_on = GENERATE(false, true);
  auto ann = served.enter("ann");
  Json request{{"jsonrpc", "2.0"}, {"id", 1}, {"method", "skill.run"}, {"params", {{"skill", "long"}}}};
  request["params"]["goes_on"] = goes_on;
  ann->send(request.dump());
  served.cell.wait_until_inside();
  ann.reset();
  bool idle = false;
  for (int i = 0; i < 100 && !idle; ++i) {
    std::this_thread::sleep_for(10ms);
    idle = served.desk.status(0).activity == Activity::idle;
  }
  CHECK(idle == !goes_on);
  served.cell.let_go();
}

TEST_CASE("a long check of one client does not keep another's stop waiting") {
  Served served;
  const auto ann = served.enter("ann");
  const auto bob = served.enter("bob");
  served.load(*bob, test::two_long);
  bob->call("operation.run");
  served.cell.wait_until_inside();
  std::string chain =
      R"({"operation-format": 1, "name": "chain", "icons": [{"id": "s", "kind": "start", "next": "m0"})";
  for (int i = 0; i < 9000; ++i)
    chain += ",{\"id\": \"m" + std::to_string(i) + "\", \"kind\": \"merge\", \"next\": \"m" +
             std::to_string(i + 1) + "\"}";
  chain += R"(,{"id": "m9000", "kind": "exit"}]})";
  for (int i = 0; i < 10; ++i)
    ann->send(Json{{"jsonrpc", "2.0"},
                   {"id", i},
                   {"method", "operation.check"},
                   {"params", {{"main", "o"}, {"files", {{"o", chain}}}}}}
                  .dump());
  const auto begin = std::chrono::steady_clock::now();
  bob->call("operation.stop");
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  INFO(taken.count() << " ms");
  CHECK(taken.count() < 500);  // 5 ms on an idle machine: the benchmark has the figure
  served.wait_for(operations::ExecutionState::stopped);
}

TEST_CASE("closings have a reason, and the server's end is told") {
  auto served = std::make_unique<Served>();
  const auto ann = served->enter("ann");
  ann->call("watch");
  Client stranger("127.0.0.1", served->server.port());
  CHECK_THROWS(stranger.call("hello", R"({"token": "Secret"})"));
  CHECK_THROWS_WITH(stranger.receive(2s), Catch::Contains("a wrong token"));
  served.reset();
  std::string last;
  try {
    for (;;)
      if (const auto text = ann->next(2s)) last = *text;
  } catch (const std::runtime_error& problem) {
    CHECK_THAT(problem.what(), Catch::Contains("the server ends"));
  }
  CHECK(Json::parse(last)["params"]["event"] == "ending");
}

TEST_CASE("what is no request of HTTP is told so") {
  Served served;
  const auto answer = [&](const std::string& bytes) {
    Raw raw(served.server.port());
    raw.write(bytes);
    return raw.read_until("<never>");
  };
  using Catch::Contains;
  CHECK_THAT(answer("hello?\r\n\r\n"), Contains(" 400 ") && Contains("no request of HTTP"));
  CHECK_THAT(answer("POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 2\r\n\r\n{}"),
             Contains(" 413 ") && Contains("JSON-RPC"));
  CHECK_THAT(answer("GET / HTTP/1.1\r\nLong: " + std::string(9000, 'a') + "\r\n\r\n"),
             Contains(" 431 ") && Contains("too long"));
}

TEST_CASE("a client that is killed leaves the cell to another") {
  Served served;
  auto ann = served.enter("ann");
  const auto bob = served.enter("bob");
  served.load(*ann, test::two_long);
  ann->call("operation.run");
  served.cell.wait_until_inside();
  CHECK_THROWS_WITH(bob->call("operation.resume"),
                    "'ann' has the controls; other clients may only pause and stop");
  ann.reset();  // without a word
  for (int i = 0; i < 300 && !served.desk.status(0).holder.empty(); ++i) std::this_thread::sleep_for(10ms);
  served.cell.let_go();
  served.wait_for(operations::ExecutionState::paused);
  bob->call("operation.resume");
  served.wait_for(operations::ExecutionState::ended);
}

TEST_CASE("more than a thousand events a second come in order") {
  Served served;
  served.cell.lasts = 500us;
  const auto ann = served.enter("ann");
  served.load(*ann, test::endless);
  ann->call("watch");
  ann->call("operation.run");
  using Seconds = std::chrono::duration<double>;
  // On a busy machine others have the processor for a while, but not all the time: the fastest row counts,
  // from when its first event happened until its last one is here.
  constexpr int rows = 20, in_a_row = 250;
  Seconds fastest = 1h;
  std::uint64_t last = 0;
  for (int row = 0; row < rows; ++row) {
    std::chrono::system_clock::time_point begin;
    for (int i = 0; i < in_a_row; ++i) {
      const auto text = ann->next(10s);
      REQUIRE(text);
      const Json event = Json::parse(*text)["params"];
      const std::uint64_t number = event["number"];
      if (last > 0) REQUIRE(number == last + 1);
      last = number;
      if (i == 0) begin = time_of(event["wall"]);
    }
    fastest = std::min(fastest, Seconds(std::chrono::system_clock::now() - begin));
  }
  INFO(in_a_row / fastest.count() << " events a second");
  CHECK(in_a_row / fastest.count() > 1000);
}

TEST_CASE("events of many runs take no more memory than those of few") {
  Served served;
  const auto ann = served.enter("ann");
  operations::Step step;
  step.icon = "part/side";
  step.skill = "quick";
  for (int i = 0; i < 10; ++i) step.parameters.push_back({"parameter-" + std::to_string(i), 0.5 * i, {}, {}});
  const auto held_after = [&](int events) {
    for (int i = 0; i < events; ++i) {
      served.server.make_room();
      served.desk.tell(StepEnds{step});
    }
    // The server's thread has taken them before it answers this.
    ann->call("state");
    const auto memory = ::mallinfo2();
    return memory.uordblks + memory.hblkhd;
  };
  // An allocator of a sanitizer tells nothing here, or always the same.
  const std::size_t few = held_after(1000), many = held_after(12'000);
  INFO(few << " bytes, then " << many);
  CHECK(many < few + (std::size_t{1} << 20));
}

TEST_CASE("a client that reads nothing is disconnected, and no other client is") {
  ServerOptions given = options();
  given.outbox.most_bytes = 1 << 20;
  Served served(given);
  const auto ann = served.enter("ann");
  const auto sleeper = served.enter("sleeper");
  sleeper->call("watch");
  served.load(*ann, test::endless);
  ann->call("operation.run");
  CHECK_THROWS([&] {
    std::this_thread::sleep_for(1s);
    for (;;) sleeper->receive(2s);
  }());
  ann->call("operation.stop");
  served.wait_for(operations::ExecutionState::stopped);
}

TEST_CASE("unread telemetry is dropped and counted, and events are not") {
  Served served;
  const auto ann = served.enter("ann");
  ann->call("watch", R"({"telemetry": 0.001})");
  for (int i = 0; i < 500 && !served.server.wanted(); ++i) std::this_thread::sleep_for(2ms);
  REQUIRE(served.server.wanted());
  Profile wide;
  wide.y.assign(255, 1.2345678);
  wide.z = wide.y;
  for (int i = 0; i < 20'000; ++i) served.server.show(Duration(std::chrono::milliseconds(i)), wide);
  ann->call("skill.run", R"({"skill": "quick"})");
  std::uint64_t dropped = 0, events = 0, samples = 0;
  while (const auto text = ann->next(300ms)) {
    const Json message = Json::parse(*text);
    if (message["method"] == "event") ++events;
    if (message["method"] != "profile") continue;
    ++samples;
    dropped = message["params"]["dropped"];
  }
  CHECK(events >= 3);  // controls, begins, ends
  CHECK(dropped > 0);
  CHECK(samples + dropped == 20'000);
}
