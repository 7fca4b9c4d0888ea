// The protocol of the range finder, byte by byte.
#include <catch2/catch.hpp>
#include <string>

#include "runtime/drivers/range_finder/codec.hpp"

namespace pal::runtime::drivers::range_finder {
namespace {

using Event = Codec::Event;

/// The last event that is not none.
Event feed(Codec& codec, std::string_view text) {
  Event last = Event::none;
  for (const char c : text) {
    const Event event = codec.feed(static_cast<std::uint8_t>(c));
    if (event == Event::garbled) return event;
    if (event != Event::none) last = event;
  }
  return last;
}

/// Point 0 is invalid, the others lie on a line.
std::string points_of_a_profile() {
  std::string text = "----- -----\r\n";
  for (int i = 1; i < 255; ++i) text += std::to_string(11000 - i) + " 0" + std::to_string(2000 + i) + "\r\n";
  return text;
}

TEST_CASE("range finder codec: a start, then a profile", "[range-finder]") {
  Codec codec;
  REQUIRE(feed(codec, "10010 020\r\n\r\nREADY 255 0000312345\r\n") == Event::ready);
  REQUIRE(codec.ready_at() == 312345);
  REQUIRE(feed(codec, "PROFILE 02 0000400000\r\n") == Event::began);
  REQUIRE(codec.answers() == 2);
  REQUIRE(feed(codec, points_of_a_profile()) == Event::none);
  Checksum sum;
  sum.add("PROFILE 02 0000400000");
  for (const char c : points_of_a_profile()) {
    if (c != '\r' && c != '\n') sum.add({&c, 1});
  }
  char end[16];
  std::snprintf(end, sizeof end, "END %04x\r\n", sum.value());
  REQUIRE(feed(codec, end) == Event::profile);
  const Profile& profile = codec.profile();
  CHECK(profile.began == 400000);
  CHECK_FALSE(profile.valid[0]);
  CHECK(profile.x[0] == 0);
  CHECK(profile.z[0] == 0);
  CHECK(profile.valid[1]);
  CHECK(profile.x[1] == Approx(99.9));
  CHECK(profile.z[254] == Approx(225.4));
}

TEST_CASE("range finder codec: the check sum is Fletcher's", "[range-finder]") {
  // Worked by hand: 'a' = 97, 'b' = 98: sums 97, 195; 97, 292 - 255 = 37.
  Checksum sum;
  sum.add("ab");
  CHECK(sum.value() == (37U << 8 | 195U));
}

TEST_CASE("range finder codec: what is no profile is told", "[range-finder]") {
  Codec codec;
  feed(codec, "READY 255 0000000000\r\n");
  std::string expected;
  SECTION("a refusal") {
    REQUIRE(feed(codec, "? PROFILE\r\n") == Event::garbled);
    expected = "sends \"? PROFILE\" where a profile should begin";
  }
  SECTION("a broken point") {
    REQUIRE(feed(codec, "PROFILE 01 0000000000\r\n10000 0200\r\n") == Event::garbled);
    expected = "sends \"10000 0200\" as point 0 of a profile";
  }
  SECTION("one point too few") {
    REQUIRE(feed(codec, "PROFILE 01 0000000000\r\n10000 02000\r\nEND 0000\r\n") == Event::garbled);
    expected = "sends \"END 0000\" as point 1 of a profile";
  }
  SECTION("a wrong check sum") {
    REQUIRE(feed(codec, "PROFILE 01 0000000000\r\n" + points_of_a_profile() + "END 0000\r\n") ==
            Event::garbled);
    expected = "sends a profile whose check sum is wrong";
  }
  SECTION("no lines at all") {
    REQUIRE(feed(codec, std::string(50, 'x')) == Event::garbled);
    expected = "sends a line without end: \"" + std::string(40, 'x') + '"';
  }
  CHECK(codec.problem() == expected);
}

TEST_CASE("range finder codec: says what is missing", "[range-finder]") {
  Codec codec;
  feed(codec, "READY 255 0000000000\r\n");
  CHECK(codec.missing().empty());
  feed(codec, "PROFILE 01 0000000000\r\n10000 02000\r\n10000 02000\r\n");
  CHECK(codec.missing() == "only 2 of the 255 points of a profile came");
}

}  // namespace
}  // namespace pal::runtime::drivers::range_finder
