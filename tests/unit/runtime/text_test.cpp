// Texts as values, and as numbers of a payload.
#include "pal/runtime/text.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "pal/runtime/payload.hpp"

using pal::runtime::Text;

TEST_CASE("a text holds up to 100 characters of printable ASCII") {
  STATIC_REQUIRE(Text("park").view() == "park");
  CHECK(Text().view().empty());
  const std::string longest(Text::capacity, 'x');
  CHECK(longest.size() == 100);
  CHECK(Text(longest).view() == longest);
  CHECK(Text(" ~").view() == " ~");
  CHECK_THROWS_AS(Text(longest + "."), std::invalid_argument);
  CHECK_THROWS_AS(Text("a\tb"), std::invalid_argument);
  CHECK_THROWS_AS(Text("\x7f"), std::invalid_argument);
  CHECK_THROWS_AS(Text("caf\xc3\xa9"), std::invalid_argument);
  CHECK_THROWS_AS(Text(std::string_view("a\0b", 3)), std::invalid_argument);
}

TEST_CASE("texts compare by their characters") {
  CHECK(Text("park") == Text("park"));
  CHECK(Text("park") == "park");
  CHECK(Text("park") != "park ");
  CHECK(Text("park") < Text("parked"));
  CHECK(Text("") < Text(" "));
  CHECK(Text("part") > Text("parked"));
}

TEST_CASE("a text of any length is unpacked as it was packed") {
  std::string longest = "~The quick brown fox ";
  for (std::size_t i = longest.size(); i < Text::capacity; ++i) longest += static_cast<char>(' ' + i % 95);
  for (std::size_t length = 0; length <= Text::capacity; ++length) {
    const Text text(longest.substr(0, length));
    std::array<double, Text::slots> numbers{};
    numbers.fill(-1);
    text.pack(numbers);
    for (const double number : numbers) {
      CHECK(number >= 0);
      CHECK(number < std::ldexp(1.0, 48));
      CHECK(number == std::floor(number));
    }
    CHECK(Text::unpack(numbers) == text);
  }
  std::array<double, Text::slots> numbers{};
  Text(longest).pack(numbers);
  numbers.back() += std::ldexp(1.0, 40);  // a character behind the hundredth
  CHECK_FALSE(Text::unpack(numbers));
  Text("b a").pack(numbers);
  CHECK(numbers[0] == 'b' + 256.0 * ' ' + 65536.0 * 'a');
  CHECK(numbers[1] == 0);
}

TEST_CASE("values stand one after the other in a payload") {
  std::array<double, 6 + Text::slots> numbers{};
  pal::runtime::put(std::array<bool, 2>{true, false}, numbers, 0);
  pal::runtime::put(std::array<std::int64_t, 2>{-7, 9}, numbers, 2);
  pal::runtime::put(2.5, numbers, 4);
  pal::runtime::put(Text("home"), numbers, 5);
  pal::runtime::put(true, numbers, 5 + Text::slots);
  CHECK(numbers[0] == 1);
  CHECK(numbers[2] == -7);
  std::array<bool, 2> truths{};
  std::array<std::int64_t, 2> whole{};
  Text text;
  double real = 0;
  bool truth = false;
  pal::runtime::get(truths, numbers, 0);
  pal::runtime::get(whole, numbers, 2);
  pal::runtime::get(real, numbers, 4);
  pal::runtime::get(text, numbers, 5);
  pal::runtime::get(truth, numbers, 5 + Text::slots);
  CHECK(truths == std::array<bool, 2>{true, false});
  CHECK(whole == std::array<std::int64_t, 2>{-7, 9});
  CHECK(real == 2.5);
  CHECK(text == "home");
  CHECK(truth);
}
