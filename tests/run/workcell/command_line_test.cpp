#include "programs/workcell/options/command_line.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "pal/trace/trace.hpp"
#include "programs/workcell/reports/statistics.hpp"
#include "programs/workcell/session/progress.hpp"
#include "sim/scene.hpp"
#include "tests/run/workcell/written_touch.hpp"

using namespace pal::workcell;

namespace fs = std::filesystem;

namespace {

/// Touch, with a parameter that is a text.
class NamedTouch final : public pal::test::WrittenTouch {
 public:
  NamedTouch() : WrittenTouch(false), description_(WrittenTouch::description()) {
    parameters_.assign(description_.parameters.begin(), description_.parameters.end());
    parameters_.push_back(
        {"location", pal::runtime::ParameterType::text, "", 0, 0, 0, "where it is", "park"});
    description_.parameters = parameters_;
  }
  const pal::runtime::SkillDescription& description() const override { return description_; }
  void set_text_parameter(std::string_view name, std::string_view text) override {
    if (name != "location") Skill::set_text_parameter(name, text);
    pal::runtime::check_parameter(parameters_.back(), text);
  }

 private:
  pal::runtime::SkillDescription description_;
  std::vector<pal::runtime::ParameterSpec> parameters_;
};

struct Answer {
  ExitStatus status;
  std::string out, error;
};

Answer workcell(const std::vector<std::string>& arguments) {
  std::ostringstream out, error;
  const std::vector<KnownSkill> skills{
      {"named-touch", [] { return std::make_unique<NamedTouch>(); }},
      {"touch", [] { return std::make_unique<pal::test::WrittenTouch>(false); }},
      {"touch-read-first", [] { return std::make_unique<pal::test::WrittenTouch>(true); }}};
  const ExitStatus status = main_program(
      arguments, [&] { return skills; }, out, error);
  return {status, out.str(), error.str()};
}

std::string content(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("pal-workcell-" + std::to_string(::getpid()))) {}
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("workcell list shows skills, parameters, completions and scenes") {
  const Answer answer = workcell({"list"});
  CHECK(answer.status == ExitStatus::done);
  CHECK(answer.out.find("touch-read-first") != std::string::npos);
  CHECK(answer.out.find("--set approach-speed=…   (1 to 60 mm/s, default 20)") != std::string::npos);
  CHECK(answer.out.find("completion 1 (contingency)") != std::string::npos);
  CHECK(answer.out.find("nothing      nothing within 360 mm below the tool") != std::string::npos);
}

TEST_CASE("workcell sets parameters that are texts") {
  CHECK(workcell({"list"}).out.find(
            "--set location=…  where it is (up to 100 characters, default \"park\")") != std::string::npos);
  const Folder folder;
  const Answer answer = workcell(
      {"run", "named-touch", "--set", "location=home = 1", "--no-picture", "--output", folder.path()});
  CAPTURE(answer.out, answer.error);
  CHECK(answer.status == ExitStatus::done);
  std::ostringstream json;
  json << std::ifstream(folder.path() + "/run.json").rdbuf();
  CHECK(json.str().find("\"home = 1\"") != std::string::npos);

  const std::string longer(101, 'a');
  const Answer refused = workcell({"run", "named-touch", "--set", "location=" + longer});
  CHECK(refused.status == ExitStatus::wrong_specification);
  CHECK(refused.error == "workcell: error: --set location=" + longer +
                             ": parameter location has 101 characters; it may have up to 100\n  hint: its "
                             "default is \"park\"\n");
}

TEST_CASE("workcell run writes what it did") {
  const Folder folder;
  const Answer answer = workcell({"run", "touch", "--phase", "3", "--no-picture", "--output", folder.path()});
  CAPTURE(answer.out, answer.error);
  REQUIRE(answer.status == ExitStatus::done);
  CHECK(answer.out.find("touch in scene touch: completion 0") == 0);
  CHECK(answer.out.find("first request after 3.000 ms") != std::string::npos);
  std::ifstream in(folder.path() + "/trace.json");
  CHECK(pal::trace::read_json(in).origin == "measured");
  for (const char* file : {"log.csv", "run.json", "trace.chrome.json"})
    CHECK(fs::exists(fs::path(folder.path()) / file));
  for (const char* file : {"force.csv", "force.gnuplot", "position.csv", "path.csv"})
    CHECK(fs::exists(fs::path(folder.path()) / "plots" / file));
  CHECK_FALSE(fs::exists(fs::path(folder.path()) / "arm.png"));
  CHECK_FALSE(fs::exists(fs::path(folder.path()) / "run.mp4"));
  // Nothing half-written is left.
  for (const auto& entry : fs::directory_iterator(folder.path())) CHECK(entry.path().extension() != ".part");
}

TEST_CASE("exit status: a contingency is a normal end, an error completion is not") {
  CHECK(workcell({"run", "touch", "--scene", "nothing", "--set", "reach=5", "--no-picture"}).status ==
        ExitStatus::done);
  // From here straight down leads out of the arm's reach.
  const Folder folder;
  fs::create_directories(folder.path());
  for (const char* part : {"puma560.xml", "cell.xml"})
    fs::copy_file(fs::path(PAL_SCENE_DIR) / part, fs::path(folder.path()) / part);
  std::ofstream(folder.path() + "/edge.xml")
      << R"(<mujoco><include file="puma560.xml"/><custom><numeric name="start" data="0.82 -0.2 -0.1 0"/></custom></mujoco>)";
  const Answer answer = workcell({"run", "touch", "--scene", "edge", "--scenes", folder.path(), "--set",
                                  "reach=300", "--set", "approach-speed=60", "--no-picture"});
  CAPTURE(answer.out, answer.error);
  CHECK(answer.status == ExitStatus::error_completion);
  CHECK(answer.out.find("fault, completion 2\n  alter: cannot make the motion: ") != std::string::npos);
}

TEST_CASE("workcell run --after runs another skill before, which must end with completion 0") {
  const Folder folder;
  const Answer answer =
      workcell({"run", "named-touch", "--after", "touch", "--no-picture", "--output", folder.path()});
  CAPTURE(answer.out, answer.error);
  CHECK(answer.status == ExitStatus::done);
  std::ostringstream json;
  json << std::ifstream(folder.path() + "/run.json").rdbuf();
  CHECK(json.str().find("\"after\": \"touch\"") != std::string::npos);

  const Answer refused =
      workcell({"run", "named-touch", "--after", "touch", "--scene", "nothing", "--no-picture"});
  CHECK(refused.status == ExitStatus::wrong_specification);
  CHECK(refused.error.find("touch in scene nothing") != std::string::npos);
  CHECK(refused.error.find("ended with completion 1") != std::string::npos);
  CHECK(workcell({"run", "touch", "--after", "tuch"}).error.find("did you mean 'touch'?") !=
        std::string::npos);
}

TEST_CASE("bad input: place, cause, hint, status, and no files") {
  const Folder folder;
  const auto refused = [&](std::vector<std::string> arguments, ExitStatus status, const std::string& text) {
    arguments.insert(arguments.end(), {"--output", folder.path(), "--no-picture"});
    const Answer answer = workcell(arguments);
    CAPTURE(answer.out);
    CHECK(answer.status == status);
    CHECK(answer.error == text);
    CHECK_FALSE(fs::exists(folder.path()));
  };
  refused({"run", "tuoch"}, ExitStatus::wrong_specification,
          "workcell: error: skill 'tuoch': there is no skill of this name\n  hint: did you mean 'touch'?\n");
  std::string scenes;
  for (const pal::sim::Scene& scene : pal::sim::list_scenes({PAL_SCENE_DIR}))
    scenes += (scenes.empty() ? "" : ", ") + scene.name;
  refused(
      {"run", "touch", "--scene", "nothin"}, ExitStatus::wrong_specification,
      "workcell: error: scene 'nothin': there is no scene of this name\n  hint: there are " + scenes + "\n");
  refused({"run", "touch", "--set", "approach-speed=600"}, ExitStatus::wrong_specification,
          "workcell: error: --set approach-speed=600: parameter approach-speed is 600 mm/s; it may be from 1 "
          "to 60 mm/s\n"
          "  hint: its default is 20 mm/s\n");
  refused({"run", "touch", "--set", "aproach-speed=20"}, ExitStatus::wrong_specification,
          "workcell: error: --set aproach-speed=20: skill touch has no parameter 'aproach-speed'\n"
          "  hint: did you mean 'approach-speed'?\n");
  refused({"run", "touch", "--set", "reach=20mm"}, ExitStatus::wrong_specification,
          "workcell: error: --set reach=20mm: '20mm' is not a number\n  hint: write the value without its "
          "unit\n");
  refused({"run", "touch", "--set", "reach=5", "--set", "threshold=4", "--set", "reach=6"}, ExitStatus::usage,
          "workcell: error: --set reach=6: reach has been set before, to 5\n  hint: set it once\n");
  refused({"run", "named-touch", "--set", "location=A", "--set", "location=B"}, ExitStatus::usage,
          "workcell: error: --set location=B: location has been set before, to \"A\"\n  hint: set it once\n");
  refused({"run", "touch", "--set", "reach"}, ExitStatus::usage,
          "workcell: error: --set reach: a parameter is set by name=value\n  hint: write --set "
          "approach-speed=20\n");
}

TEST_CASE("what cannot be is said before anything runs") {
  const Folder folder;
  fs::create_directories(folder.path());
  const auto refused = [](const std::vector<std::string>& arguments, ExitStatus status,
                          const std::string& text) {
    const Answer answer = workcell(arguments);
    CAPTURE(answer.out, answer.error);
    CHECK(answer.out.empty());  // no run
    CHECK(answer.status == status);
    CHECK(answer.error.find(text) != std::string::npos);
  };
  refused({"run", "touch", "--scene", "/"}, ExitStatus::wrong_specification,
          "workcell: error: /: this is a folder, not the file of a scene\n  hint: ");
  refused({"run", "touch", "--scenes", "/nothing/there"}, ExitStatus::usage,
          "workcell: error: --scenes /nothing/there: there is no such folder\n");
  refused({"run", "touch", "--scenes", folder.path()}, ExitStatus::usage,
          "workcell: error: --scenes " + folder.path() + ": the folder has no scenes\n");
  refused({"run", "touch", "--output", ""}, ExitStatus::usage, "--output: its value is empty");
  refused({"run", "touch", "--fault", ""}, ExitStatus::usage, "--fault: its value is empty");
  refused({"serve", "--log", ""}, ExitStatus::usage, "--log: its value is empty");
  refused({"run", "touch", "--output", "/proc/none"}, ExitStatus::usage,
          "workcell: error: --output /proc/none: cannot make the folder /proc/none");
  std::ofstream(folder.path() + "/file") << "x";
  refused({"run", "touch", "--output", folder.path() + "/file"}, ExitStatus::usage, "cannot make the folder");
  refused({"run", "touch", "--no-picture", "--measure=/proc/none/measured.pal"}, ExitStatus::usage,
          "--measure=/proc/none/measured.pal: cannot make the folder");
  refused({"run", "touch", "--scene", "parts"}, ExitStatus::wrong_specification,
          "scene parts: skill touch needs the tool pad, and the tool of this scene is gripper\n"
          "  hint: choose one with --scene: bar-under-forearm, ");
  refused({"run", "touch", "--scene", "flat"}, ExitStatus::wrong_specification,
          "needs the tool pad, and the tool of this scene is range-finder");
}

TEST_CASE("a fault that never came is said, with status 1") {
  const Folder folder;
  fs::create_directories(folder.path());
  const std::string file = folder.path() + "/late.fault";
  std::ofstream(file) << "at 1 ms force-torque late 1 ms\nat 60 s force-torque dropout\n";
  const Answer answer = workcell({"run", "touch", "--no-proof", "--fault", file});
  CAPTURE(answer.out, answer.error);
  CHECK(answer.status == ExitStatus::wrong_specification);
  CHECK(answer.out.find("  " + file +
                        ":2: the fault of force-torque at 60000 ms never came: the skill ended after ") !=
        std::string::npos);
  CHECK(answer.out.find(file + ":1:") == std::string::npos);
  std::ofstream(file) << "at 60 s SM1:7 takes 1 ms\n";
  const Answer slow = workcell({"run", "touch", "--no-proof", "--fault", file});
  CHECK(slow.status == ExitStatus::wrong_specification);
  CHECK(slow.out.find("the fault of SM1:7 at 60000 ms never came") != std::string::npos);
}

TEST_CASE("a standard output that cannot be written is no success") {
  struct Full final : std::streambuf {
    int overflow(int) override { return traits_type::eof(); }
  } full;
  std::ostream out(&full);
  std::ostringstream error;
  CHECK(main_program({"list"}, {}, out, error) == ExitStatus::usage);
  CHECK(error.str() ==
        "workcell: error: the standard output cannot be written: is it open, and is there space?\n");
  // Where it is known before, nothing is run.
  const Folder folder;
  CHECK(main_program({"run", "touch", "--output", folder.path()}, {}, out, error) == ExitStatus::usage);
  CHECK_FALSE(fs::exists(folder.path()));
  // A command that goes on for long says so at once.
  pal::runtime::RunControl control;
  std::ostream again(&full);
  ServePortCommand command;
  command.devices = {"force-torque"};
  command.scene_folders = {PAL_SCENE_DIR};
  CHECK_THROWS_AS(serve_port(command, control, again), Failure);
}

TEST_CASE("several devices of one cell are served, each at its line") {
  pal::runtime::RunControl control;
  control.stop();
  std::ostringstream out;
  ServePortCommand command;
  command.devices = {"val", "force-torque"};
  command.scene_folders = {PAL_SCENE_DIR};
  CHECK(serve_port(command, control, out) == ExitStatus::done);
  for (const char* line : {"val in scene touch at /dev/", "alter in scene touch at /dev/",
                           "force-torque in scene touch at /dev/"})
    CHECK(out.str().find(line) != std::string::npos);
  const auto cause = [&](std::vector<std::string> devices) {
    command.devices = std::move(devices);
    try {
      serve_port(command, control, out);
    } catch (const Failure& failure) {
      return std::string(failure.what());
    }
    return std::string();
  };
  CHECK(cause({"val", "val"}) == "serve-port val: the device is named twice");
  CHECK(cause({"val", "toaster"}) == "serve-port toaster: there is no device of this name");
  CHECK(cause({"val", "gripper"}) == "serve-port gripper: scene touch has another tool");
}

TEST_CASE("an empty file of faults is refused") {
  const Folder folder;
  fs::create_directories(folder.path());
  const std::string file = folder.path() + "/empty.fault";
  std::ofstream(file) << "# nothing yet\n\n";
  const Answer answer = workcell({"run", "touch", "--fault", file});
  CHECK(answer.status == ExitStatus::wrong_specification);
  CHECK(answer.error == "workcell: error: " + file + ": the file names no fault\n" +
                            "  hint: write a line, for example: at 500 ms force-torque dropout\n");
}

TEST_CASE("a broken promise is printed and written, the status is 3, and live events are the trace") {
  const Folder folder;
  fs::create_directories(folder.path());
  const std::string faults = folder.path() + "/slow.fault", events = folder.path() + "/events.jsonl";
  std::ofstream(faults) << "at 100 ms SM1:7 takes 40 ms\n";
  const Answer answer = workcell({"run", "touch", "--no-picture", "--no-plots", "--no-proof", "--fault",
                                  faults, "--live-trace", events, "--output", folder.path() + "/run"});
  CAPTURE(answer.out, answer.error);
  CHECK(answer.status == ExitStatus::error_completion);
  CHECK(
      answer.out.find("  broken promise: WTM( Zforce from LS1 ) of SM1 (written.pal:7) takes at most 50 us: "
                      "measured 40 ms") != std::string::npos);
  CHECK(content(folder.path() + "/run/run.json").find("\"measured_ns\": 40000000") != std::string::npos);

  std::ifstream trace(folder.path() + "/run/trace.json");
  const std::size_t count = pal::trace::read_json(trace).events.size();
  std::istringstream lines(content(events));
  std::vector<std::string> read;
  for (std::string line; std::getline(lines, line);) read.push_back(line);
  REQUIRE(read.size() == count + 2);
  CHECK(read.front().find("\"format\":\"pal-live-trace\"") != std::string::npos);
  CHECK(read.back().find("\"dropped\":0") != std::string::npos);

  std::ofstream(faults) << "at 100 ms SM1:700 takes 40 ms\n";
  const Answer refused = workcell({"run", "touch", "--fault", faults});
  CHECK(refused.status == ExitStatus::wrong_specification);
  CHECK(refused.error.find(faults + ":1: module SM1 has no statement in line 700\n") != std::string::npos);
  const Answer nowhere = workcell({"run", "touch", "--live-trace", "/proc/none/events"});
  CHECK(nowhere.status == ExitStatus::usage);
  CHECK(nowhere.error.find("--live-trace /proc/none/events: the file cannot be written") !=
        std::string::npos);
}

TEST_CASE("a command line that is wrong is a matter of usage") {
  CHECK(workcell({}).status == ExitStatus::usage);
  CHECK(workcell({"run"}).status == ExitStatus::usage);
  CHECK(workcell({"run", "touch", "--phase", "30"}).status == ExitStatus::usage);
  CHECK(workcell({"run", "touch", "--time", "never"}).status == ExitStatus::usage);
  CHECK(workcell({"run", "touch", "--against", "touch-read-first"}).status == ExitStatus::usage);
  CHECK(workcell({"run", "touch", "--no-picture", "--output", "/proc/none"}).status == ExitStatus::usage);
  for (const char* seed : {"-1", "1.5", "18446744073709551616", "one", ""}) {
    const Answer answer = workcell({"run", "touch", "--seed", seed});
    CAPTURE(seed, answer.error);
    CHECK(answer.status == ExitStatus::usage);
    CHECK(answer.error.find("--seed") != std::string::npos);
  }
  CHECK(workcell({"run", "touch", "--phase", "nan"}).status == ExitStatus::usage);
  CHECK(workcell({"run", "touch", "--seed", "1", "--seed", "1"}).status == ExitStatus::usage);
  const Answer both = workcell({"run", "touch", "--sweep", "2", "--phase", "3"});
  CHECK(both.status == ExitStatus::usage);
  CHECK(both.error.find("--phase excludes --sweep") != std::string::npos);
  const Answer named = workcell({"run", "named-touch", "--sweep", "2"});
  CAPTURE(named.error);
  CHECK(named.status == ExitStatus::usage);
  CHECK(named.error.find("'named-touch' cannot be swept: it names no PAL") != std::string::npos);
  CHECK(workcell({"run", "touch", "--sweep", "2", "--live"}).status == ExitStatus::usage);
  CHECK(workcell({"run", "touch", "--sweep", "2", "--video", "--output", "/tmp/none"}).status ==
        ExitStatus::usage);
  const Answer nowhere = workcell({"run", "touch", "--video"});
  CHECK(nowhere.status == ExitStatus::usage);
  CHECK(nowhere.error.find("--video requires --output") != std::string::npos);
  const Answer help = workcell({"run", "--help"});
  CHECK(help.status == ExitStatus::done);
  CHECK(help.out.find("--sweep") != std::string::npos);
}

TEST_CASE("a run is the same byte for byte, with observers or without") {
  const Folder folder;
  const auto run = [&](const std::string& name, std::vector<std::string> looking) {
    std::vector<std::string> arguments{"run", "touch", "--seed", "5", "--output", folder.path() + "/" + name};
    arguments.insert(arguments.end(), looking.begin(), looking.end());
    return workcell(arguments);
  };
  REQUIRE(run("alone", {"--no-picture", "--no-plots"}).status == ExitStatus::done);
  const Answer watched = run("watched", {"--video", "--live"});
  CAPTURE(watched.out, watched.error);
  if (watched.error.find("--video") != std::string::npos) {
    WARN("no video here: " << watched.error);
    REQUIRE(run("watched", {"--live"}).status == ExitStatus::done);
  } else {
    CHECK(fs::file_size(folder.path() + "/watched/run.mp4") > 10'000);
  }
  for (const char* file : {"trace.json", "trace.chrome.json", "log.csv", "run.json"}) {
    CAPTURE(file);
    CHECK(content(folder.path() + "/alone/" + file) == content(folder.path() + "/watched/" + file));
  }
}

TEST_CASE("progress: a line a simulated second, or one that is rewritten") {
  const Answer plain = workcell({"run", "touch", "--live", "--set", "approach-speed=10"});
  std::istringstream lines(plain.out);
  std::string line;
  std::getline(lines, line);
  CHECK(line.find("    1.00 s") == 0);
  CHECK(line.find(" x  moving      force   0.0 N  tool ") != std::string::npos);
  std::getline(lines, line);
  CHECK(line.find("    2.0") == 0);
  CHECK(line.find("pressing") != std::string::npos);
  CHECK(plain.out.find('\r') == std::string::npos);

  pal::sim::Workcell cell(pal::sim::find_scene("touch", {PAL_SCENE_DIR}));
  std::ostringstream out;
  std::chrono::steady_clock::time_point now{};
  Progress progress(cell, out, true, [&] { return now; });
  now += std::chrono::milliseconds(50);
  progress.show();
  CHECK(out.str().empty());
  cell.advance_to(std::chrono::milliseconds(300));
  now += std::chrono::milliseconds(50);
  progress.show();
  CHECK(out.str().find("\r    0.30 s    3.0 x  standing") == 0);
  progress.end();
  CHECK(out.str().back() == '\n');
}

TEST_CASE("figures of a distribution") {
  const Distribution odd = distribution({3, 1, 2});
  CHECK(odd.count == 3);
  CHECK(odd.least == 1);
  CHECK(odd.median == 2);
  CHECK(odd.mean == 2);
  CHECK(odd.greatest == 3);
  CHECK(distribution({4, 1, 2, 3}).median == 2.5);
  CHECK(distribution({}).count == 0);
  CHECK(histogram({0, 0.5, 1, 2}, 0, 2, 2, "N") ==
        "     0.0 to    1.0 N |##                             2\n"
        "     1.0 to    2.0 N |##                             2\n");
}

TEST_CASE("an operation that cannot be read is reported once, with the reason") {
  const Answer answer = workcell({"operation", "run", "no-such.op.json"});
  CHECK(answer.status == ExitStatus::usage);
  CHECK(answer.error ==
        "workcell: error: operation: cannot read 'no-such.op.json': no such file\n"
        "  hint: check the name and whether the file may be read\n");
}
