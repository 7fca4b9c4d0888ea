#include "sim/scene.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace fs = std::filesystem;

namespace {

// A folder of scenes that lives as long as the test.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("pal-scenes-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
    for (const char* part : {"puma560.xml", "cell.xml"})
      fs::copy_file(fs::path(PAL_SCENE_DIR) / part, path_ / part);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  Scene add(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / (name + ".xml")) << text;
    return {name, path_ / (name + ".xml")};
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

SceneError refused(const Scene& scene) {
  try {
    Workcell workcell(scene);
  } catch (const SceneError& error) {
    return error;
  }
  FAIL("the scene was taken");
  return {"", "", ""};
}

const std::string start = R"(<custom><numeric name="start" data="0.46 -0.20 -0.15 0"/></custom>)";
const std::string parts = R"(<include file="puma560.xml"/>)";

}  // namespace

TEST_CASE("the project's scenes are found by name and listed") {
  const std::vector<Scene> scenes = list_scenes({PAL_SCENE_DIR});
  std::vector<std::string> names;
  for (const Scene& scene : scenes) names.push_back(scene.name);
  CHECK(std::is_sorted(names.begin(), names.end()));
  for (const char* name : {"nothing", "touch", "sponge", "pallet"})
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  // What scenes in MJCF include is no scene.
  CHECK(std::count(names.begin(), names.end(), "puma560") == 0);
  const Scene touch = find_scene("touch", {PAL_SCENE_DIR});
  CHECK(find_scene(touch.file.string(), {}).name == "touch");
}

TEST_CASE("a scene that does not exist: place, cause, hint") {
  try {
    find_scene("tuch", {PAL_SCENE_DIR});
    FAIL("found");
  } catch (const SceneError& error) {
    CHECK(error.place() == "scene 'tuch'");
    CHECK(error.cause() == "there is no scene of this name");
    CHECK(error.hint().find("there are bar-under-forearm, ") == 0);
    CHECK(error.hint().find(", touch, ") != std::string::npos);
  }
  CHECK_THROWS_AS(find_scene("somewhere/else.xml", {}), SceneError);
}

TEST_CASE("scenes that do not load: place, cause, hint") {
  const Folder folder;

  const SceneError element =
      refused(folder.add("element", "<mujoco>\n  " + parts + "\n  <gem/>\n</mujoco>\n"));
  CHECK(element.place() == (folder.path() / "element.xml").string() + ":3");
  CHECK(element.cause() ==
        "MuJoCo does not load the scene: Schema violation: unrecognized element Element 'gem'");
  CHECK_FALSE(element.hint().empty());

  const SceneError broken = refused(folder.add("broken", "<mujoco>\n  <worldbody>\n</mujoco>\n"));
  CAPTURE(broken.what());
  CHECK(broken.place() == (folder.path() / "broken.xml").string() + ":2");
  CHECK_FALSE(broken.cause().empty());

  const SceneError armless = refused(folder.add("armless", "<mujoco><worldbody/></mujoco>"));
  CHECK(armless.cause() == "the scene has no joint 'joint1'");
  CHECK(armless.hint() == "include puma560.xml, which has it");

  const SceneError startless = refused(folder.add("startless", "<mujoco>" + parts + "</mujoco>"));
  CHECK(startless.cause() == "the scene does not say where the tool starts");

  const SceneError figures = refused(folder.add(
      "figures", "<mujoco>" + parts + R"(<custom><numeric name="start" data="1 2"/></custom></mujoco>)"));
  CHECK(figures.cause() == "the tool's start has 2 figures instead of 4");

  const SceneError words = refused(
      folder.add("words", "<mujoco>" + parts + R"(<custom><numeric name="start" data="0.46 -0.2 -0.15 0"/>)" +
                              R"(<text name="configuration" data="sideways"/></custom></mujoco>)"));
  CHECK(words.cause() == "'sideways' is not a configuration of the arm");

  const SceneError far = refused(folder.add(
      "far", "<mujoco>" + parts + R"(<custom><numeric name="start" data="2 0 0 0"/></custom></mujoco>)"));
  CHECK(far.cause().find("the arm cannot bring the tool to its start") == 0);

  const SceneError inside = refused(folder.add(
      "inside",
      "<mujoco>" + parts + start +
          R"(<worldbody><geom type="box" size=".1 .1 .1" pos="0.46 -0.2 0.45" contype="2" conaffinity="1"/>)" +
          "</worldbody></mujoco>"));
  CHECK(inside.cause() == "at its start the tool touches something that has no name in the scene");

  const SceneError missing = refused({"missing", folder.path() / "missing.xml"});
  CHECK(missing.cause() == "the file cannot be read");
}
