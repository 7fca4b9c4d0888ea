#include "pal/units/conversion.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <random>
#include <string>

using namespace pal::units;

namespace {

struct Row {
  const char* decimal;
  Ratio factor;
  double expected;
};

}  // namespace

// Random figures; the expected ones are fractions of whole numbers of any size, rounded once, by Python's
// integers.
TEST_CASE("numbers convert to the nearest double") {
  const Row rows[] = {
      {"80", {1000, 1}, 0x1.3880000000000p+16},
      {"77.596", {1000, 1}, 0x1.2f1c000000000p+16},
      {"0.14788237585620156", {1000, 1}, 0x1.27c3c6c4aa54dp+7},
      {"91.635", {1000, 1}, 0x1.65f3000000000p+16},
      {"61.745", {50, 3}, 0x1.0145555555555p+10},
      {"28.931", {50, 3}, 0x1.e22eeeeeeeeefp+8},
      {"-0.27762013055523171", {50, 3}, -0x1.2820cdbc065e6p+2},
      {"0.19195790108940369", {50, 3}, 0x1.99829bbee5f4ap+1},
      {"40", {127, 5}, 0x1.fc00000000000p+9},
      {"33", {127, 5}, 0x1.a31999999999ap+9},
      {"71", {127, 5}, 0x1.c2d999999999ap+10},
      {"137221358387936897e-24", {127, 5}, 0x1.d3ce348efd8edp-19},
      {"1e-180", {5, 127}, 0x1.4e933aa4d8a0ep-603},
      {"78.099", {5, 127}, 0x1.8991dc09ff842p+1},
      {"44", {5, 127}, 0x1.bb76eddbb76eep+0},
      {"-0.38765786323729512", {5, 127}, -0x1.f41bf26c0d1fdp-7},
      {"62", {6, 1}, 0x1.7400000000000p+8},
      {"74.056", {6, 1}, 0x1.bc5604189374cp+8},
      {"97.905", {6, 1}, 0x1.25b70a3d70a3dp+9},
      {"56.405", {6, 1}, 0x1.526e147ae147bp+8},
      {"1e174", {1, 6}, 0x1.59047f4373629p+575},
      {"794177345328512246e-23", {1, 6}, 0x1.634f1604d0087p-20},
      {"29.102", {1, 6}, 0x1.366bdc805761ap+2},
      {"1e-12", {1, 6}, 0x1.774ccac3d3817p-43},
      {"1e74", {8896443230521, 1290320000000}, 0x1.863abc28c9007p+248},
      {"812198122170038601e-21", {8896443230521, 1290320000000}, 0x1.6efee1b2fc659p-8},
      {"1e-108", {8896443230521, 1290320000000}, 0x1.0315045968ad3p-356},
      {"0.54743403569895444", {8896443230521, 1290320000000}, 0x1.e3205a286ebecp+1},
      {"315757123693639060e-20", {1290320000000, 8896443230521}, 0x1.e03693d768ac2p-12},
      {"-0.65505396023524942", {1290320000000, 8896443230521}, -0x1.8526a186e4fecp-4},
      {"0.96040964374203397", {1290320000000, 8896443230521}, 0x1.1d470897b3288p-3},
      {"198102756977310729e-19", {1290320000000, 8896443230521}, 0x1.7899dacd60d01p-9},
      {"62.374", {8896443230521, 2000000000000}, 0x1.15741062cfc87p+8},
      {"21", {8896443230521, 2000000000000}, 0x1.75a68ebfd3f2bp+6},
      {"97.976", {8896443230521, 2000000000000}, 0x1.b3d1a76d33e57p+8},
      {"1e-217", {8896443230521, 2000000000000}, 0x1.3a0bc68bcd4e8p-719},
      {"404122488019831628e-12", {196133, 20000}, 0x1.e3c67e608ac50p+21},
      {"15", {196133, 20000}, 0x1.2633126e978d5p+7},
      {"338027152894434736e-11", {196133, 20000}, 0x1.f9d0d3ca11032p+24},
      {"1e-130", {196133, 20000}, 0x1.5c0a29859f621p-429},
      {"0.91442518232997316", {5, 18}, 0x1.041a68e37ee1fp-2},
      {"1e43", {5, 18}, 0x1.fe327bc1b896ap+140},
      {"336070374008562067e-15", {5, 18}, 0x1.756959cfefa00p+6},
      {"346801905942497985e-15", {5, 18}, 0x1.8155e01ead380p+6},
      {"3", {1, 100}, 0x1.eb851eb851eb8p-6},
      {"46089767758646801e-25", {1, 100}, 0x1.9568ee32156ffp-35},
      {"901477671411271841e-1", {1, 100}, 0x1.99f1d0304f23fp+49},
      {"1e196", {1, 100}, 0x1.5eb082cca94d7p+644},
      {"0.76131958877255368", {1, 60000}, 0x1.a9c2c202a329fp-17},
      {"843103799466559875e-16", {1, 60000}, 0x1.705b904e3cc53p-10},
      {"0.49003436882254414", {1, 60000}, 0x1.120c0d8d0ee79p-17},
      {"71", {1, 60000}, 0x1.363427de23c59p-10},
  };
  for (const auto& row : rows) {
    CAPTURE(row.decimal, row.factor.over, row.factor.under);
    CHECK(converted(row.decimal, row.factor) == row.expected);
  }
}

TEST_CASE("a number between two doubles is rounded to the even one") {
  // 2^53 + 1 lies between 2^53 and 2^53 + 2.
  CHECK(converted("9007199254740993", {1, 1}) == 9007199254740992.0);
  CHECK(converted("9007199254740993.0000000000000000000000000000000000001", {1, 1}) == 9007199254740994.0);
  CHECK(converted("27021597764222979", {1, 3}) == 9007199254740992.0);
  CHECK(converted("27021597764222979.00000000000000000000000000001", {1, 3}) == 9007199254740994.0);
}

TEST_CASE("a unit there and back is the same number") {
  std::mt19937_64 dice(11);
  for (int i = 0; i < 20'000; ++i) {
    const auto whole = static_cast<std::int64_t>(dice() % 1'000'000'000) - 500'000'000;
    const auto over = static_cast<std::int64_t>(dice() % 1'000'000) + 1;
    const auto under = static_cast<std::int64_t>(dice() % 1'000'000) + 1;
    const auto there = converted(std::to_string(whole * under), {over, under});
    REQUIRE(there == static_cast<double>(whole * over));
    const auto back = converted(std::to_string(whole * over), {under, over});
    REQUIRE(back == static_cast<double>(whole * under));
  }
}

TEST_CASE("units that do not convert are reported") {
  CHECK_FALSE(converted("", {2, 1}));
  CHECK_FALSE(converted("-", {2, 1}));
  CHECK_FALSE(converted("1x", {2, 1}));
  CHECK_FALSE(converted("1e", {2, 1}));
  CHECK_FALSE(converted("1e308", {1000, 1}));
  CHECK_FALSE(converted("1", {INT64_MAX, 1}));
  CHECK(converted("1e-320", {1, 1'000'000}) == 0.0);
  CHECK(converted("0", {1, 3}) == 0.0);
}
