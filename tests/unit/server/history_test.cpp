// The last events in a room that never grows: limits of number and of bytes, texts over the end of the room.
#include "server/history.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

namespace {

using pal::server::History;

using Told = std::vector<std::pair<std::uint64_t, std::string>>;

Told all(const History& history, std::uint64_t since = 0) {
  Told result;
  history.since(since,
                [&](std::uint64_t number, const std::string& told) { result.emplace_back(number, told); });
  return result;
}

/// The lengths differ, so that texts lie anywhere over the end of the room.
std::string text_of(std::uint64_t number) {
  return std::string(number % 7, 'x') + std::to_string(number);
}

}  // namespace

TEST_CASE("an empty history of events knows none") {
  const History history;
  CHECK(history.first() == 0);
  CHECK(history.count() == 0);
  CHECK(all(history).empty());
}

TEST_CASE("the last events are kept, by number") {
  History history(3);
  for (std::uint64_t number = 1; number <= 10; ++number) history.add(number, text_of(number));
  CHECK(history.first() == 8);
  CHECK(all(history) == Told{{8, "x8"}, {9, "xx9"}, {10, "xxx10"}});
  CHECK(all(history, 9) == Told{{10, "xxx10"}});
  CHECK(all(history, 10).empty());
}

TEST_CASE("the last events are kept as far as they fit, whatever their lengths") {
  for (const std::size_t bytes : {20U, 21U, 37U, 64U, 101U}) {
    History history(1000, bytes);
    for (std::uint64_t number = 1; number <= 300; ++number) {
      history.add(number, text_of(number));
      // As many as fit, each with the four bytes of its length.
      Told expected;
      std::size_t used = 0;
      for (std::uint64_t each = number; each > 0; --each) {
        used += 4 + text_of(each).size();
        if (used > bytes) break;
        expected.insert(expected.begin(), {each, text_of(each)});
      }
      REQUIRE(all(history) == expected);
      REQUIRE(history.first() == number + 1 - expected.size());
    }
  }
}

TEST_CASE("an event longer than all the room is not kept, and none before it") {
  History history(1000, 64);
  history.add(1, "one");
  history.add(2, std::string(61, 'x'));
  CHECK(history.first() == 3);
  CHECK(all(history).empty());
  history.add(3, std::string(60, 'y'));
  CHECK(history.first() == 3);
  CHECK(all(history) == Told{{3, std::string(60, 'y')}});
}
