// Serial lines in virtual time.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "runtime/drivers/wire.hpp"

namespace pal::runtime::drivers {
namespace {

using namespace std::chrono_literals;

struct Listener final : LinkUser {
  explicit Listener(const Timeline& timeline) : clock(timeline) {}
  void on_bytes(Bytes bytes) override {
    text += as_text(bytes);
    times.push_back(clock.now());
  }
  void on_break(std::string_view reason) override { broken = reason; }

  const Timeline& clock;
  std::string text;
  std::string broken;
  std::vector<Time> times;
};

struct Line {
  explicit Line(double baud) : wire(timeline, {baud, 10}) {
    wire.a().connect(&at_a);
    wire.b().connect(&at_b);
  }
  Timeline timeline;
  Wire wire;
  Listener at_a{timeline};
  Listener at_b{timeline};
};

TEST_CASE("bytes take ten bits each, and wait for those before them", "[wire]") {
  Line line(10000);  // a byte each millisecond
  line.wire.a().write(as_bytes("abc"));
  line.wire.a().write(as_bytes("d"));
  line.wire.b().write(as_bytes("x"));  // the other way is free
  line.timeline.advance_to(10ms);
  REQUIRE(line.at_b.text == "abcd");
  REQUIRE(line.at_b.times == std::vector<Time>{3ms, 4ms});
  REQUIRE(line.at_a.times == std::vector<Time>{1ms});
}

TEST_CASE("a cut line loses what is on its way, and tells both ends once", "[wire]") {
  Line line(10000);
  line.wire.a().write(as_bytes("abc"));
  line.timeline.advance_to(1ms);
  line.wire.cut("unplugged");
  line.wire.a().write(as_bytes("d"));
  line.timeline.advance_to(10ms);
  REQUIRE(line.at_b.text.empty());
  REQUIRE(line.at_a.broken == "unplugged");
  REQUIRE(line.at_b.broken == "unplugged");
  line.wire.mend();
  line.wire.a().write(as_bytes("e"));
  line.timeline.advance_to(20ms);
  REQUIRE(line.at_b.text == "e");
}

TEST_CASE("bytes can be tampered with on their way", "[wire]") {
  Line line(10000);
  line.wire.tamper([](Carrier::Direction, std::vector<std::uint8_t>& bytes) { bytes.front() ^= 1U; });
  line.wire.a().write(as_bytes("a"));
  line.timeline.advance_to(10ms);
  REQUIRE(line.at_b.text == "`");
}

TEST_CASE("at 38400 baud 15 bytes take 3.906 ms", "[wire]") {
  REQUIRE(LineSpeed{38400, 10}.duration(15) == 3906250ns);
}

}  // namespace
}  // namespace pal::runtime::drivers
