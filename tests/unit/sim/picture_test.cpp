#include "sim/picture/picture.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace {

// A machine without the renderer must get a reason and no crash; one with it a picture.
void expect_picture(Renderer renderer) {
  Workcell workcell(scene("touch"));
  const Joints before = workcell.joints();
  const Picture picture = take_picture(workcell, {.width = 320, .height = 240, .renderer = renderer});
  CHECK(workcell.joints() == before);
  if (!picture.image) {
    WARN("no picture here: " << picture.problem);
    CHECK_FALSE(picture.problem.empty());
    return;
  }
  REQUIRE(picture.image->pixels.size() == 3U * 320 * 240);
  std::set<std::array<unsigned char, 3>> colours;
  for (std::size_t i = 0; i + 2 < picture.image->pixels.size(); i += 3)
    colours.insert({picture.image->pixels[i], picture.image->pixels[i + 1], picture.image->pixels[i + 2]});
  CHECK(colours.size() > 500);  // shaded surfaces, not an empty picture
  // A bluish sky above: the picture is the right way up.
  CHECK(picture.image->pixels[2] > picture.image->pixels[0] + 5);
}

}  // namespace

// MuJoCo takes its OpenGL functions from the first renderer of the process; ctest runs each case in its own.
TEST_CASE("pictures are drawn without a screen by EGL, or there is a reason") {
  expect_picture(Renderer::egl);
}
TEST_CASE("pictures are drawn without a screen by OSMesa, or there is a reason") {
  expect_picture(Renderer::osmesa);
}
TEST_CASE("pictures are drawn by whatever there is, or there is a reason") {
  expect_picture(Renderer::automatic);
}

TEST_CASE("a PNG file begins and ends as it should") {
  const std::string bytes = encode_png({2, 1, {255, 0, 0, 0, 0, 255}});
  CHECK(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(bytes.substr(12, 12) == std::string("IHDR\0\0\0\2\0\0\0\1", 12));
  CHECK(bytes.substr(bytes.size() - 8, 4) == "IEND");
  CHECK_THROWS_AS(encode_png({0, 0, {}}), std::runtime_error);
}
