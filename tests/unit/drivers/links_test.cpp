// Links that leave the process, and time that goes by the wall clock.
#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "runtime/drivers/streams/bridge.hpp"
#include "runtime/drivers/streams/carrier.hpp"
#include "runtime/drivers/streams/outside.hpp"

namespace pal::runtime::drivers {
namespace {

using namespace std::chrono_literals;

struct Listener final : LinkUser {
  void on_bytes(Bytes bytes) override { text += as_text(bytes); }
  void on_break(std::string_view reason) override { broken = reason; }
  std::string text;
  std::string broken;
};

struct NoPhysics final : World {
  void advance_to(Time) override {}
};

// At a factor of 1000 a station second lasts a millisecond.
struct Bench {
  template <class Condition>
  void until(Condition condition) {
    for (int i = 0; i < 2000 && !condition(); ++i) station.idle(1s);
    REQUIRE(condition());
  }
  NoPhysics physics;
  Outside outside{1000};
  Station station{physics, &outside};
};

TEST_CASE("a carrier passes every byte, both ways", "[links]") {
  for (const bool tcp : {false, true}) {
    const auto carrier = tcp ? tcp_carrier() : pseudo_terminal_carrier();
    std::vector<std::uint8_t> all(3000);  // more than goes through at once, and every value of a byte
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
    CHECK(carrier->carry(Carrier::Direction::to_b, all) == all);
    CHECK(carrier->carry(Carrier::Direction::to_a, all) == all);
    CHECK(carrier->carry(Carrier::Direction::to_a, {}).empty());
  }
}

TEST_CASE("a program at the far end of a pseudo-terminal is heard and answered", "[links]") {
  Bench bench;
  Listener user;
  const auto link = bench.outside.open_pseudo_terminal(bench.station.timeline());
  link->connect(&user);
  const int program = ::open(link->address().c_str(), O_RDWR | O_NOCTTY);
  REQUIRE(program >= 0);
  REQUIRE(::write(program, "\x03hello\r", 7) == 7);  // control characters are characters like others
  bench.until([&] { return user.text == "\x03hello\r"; });
  link->write(as_bytes("ok\n"));
  char answer[8]{};
  CHECK(::read(program, answer, sizeof answer) == 3);
  CHECK(std::string(answer) == "ok\n");
  ::close(program);
  bench.station.idle(10s);
  CHECK(user.broken.empty());  // programs come and go
}

TEST_CASE("over TCP one program may go, which is a break, and another may come", "[links]") {
  Bench bench;
  Listener server, client;
  Timeline& timeline = bench.station.timeline();
  const auto link = bench.outside.listen_tcp(timeline, 0);
  link->connect(&server);
  const auto port =
      static_cast<std::uint16_t>(std::stoi(link->address().substr(link->address().find(':') + 1)));
  auto program = bench.outside.connect_tcp(timeline, "127.0.0.1", port);
  program->connect(&client);
  program->write(as_bytes("one"));
  bench.until([&] { return server.text == "one"; });
  link->write(as_bytes("two"));
  bench.until([&] { return client.text == "two"; });
  program.reset();
  bench.until([&] { return !server.broken.empty(); });
  program = bench.outside.connect_tcp(timeline, "127.0.0.1", port);
  program->write(as_bytes("!"));
  bench.until([&] { return server.text == "one!"; });
}

TEST_CASE("a failure to open is reported with the system's reason", "[links]") {
  Bench bench;
  Timeline& timeline = bench.station.timeline();
  CHECK_THROWS_WITH(bench.outside.open_serial(timeline, "/dev/there-is-none", 38400),
                    "opening serial port /dev/there-is-none: No such file or directory");
  const auto taken = bench.outside.listen_tcp(timeline, 0);
  const auto port =
      static_cast<std::uint16_t>(std::stoi(taken->address().substr(taken->address().find(':') + 1)));
  CHECK_THROWS_WITH(bench.outside.listen_tcp(timeline, port), Catch::Contains("Address already in use"));
}

TEST_CASE("the far end of a pseudo-terminal is opened as a serial port", "[links]") {
  Bench bench;
  Listener near, far;
  const auto terminal = bench.outside.open_pseudo_terminal(bench.station.timeline());
  terminal->connect(&far);
  const auto serial = bench.outside.open_serial(bench.station.timeline(), terminal->address(), 38400);
  serial->connect(&near);
  serial->write(as_bytes("CV\r"));
  bench.until([&] { return far.text == "CV\r"; });
  terminal->write(as_bytes(">"));
  bench.until([&] { return near.text == ">"; });
}

TEST_CASE("a bridge joins a wire, with its baud rate, to a link outside", "[links]") {
  Bench bench;
  Listener device;
  Wire wire(bench.station.timeline(), {9600, 10});
  wire.b().connect(&device);
  const auto link = bench.outside.open_pseudo_terminal(bench.station.timeline());
  const Bridge bridge(wire.a(), *link);
  const int program = ::open(link->address().c_str(), O_RDWR | O_NOCTTY);
  REQUIRE(::write(program, "abc", 3) == 3);
  bench.until([&] { return device.text == "abc"; });
  ::close(program);
}

TEST_CASE("paced time is never ahead of the wall clock, and leaves nothing out", "[links]") {
  Bench bench;
  int happened = 0;
  for (int i = 1; i <= 50; ++i) bench.station.timeline().at(i * 1s, [&] { ++happened; });
  const auto begin = std::chrono::steady_clock::now();
  bench.station.idle(50s);
  const auto took = std::chrono::steady_clock::now() - begin;
  CHECK(happened == 50);
  CHECK(bench.station.now() == 50s);
  CHECK(took >= 49ms);
}

}  // namespace
}  // namespace pal::runtime::drivers
