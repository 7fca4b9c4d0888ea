#include "codegen/writer.hpp"

#include <catch2/catch.hpp>

using namespace pal::codegen;
using namespace std::chrono_literals;

TEST_CASE("times are written in the greatest unit in which they are whole") {
  CHECK(duration(0ns) == "0ns");
  CHECK(duration(28ms) == "28ms");
  CHECK(duration(5700us) == "5700us");
  CHECK(duration(2s) == "2s");
  CHECK(duration(1500ns) == "1500ns");
  CHECK(interval({100us, 200us}) == "{100us, 200us}");
}

TEST_CASE("numbers read back as themselves") {
  using pal::pan::ScalarType;
  CHECK(number(20, ScalarType::real) == "20");
  CHECK(number(0.1, ScalarType::real) == "0.1");
  CHECK(number(1.0 / 3, ScalarType::real) == "0.3333333333333333");
  CHECK(number(1, ScalarType::boolean) == "true");
}

TEST_CASE("long lists and conditions are broken between their parts") {
  const std::string item(50, 'x');
  const std::string term(48, 'x');
  Writer out;
  out.indent().list("f(", {item, item, "y"}, ");");
  out.condition("if (", term + " && " + term + " || z", ") break;");
  out.list("g(", {}, ");");
  CHECK(out.take() == "  f(" + item + ", " + item + ",\n" +
                          "      y);\n"
                          "  if (" +
                          term + " && " + term + " ||\n" +
                          "      z) break;\n"
                          "  g();\n");
}
