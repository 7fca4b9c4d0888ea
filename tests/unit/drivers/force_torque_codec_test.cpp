// The protocol of the force-torque sensor, byte by byte.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "runtime/drivers/force_torque/codec.hpp"

namespace pal::runtime::drivers::force_torque {
namespace {

using Progress = Codec::Progress;

Progress feed(Codec& codec, const std::vector<int>& bytes) {
  Progress progress = Progress::more;
  for (const int byte : bytes) {
    REQUIRE(progress == Progress::more);
    progress = codec.feed(static_cast<std::uint8_t>(byte));
  }
  return progress;
}

Progress feed(Codec& codec, std::string_view text) {
  return feed(codec, std::vector<int>(text.begin(), text.end()));
}

TEST_CASE("force-torque codec: a line comes back, and the prompt ends the answer", "[force-torque]") {
  Codec codec;
  REQUIRE(as_text(codec.command("CD B")) == "CD B\r");
  REQUIRE(feed(codec, "CD B\r\r\n>") == Progress::done);
  REQUIRE_FALSE(codec.asking());
}

TEST_CASE("force-torque codec: a record of six big-endian words", "[force-torque]") {
  Codec codec;
  REQUIRE(as_text(codec.request_record()) == "\x14");
  SECTION("after the echo") {
    REQUIRE(feed(codec, {0x14, 0, 0, 20, 0xff, 0xec, 0xfe, 0x0c, 1, 0x4d, 0xfe, 0xb3, 0, 0}) ==
            Progress::done);
  }
  SECTION("of a sensor that echoes no control characters") {
    REQUIRE(feed(codec, {0, 0, 20, 0xff, 0xec, 0xfe, 0x0c, 1, 0x4d, 0xfe, 0xb3, 0, 0}) == Progress::done);
  }
  REQUIRE_FALSE(codec.record().overload);
  REQUIRE(codec.record().counts == std::array<int, 6>{20, -20, -500, 333, -333, 0});
  const auto values = codec.record().values();
  REQUIRE(values[0] == 1);
  REQUIRE(values[2] == -25);
  REQUIRE(values[3] == Approx(0.999).epsilon(1e-4));
}

TEST_CASE("force-torque codec: the overload byte is seen, and the counts end at the range",
          "[force-torque]") {
  Codec codec;
  codec.request_record();
  REQUIRE(feed(codec, {0x14, 1, 0, 0, 0, 0, 0xfa, 0xec, 0, 0, 0, 0, 0, 0}) == Progress::done);
  REQUIRE(codec.record().overload);
  REQUIRE(codec.record().values()[2] == -65);
}

TEST_CASE("force-torque codec: what is no answer is told", "[force-torque]") {
  Codec codec;
  SECTION("unasked") {
    REQUIRE(feed(codec, "x") == Progress::garbled);
    REQUIRE(codec.problem() == "sends \"x\" without being asked");
  }
  SECTION("a wrong echo") {
    codec.command("SB");
    REQUIRE(feed(codec, "SC") == Progress::garbled);
    REQUIRE(codec.problem() == "echoes \"C\" where \"B\" was sent");
  }
  SECTION("a refusal") {
    codec.command("CV 77");
    REQUIRE(feed(codec, "CV 77\r\n? CV 77\r\n>") == Progress::garbled);
    REQUIRE(codec.problem() == "refuses \"CV 77\": it says \"? CV 77\"");
  }
  SECTION("no overload byte") {
    codec.request_record();
    REQUIRE(feed(codec, {0x14, 0x80}) == Progress::garbled);
    REQUIRE(codec.problem() == "a record begins with the byte 80, which is no overload byte");
  }
  SECTION("more than the sensor has") {
    codec.request_record();
    REQUIRE(feed(codec, {0, 0x40, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}) == Progress::garbled);
    REQUIRE(codec.problem() == "a record says 16384 counts along fx, more than the sensor has");
  }
  REQUIRE_FALSE(codec.asking());
}

TEST_CASE("force-torque codec: says what is missing", "[force-torque]") {
  Codec codec;
  codec.request_record();
  REQUIRE(codec.missing() == "no record came");
  feed(codec, {0x14, 0, 0, 1, 0});
  REQUIRE(codec.missing() == "only 4 of the 13 bytes of a record came");
  codec.command("SB");
  feed(codec, "S");
  REQUIRE(codec.missing() == "only 1 of the 3 characters of \"SB\" came back");
  feed(codec, "B\r");
  REQUIRE(codec.missing() == "no prompt came after \"SB\"");
}

}  // namespace
}  // namespace pal::runtime::drivers::force_torque
