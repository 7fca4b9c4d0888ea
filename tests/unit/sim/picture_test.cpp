#include "sim/picture/picture.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "sim/picture/offscreen.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace {

// MuJoCo takes its OpenGL functions from the first renderer of the process; ctest runs each case in its own.
std::string drawn_before;

// A machine without the renderer must get a reason, with what is missing, and no crash; one with it a
// picture.
void expect_picture(Renderer renderer, const std::string& by) {
  if (!drawn_before.empty() && drawn_before != by) return;
  Workcell workcell(scene("touch"));
  const Joints before = workcell.joints();
  const Picture picture = take_picture(workcell, {.width = 320, .height = 240, .renderer = renderer});
  CHECK(workcell.joints() == before);
  if (!picture.image) {
    WARN("no picture here: " << picture.problem);
    CHECK_FALSE(picture.problem.empty());
    CHECK_FALSE(picture.packages.empty());
    return;
  }
  CHECK(picture.renderer == by);
  drawn_before = by;
  CHECK(picture.packages.empty());
  REQUIRE(picture.image->pixels.size() == 3U * 320 * 240);
  std::set<std::array<unsigned char, 3>> colours;
  for (std::size_t i = 0; i + 2 < picture.image->pixels.size(); i += 3)
    colours.insert({picture.image->pixels[i], picture.image->pixels[i + 1], picture.image->pixels[i + 2]});
  CHECK(colours.size() > 500);  // shaded surfaces, not an empty picture
  // A bluish sky above: the picture is the right way up.
  CHECK(picture.image->pixels[2] > picture.image->pixels[0] + 5);
}

// EGL is installed and finds nothing to draw with.
struct BlindEgl {
  BlindEgl() { setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1); }
  ~BlindEgl() { unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES"); }
  BlindEgl(const BlindEgl&) = delete;
  BlindEgl& operator=(const BlindEgl&) = delete;
};

}  // namespace

TEST_CASE("pictures are drawn without a screen by EGL, or something is not installed") {
  expect_picture(Renderer::egl, "EGL");
}
TEST_CASE("pictures are drawn without a screen by OSMesa, or something is not installed") {
  expect_picture(Renderer::osmesa, "OSMesa");
}
TEST_CASE("pictures are drawn by whatever there is, or something is not installed") {
  expect_picture(Renderer::automatic, "EGL");
}

TEST_CASE("pictures are drawn by OSMesa where EGL is there and fails, or something is not installed") {
  const BlindEgl blind;
  expect_picture(Renderer::automatic, "OSMesa");
}

TEST_CASE("a picture that fails says why, and names packages only where something is not installed") {
  const BlindEgl blind;
  if (!drawn_before.empty()) return;
  Workcell workcell(scene("touch"));
  const Picture picture = take_picture(workcell, {.width = 320, .height = 240, .renderer = Renderer::egl});
  CHECK_FALSE(picture.image);
  CHECK_THAT(picture.problem, Catch::StartsWith("EGL: "));
  if (std::filesystem::exists("/usr/lib/x86_64-linux-gnu/dri/swrast_dri.so")) {
    CHECK_THAT(picture.problem, Catch::StartsWith("EGL: it has no surfaceless display (EGL_"));
    CHECK(picture.packages.empty());
  }
}

TEST_CASE("a library that is not there names its package, one that is broken does not") {
  try {
    const Library library("libnone-of-this-name.so.1", "libnone1");
    FAIL("it is not there");
  } catch (const NoOffscreen& problem) {
    CHECK_THAT(problem.what(), Catch::Contains("libnone-of-this-name.so.1"));
    CHECK(problem.packages() == "libnone1");
  }
  const std::filesystem::path broken =
      std::filesystem::temp_directory_path() / ("broken-" + std::to_string(getpid()) + ".so");
  std::ofstream(broken) << "no library";
  try {
    const Library library(broken.c_str(), "libnone1");
    FAIL("it is no library");
  } catch (const NoOffscreen& problem) {
    CHECK_THAT(problem.what(), Catch::Contains(broken.string()));
    CHECK(problem.packages().empty());
  }
  std::filesystem::remove(broken);
}

TEST_CASE("a PNG file begins and ends as it should") {
  const std::string bytes = encode_png({2, 1, {255, 0, 0, 0, 0, 255}});
  CHECK(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(bytes.substr(12, 12) == std::string("IHDR\0\0\0\2\0\0\0\1", 12));
  CHECK(bytes.substr(bytes.size() - 8, 4) == "IEND");
  CHECK_THROWS_AS(encode_png({0, 0, {}}), std::runtime_error);
}
