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

  const SceneError armless = refused(folder.add("armless", "<mujoco><worldbody/></mujoco>"));
  CHECK(armless.cause() == "the scene has no joint 'joint1'");
  CHECK(armless.hint() == "include puma560.xml, which has it");

  const SceneError startless = refused(folder.add("startless", "<mujoco>" + parts + "</mujoco>"));
  CHECK(startless.cause() == "the scene does not say where the tool starts");

  const SceneError figures = refused(folder.add(
      "figures", "<mujoco>" + parts + R"(<custom><numeric name="start" data="1 2"/></custom></mujoco>)"));
  CHECK(figures.cause() == "the tool's start has 2 figures instead of 4");
  CHECK(figures.place() == (folder.path() / "figures.xml").string() + ":1");

  const SceneError words = refused(
      folder.add("words", "<mujoco>" + parts + R"(<custom><numeric name="start" data="0.46 -0.2 -0.15 0"/>)" +
                              R"(<text name="configuration" data="sideways"/></custom></mujoco>)"));
  CHECK(words.cause() == "'sideways' is not a configuration of the arm");

  const SceneError far = refused(folder.add(
      "far", "<mujoco>" + parts + R"(<custom><numeric name="start" data="2 0 0 0"/></custom></mujoco>)"));
  CHECK(far.cause().find("the arm cannot bring the tool to its start") == 0);

  const SceneError inside = refused(folder.add(
      "inside",
      "<mujoco>" + parts + "\n" + start +
          R"(<worldbody><geom type="box" size=".1 .1 .1" pos="0.46 -0.2 0.45" contype="2" conaffinity="1"/>)" +
          "</worldbody></mujoco>"));
  CHECK(inside.cause() == "at its start the tool touches something that has no name in the scene");
  CHECK(inside.place() == (folder.path() / "inside.xml").string() + ":2");

  const SceneError missing = refused({"missing", folder.path() / "missing.xml"});
  CHECK(missing.cause() == "the file cannot be read");
}

TEST_CASE("a wrong scene in MJCF: its file and its line, in plain words") {
  const Folder folder;
  struct Case {
    const char* inside;  // from the third line of the scene on
    int line;
    const char* cause;
  };
  for (const auto& [inside, line, cause] : {
           Case{"<gem/>", 3, "a <mujoco> has no <gem>"},
           Case{"<worldbody><geom kind=\"box\"/></worldbody>", 3, "a <geom> has no attribute 'kind'"},
           Case{"<worldbody>\n<body>\n</worldbody>", 4, "the element <body> is not closed"},
           Case{"<worldbody>\n<geom size=\".1\" material=\"gold\"/></worldbody>", 4,
                "there is no material 'gold', which this geom names"},
           Case{"<worldbody>\n\n<geom type=\"box\" size=\".1 a .1\"/></worldbody>", 5,
                "'size' is not a number"},
           Case{"<worldbody>\n<geom type=\"box\"/></worldbody>", 4, "a size is missing or not above 0"},
           Case{"<worldbody>\n<geom type=\"bax\" size=\"1\"/></worldbody>", 4,
                "'bax' is not a word that may stand here"},
           Case{"<worldbody>\n<body name=\"link3\"/></worldbody>", 4,
                "there is more than one body named 'link3'"},
           Case{"<worldbody><body>\n<freejoint/></body></worldbody>", 3, "a body that moves has no mass"},
           Case{"<asset>\n<mesh name=\"a\" file=\"a.stl\"/></asset>", 4, "the file "},
           Case{"\n<include file=\"more.xml\"/>", 4, "the file "},
           Case{"<compiler angle=\"degree\"/>", 3, "the scene changes how the arm is read: angle"},
           Case{"<default>\n<geom friction=\"0\"/></default>", 4,
                "the scene changes the arm: its default of <geom>"},
           Case{"<default><default class=\"arm\"/></default>", 3,
                "the scene changes the machine's class 'arm'"},
       }) {
    const SceneError error =
        refused(folder.add("wrong", "<mujoco>\n" + parts + "\n" + inside + "\n" + start + "\n</mujoco>\n"));
    CAPTURE(inside, error.what());
    CHECK(error.place() == (folder.path() / "wrong.xml").string() + ":" + std::to_string(line));
    CHECK(error.cause().find(cause) == 0);
    CHECK_FALSE(error.hint().empty());
    CHECK(std::string(error.what()).find("XML_ERROR") == std::string::npos);
  }
}

TEST_CASE("a scene in MJCF that changes the physics is refused, wherever it says so") {
  const Folder folder;
  for (const char* option : {R"(gravity="0 0 -1")", R"(integrator="Euler")", R"(timestep="0.002")",
                             R"(iterations="3")", R"(density="1.2")"})
    for (const bool before : {false, true}) {
      const std::string line = std::string("<option ") + option + "/>\n";
      const SceneError error = refused(folder.add(
          "other", "<mujoco>\n" + (before ? line + parts : parts + "\n" + line) + start + "</mujoco>\n"));
      CAPTURE(option, before, error.what());
      CHECK(error.place() == (folder.path() / "other.xml").string() + (before ? ":2" : ":3"));
      CHECK(error.cause().find("the scene changes the physics: ") == 0);
    }
  // In a file that the scene includes, too.
  folder.add("weightless", "<mujoco>\n\n<option gravity=\"0 0 0\"/></mujoco>");
  const SceneError error = refused(
      folder.add("using", "<mujoco><include file=\"weightless.xml\"/>" + parts + start + "</mujoco>"));
  CHECK(error.place() == (folder.path() / "weightless.xml").string() + ":3");
  // And a changed copy of the machine is not taken for it.
  folder.add("puma560", "<mujoco/>");
  CHECK(refused(folder.add("copied", "<mujoco>" + parts + start + "</mujoco>"))
            .cause()
            .find("is not the machine's own") != std::string::npos);
}

TEST_CASE("a scene in MJCF that acts on the arm is refused, wherever it includes the arm") {
  const Folder folder;
  const std::string body =
      R"(<worldbody><body name="mine"><joint name="hinge"/><geom size="0.01" mass="1"/><site name="dot"/></body></worldbody>)";
  const auto told = [&](const std::string& section, bool before) {
    const std::string head = section + "\n" + body;
    return refused(folder.add(
        "acting", "<mujoco>\n" + (before ? head + parts : parts + "\n" + head) + start + "</mujoco>\n"));
  };
  for (const bool before : {false, true}) {
    for (const auto& [section, cause] : std::vector<std::pair<std::string, std::string>>{
             {R"(<actuator><motor joint="joint2" gear="100"/></actuator>)",
              "<motor> acts on its joint 'joint2'"},
             {R"(<actuator><general site="tip"/></actuator>)", "<general> acts on its site 'tip'"},
             {R"(<equality><weld body1="mine" body2="pad"/></equality>)", "<weld> acts on its body 'pad'"},
             {R"(<equality><joint joint1="hinge" joint2="joint6"/></equality>)",
              "<joint> acts on its joint 'joint6'"},
             {R"(<tendon><fixed><joint joint="joint1" coef="1"/></fixed></tendon>)",
              "<joint> acts on its joint 'joint1'"},
             {R"(<tendon><spatial><site site="dot"/><site site="wrist"/></spatial></tendon>)",
              "<site> acts on its site 'wrist'"},
             {R"(<contact><exclude body1="mine" body2="link3"/></contact>)",
              "<exclude> acts on its body 'link3'"},
             {R"(<contact><pair geom1="tip" geom2="floor"/></contact>)", "<pair> acts on its geom 'tip'"}}) {
      const SceneError error = told(section, before);
      CAPTURE(section, before);
      CHECK(error.cause() == "the scene changes the arm: " + cause);
      CHECK(error.place() == (folder.path() / "acting.xml").string() + (before ? ":2" : ":3"));
      CHECK_FALSE(error.hint().empty());
    }
  }
  // The class of all that names none has a name, too.
  CHECK(told(R"(<default class="main"><geom friction="0 0 0"/></default>)", false).cause() ==
        "the scene changes the machine's class 'main'");
  CHECK(told(R"(<default class="mine"><geom friction="0 0 0"/></default>)", false).cause() ==
        "the class 'mine' stands in no <default>");
  CHECK(told(R"(<statistic meaninertia="100"/>)", false).cause() ==
        "the scene changes the physics: meaninertia");
  CHECK(told(R"(<worldbody><body name="finger left"/></worldbody>)", false).cause() ==
        "'finger left' is the name of a part of a tool");
}

TEST_CASE("a scene in MJCF may act on what it adds") {
  const Folder folder;
  const Scene scene =
      folder.add("own", "<mujoco>" + parts + start +
                            R"(<default><default class="mine"><geom rgba="1 0 0 1"/></default></default>
                 <worldbody><body name="one" pos="-1 0 1"><joint name="hinge"/><geom class="mine" size="0.01" mass="1"/></body>
                 <body name="other" pos="-1 0 1"><joint name="other"/><geom size="0.01" mass="1"/></body></worldbody>
                 <actuator><motor joint="hinge"/></actuator>
                 <equality><joint joint1="hinge" joint2="other"/></equality>
                 <contact><exclude body1="one" body2="other"/></contact>
                 <sensor><jointpos joint="joint1"/></sensor></mujoco>)");
  CHECK_NOTHROW(Workcell(scene));
}
