#include "codegen/names.hpp"

#include <catch2/catch.hpp>

using namespace pal::codegen;

TEST_CASE("names of PAL become identifiers") {
  CHECK(snake_case("pc-force") == "pc_force");
  CHECK(snake_case("request wrench") == "request_wrench");
  CHECK(snake_case("SM1.2") == "sm1_2");
  CHECK(snake_case("class") == "pal_class");
  CHECK(snake_case("AND") == "pal_and");
  // Macros of gnu++20.
  CHECK(snake_case("unix") == "pal_unix");
  CHECK(snake_case("Linux") == "pal_linux");
  CHECK(snake_case("3-way") == "pal_3_way");
  CHECK(snake_case("a--b-") == "a_b");
  CHECK(snake_words("class") == "class");
  CHECK(camel_case("range-profile") == "RangeProfile");
  CHECK(camel_case("SM1") == "SM1");
  CHECK(camel_case("3-way") == "N3Way");
}

TEST_CASE("a scope gives each identifier once") {
  Scope scope({"start"});
  CHECK(scope.unique("start") == "start2");
  CHECK(scope.unique("go") == "go");
  CHECK(scope.unique("go") == "go2");
  CHECK(scope.unique("go") == "go3");
  CHECK(scope.unique("sm1") == "sm1");
  CHECK(scope.unique("sm1") == "sm1_2");
}

TEST_CASE("texts become literals") {
  CHECK(literal("a \"b\" \\") == "\"a \\\"b\\\" \\\\\"");
  CHECK(literal("a\nb") == "\"a\\nb\"");
}
