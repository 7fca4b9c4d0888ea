#include <catch2/catch.hpp>

#include "pal/support/duration_text.hpp"

using namespace pal;
using namespace std::chrono_literals;

TEST_CASE("times are exact") {
  const auto time = [](const char* number, const char* unit) {
    return std::get<Duration>(parse_duration(number, unit));
  };
  CHECK(time("28", "ms") == 28ms);
  CHECK(time("0.1", "ms") == 100us);
  CHECK(time("0.000000001", "s") == 1ns);
  CHECK(time("1e3", "us") == 1ms);
  CHECK(time("2.50e-1", "s") == 250ms);
  CHECK(time("000.0", "ns") == 0ns);
  CHECK(time("-3", "ms") == -3ms);
  CHECK(time("2", "min") == 120s);
  CHECK(time("9223372036854775807", "ns").count() == 9223372036854775807);
  CHECK(time("9223372036.854775807", "s").count() == 9223372036854775807);
}

TEST_CASE("a text that is not a time is refused") {
  const auto error = [](const char* number, const char* unit) {
    return std::get<DurationError>(parse_duration(number, unit));
  };
  CHECK(error("1", "hour") == DurationError::no_unit);
  CHECK(error("1", "MS") == DurationError::no_unit);
  CHECK(error("x", "ms") == DurationError::no_number);
  CHECK(error("0.5", "ns") == DurationError::not_whole);
  CHECK(error("1e-7", "ms") == DurationError::not_whole);
  CHECK(error("0.33333333333333333333333333333333", "s") == DurationError::not_whole);
  CHECK(error("9223372036854775808", "ns") == DurationError::overflow);
  CHECK(error("1e19", "ns") == DurationError::overflow);
  CHECK(error("1e999999999999999999999", "ns") == DurationError::overflow);
  CHECK(error("1e-999999999999999999999", "s") == DurationError::not_whole);
}

TEST_CASE("a percentage is exactly so much of a second") {
  const auto part = [](const char* number) { return std::get<Duration>(parse_percentage(number)); };
  CHECK(part("50") == 500ms);
  CHECK(part("66.6666667") == 666'666'667ns);
  CHECK(part("1e-7") == 1ns);
  CHECK(part("1e2") == 1s);
  const auto error = [](const char* number) { return std::get<DurationError>(parse_percentage(number)); };
  CHECK(error("49.99999999995") == DurationError::not_whole);
  CHECK(error("1e-10") == DurationError::not_whole);
  CHECK(error("100.000000000000000000000001") == DurationError::not_whole);
  CHECK(error("1e999") == DurationError::overflow);
}

TEST_CASE("times are written so that they are read back") {
  CHECK(to_text(28ms) == "28 ms");
  CHECK(to_text(Duration{0}) == "0 ms");
  CHECK(to_text(1500us) == "1.5 ms");
  CHECK(to_text(Duration{1}) == "1 ns");
  CHECK(to_text(Duration{1000000001}) == "1.000000001 s");
  CHECK(to_text(Interval{100us, 6ms}) == "0.1 TO 6 ms");
  CHECK(to_text(Interval{6ms, 6ms}) == "6 ms");
  for (const std::int64_t count : {1LL, 999LL, 1000LL, 123456789LL, 60000000001LL, 9223372036854775807LL}) {
    const auto text = to_text(Duration{count});
    const auto space = text.find(' ');
    CHECK(std::get<Duration>(parse_duration(text.substr(0, space), text.substr(space + 1))).count() == count);
  }
}
