// The examples run in the workcell, from their START to their ends.
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <utility>

#include "operations/icon_times.hpp"
#include "operations/load.hpp"
#include "programs/workcell/options/command_line.hpp"
#include "programs/workcell/session/cell_runner.hpp"
#include "programs/workcell/session/failure.hpp"
#include "programs/workcell/session/live_channels.hpp"

using namespace pal::workcell;

namespace {

struct Answer {
  ExitStatus status;
  std::string out, error;
  std::vector<nlohmann::json> steps;
};

Answer run(const std::string& example, std::vector<std::string> options, const std::string& lines = "") {
  const auto log =
      std::filesystem::temp_directory_path() / ("operation-" + std::to_string(::getpid()) + ".jsonl");
  options.insert(options.begin(),
                 {"operation", "run", PAL_SOURCE_DIR "/examples/operations/" + example + ".op.json", "--log",
                  log.string()});
  std::istringstream in(lines);
  std::ostringstream out, error;
  Answer answer{main_program(options, installed_skills, out, error, false, &in), out.str(), error.str(), {}};
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) answer.steps.push_back(nlohmann::json::parse(line));
  std::filesystem::remove(log);
  return answer;
}

std::vector<std::string> icons(const Answer& answer) {
  std::vector<std::string> result;
  for (const auto& step : answer.steps) result.push_back(step.at("icon"));
  return result;
}

}  // namespace

TEST_CASE("rub in square finds the plate, rubs four sides and leaves") {
  const Answer answer = run("rub_in_square", {"--scene", "touch"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(icons(answer) == std::vector<std::string>{"find", "rub-in-square/side-1", "rub-in-square/side-2",
                                                  "rub-in-square/side-3", "rub-in-square/side-4", "lift"});
  for (const auto& step : answer.steps) CHECK(step.at("code") == 0);
  CHECK(answer.out.find("exit 'done' with code 0") != std::string::npos);
}

TEST_CASE("a broken promise is in the reason of its skill, and the policy is followed") {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("late-" + std::to_string(::getpid()))).string();
  std::ofstream(file) << "at 500 ms force-torque late 3 ms\n";
  const std::vector<std::string> late{
      "--scene", "touch", "--steps", "1", "--fault", file, "--on-broken-promise"};
  const auto with = [&late](const char* policy) {
    std::vector<std::string> options = late;
    options.push_back(policy);
    const Answer answer = run("rub_in_square", options);
    INFO(answer.out << answer.error);
    REQUIRE(answer.steps.size() == 1);
    return answer.steps.front();
  };
  const auto reported = with("report");
  CHECK(reported.at("code") == 0);
  CHECK(reported.at("reason").get<std::string>().starts_with(
      "The tool touches the surface. broken promise: force-torque answers"));
  for (const char* policy : {"stop", "contingency"}) {  // touch has no answer to it
    const auto stopped = with(policy);
    CHECK(stopped.at("kind") == "error");
    CHECK(stopped.at("code") == 2);
    CHECK(stopped.at("reason").get<std::string>().find("force-torque answers") != std::string::npos);
    CHECK(stopped.at("reason").get<std::string>().find("broken promise:") == std::string::npos);
  }
  std::ofstream(file) << "at 500 ms camera dropout\n";
  const Answer none = run("rub_in_square", {"--scene", "touch", "--fault", file});
  CHECK(none.status == ExitStatus::wrong_specification);
  CHECK(none.error.find("there is no device 'camera' to go wrong") != std::string::npos);
  std::ofstream(file) << "at 500 ms SM1:55 takes 40 ms\n";
  CHECK(run("rub_in_square", {"--scene", "touch", "--fault", file}).status ==
        ExitStatus::wrong_specification);
  std::filesystem::remove(file);
}

TEST_CASE("pick and place goes round until the steps are up") {
  const Answer answer = run("pick_and_place", {"--scene", "parts", "--steps", "7"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(icons(answer) ==
        std::vector<std::string>{"go-home", "pick", "place", "pick-again", "place-back", "go-home", "pick"});
  for (const auto& step : answer.steps) CHECK(step.at("code") == 0);
}

TEST_CASE("a pallet is filled, and the operation says so") {
  const Answer answer = run("fill_a_pallet", {"--scene", "pallet"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(answer.out.find("exit 'pallet-full' with code 0") != std::string::npos);
  CHECK(answer.steps.back().at("code") == 1);
}

TEST_CASE("an edge is followed again and again") {
  const Answer answer = run("follow_edge_again", {"--scene", "seam", "--steps", "4"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(icons(answer) == std::vector<std::string>{"go-home", "follow", "go-home", "follow"});
  for (const auto& step : answer.steps) CHECK(step.at("code") == 0);
}

TEST_CASE("the program of the RAPL kind deals with all parts, which the operation counts") {
  const Answer answer = run("automatic_start", {"--scene", "pallet"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(answer.out.find("exit 'stop' with code 0") != std::string::npos);
  std::vector<int> placed;
  for (const auto& step : answer.steps)
    if (step.at("icon") == "main/put") placed.push_back(step.at("parameters").at("placed"));
  CHECK(placed == std::vector<int>{0, 1, 2});
}

TEST_CASE("a part is identified by height, picked, identified by width and placed") {
  const std::string part = GENERATE("low", "middle", "high");
  const bool collapsed = GENERATE(false, true);
  const Answer answer =
      run(collapsed ? "pick_by_identity_collapsed" : "pick_by_identity", {"--scene", "delivery-" + part});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  const std::string pick = collapsed ? "pick-it/" : "", place = collapsed ? "place-it/" : "";
  CHECK(icons(answer) == std::vector<std::string>{"go-home", "a-part-comes", pick + "which-part",
                                                  pick + "pick-" + part, "carry", place + "which-held",
                                                  place + "place-" + part, "go-home", "a-part-comes"});
  CHECK(answer.out.find("exit 'no-part' with code 0") != std::string::npos);
}

TEST_CASE("press twice presses gently and harder, and looks at what was felt") {
  const Answer answer = run("press_twice", {"--scene", "touch"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(icons(answer) ==
        std::vector<std::string>{"gently/press", "gently/peak", "harder/press", "harder/peak", "lift/up"});
  for (const auto& [step, force] : {std::pair<std::size_t, double>{0, 5}, {2, 12}}) {
    CHECK(answer.steps[step].at("parameters").at("force") == force);
    const double greatest = answer.steps[step].at("figures").at("greatest-force");
    CHECK(greatest >= force);
    CHECK(greatest < 25);
    CHECK(answer.steps[step + 1].at("reading") == greatest);
  }
  // Without a plate it says so, by the status of the program, too.
  const Answer none = run("press_twice", {"--scene", "nothing"});
  INFO(none.out << none.error);
  CHECK(static_cast<int>(none.status) == 101);
}

TEST_CASE("a part is weighed in the air, the same each time, and put where it belongs") {
  const Answer answer = run("weigh_and_sort", {"--scene", "parts"});
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(icons(answer) ==
        std::vector<std::string>{"go-home", "empty", "pick", "lift", "settle", "weigh", "put-heavy/put"});
  CHECK(answer.steps[5].at("reading") == Approx(1.96).margin(0.3));  // N: 200 g
  using namespace pal;
  sim::Cell cell(sim::find_scene("parts", {PAL_SOURCE_DIR "/sim/scenes"}), {});
  const double before = *cell.sense("force-z").value;
  CHECK_FALSE(cell.zero("force-z"));
  CHECK(*cell.sense("force-z").value == Approx(0).margin(0.5));
  CHECK(std::abs(before) < 20);
  CHECK(cell.zero("smell") == "there is no sensor 'smell' that can be zeroed");
  CHECK(cell.zero("gripper-width") == "the sensor 'gripper-width' has no zero to be set");
}

TEST_CASE("five touches and a question, which is answered before or by the person there") {
  const Answer answer =
      run("five_with_a_question", {"--scene", "touch", "--answer", "ask=Five more"}, "what?\n2\n");
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  CHECK(answer.steps.size() == 24);
  CHECK(answer.steps[10].at("sensor") == "the count of five");
  CHECK(answer.steps[10].at("reading") == 5);
  CHECK(answer.steps[11].at("answer") == "Five more");
  CHECK(answer.steps.back().at("answer") == "That is enough");
  CHECK(answer.out.find("write a number from 1 to 2") != std::string::npos);
}

TEST_CASE("a question without a person, and an answer that is none, go to error") {
  const Answer nobody = run("five_with_a_question", {"--scene", "touch", "--from", "ask"});
  CHECK(static_cast<int>(nobody.status) == 102);
  CHECK(nobody.steps.at(0).at("code") == -1);
  const Answer other =
      run("five_with_a_question", {"--scene", "touch", "--from", "ask", "--answer", "ask=Perhaps"});
  CHECK(static_cast<int>(other.status) == 102);
  CHECK(run("five_with_a_question", {"--scene", "touch", "--answer", "Perhaps"}).status == ExitStatus::usage);
}

TEST_CASE("a parameter is set to a place that is taught only") {
  const Answer answer = run("pick_and_place", {"--scene", "parts", "--step"},
                            "set go-home location NOWHERE\nset go-home location PART\nquit\n");
  INFO(answer.out);
  CHECK(answer.out.find("location 'NOWHERE' is not taught") != std::string::npos);
  CHECK(answer.out.find("go-home: location is \"PART\" now, before it was \"HOME\"") != std::string::npos);
}

TEST_CASE("sensors are read by their lines, between skills") {
  using namespace pal;
  sim::Cell cell(sim::find_scene("delivery-middle", {PAL_SOURCE_DIR "/sim/scenes"}), {});
  const auto width = cell.sense("gripper-width");
  CHECK(*width.value == Approx(80).margin(0.2));
  CHECK(*cell.sense("gripper-holding").value == 0);
  CHECK(*cell.sense("delivery").value == Approx(240).margin(0.6));
  CHECK(*cell.sense("force-z").value == Approx(0).margin(1));  // its first reading is its zero
  CHECK(cell.sense("range-nearest").problem == "the cell has no range-finder");
  CHECK(cell.sense("smell").problem.find("there is no sensor 'smell'") == 0);
  runtime::RunControl control;
  control.stop();
  CHECK(cell.sense("gripper-width", &control).stopped);
  CHECK(cell.sense("gripper-width").value);
  sim::Cell range(sim::find_scene("flat", {PAL_SOURCE_DIR "/sim/scenes"}), {});
  CHECK(*range.sense("range-nearest").value == Approx(225).margin(3));
}

TEST_CASE("a skill without its tool is refused, with scenes that have it") {
  std::ostringstream out, error;
  std::istringstream in;
  CHECK(main_program({"run", "standoff"}, installed_skills, out, error, false, &in) ==
        ExitStatus::wrong_specification);
  INFO(error.str());
  CHECK(error.str().find("choose one with --scene: ") != std::string::npos);
  CHECK(error.str().find("pyramid") != std::string::npos);
  CHECK(run("pick_and_place", {"--scene", "touch"}).error.find("parts") != std::string::npos);
}

TEST_CASE("an operation is stepped and changed by hand") {
  const Answer answer = run("rub_in_square", {"--scene", "touch", "--step"},
                            "break rub-in-square/side-1\nrun\nset rub-in-square/side-1 distance 1\nset "
                            "rub-in-square/side-1 distance 900\nstep\nquit\n");
  INFO(answer.out << answer.error);
  CHECK(answer.status == ExitStatus::done);
  REQUIRE(answer.steps.size() == 2);
  CHECK(answer.steps[1].at("parameters").at("distance") == 1);
  CHECK(answer.out.find("write a number from 0.1 to 50 cm") != std::string::npos);
}

TEST_CASE("what cannot be run is refused before anything moves") {
  CHECK(run("nothing", {}).status == ExitStatus::usage);
  CHECK(run("rub_in_square", {"--from", "nowhere"}).status == ExitStatus::wrong_specification);
  CHECK(run("rub_in_square", {"--break", "find=x"}).status == ExitStatus::usage);
}

namespace {

/// The physics, and something that happens at an instant.
struct AlarmedWorld final : pal::runtime::World {
  AlarmedWorld(pal::sim::Workcell& workcell, pal::runtime::Time when, std::function<void()> alarm)
      : workcell_(workcell), when_(when), alarm_(std::move(alarm)) {}
  void advance_to(pal::runtime::Time when) override {
    workcell_.advance_to(when);
    if (alarm_ && when >= when_) std::exchange(alarm_, nullptr)();
  }

 private:
  pal::sim::Workcell& workcell_;
  pal::runtime::Time when_;
  std::function<void()> alarm_;
};

}  // namespace

TEST_CASE("a skill that is stopped leaves the arm at rest, and runs again") {
  using namespace pal;
  SourceManager sources;
  Diagnostics diagnostics;
  const auto program = operations::load(
      DiskFileSystem(), sources, PAL_SOURCE_DIR "/examples/operations/rub_in_square.op.json", diagnostics);
  REQUIRE(program);
  operations::Executor* executor = nullptr;
  sim::CellOptions options;
  options.watch = [&](sim::Workcell& workcell) {
    return std::make_unique<AlarmedWorld>(workcell, std::chrono::milliseconds(2'800),
                                          [&] { executor->stop(); });
  };
  sim::Cell cell(sim::find_scene("touch", {PAL_SOURCE_DIR "/sim/scenes"}), options);
  const std::vector<KnownSkill> skills = installed_skills();
  CellRunner runner(cell, skills, runtime::CostPolicy::worst, 1);
  operations::Executor made(*program, runner);
  executor = &made;

  CHECK(made.run() == operations::ExecutionState::stopped);
  CHECK(made.token() == "rub-in-square/side-1");
  const auto stopped_at = cell.workcell().log().back().tool;
  cell.station().idle(std::chrono::milliseconds(500));
  CHECK((cell.workcell().log().back().tool - stopped_at).norm() < 2e-4);  // m: it settles on the plate

  CHECK(made.run() == operations::ExecutionState::ended);
  CHECK(made.last_code() == 0);
}

namespace {

using Parameters = std::vector<pal::operations::Parameter>;

pal::operations::Parameter parameter(const char* name, pal::operations::Value value) {
  return {name, std::move(value), {}, {}};
}

}  // namespace

TEST_CASE("skills keep the longest times that the cell declares, from one end of their ranges to the other") {
  struct Case {
    const char *scene, *skill;
    Parameters parameters;
    int code;
  };
  const Case cases[] = {
      {"nothing", "touch", {parameter("reach", 300.0), parameter("approach-speed", 60.0)}, 1},
      {"nothing", "touch", {parameter("reach", 1.0), parameter("approach-speed", 1.0)}, 1},
      {"touch", "touch", {parameter("approach-speed", 5.0)}, 0},
      {"touch", "press", {parameter("approach-speed", 20.0), parameter("time", 0.1)}, 0},
      {"nothing", "press", {parameter("search-distance", 20.0), parameter("approach-speed", 60.0)}, 1},
      {"touch",
       "relative-move",
       {parameter("dz", -60.0), parameter("rz", 60.0), parameter("speed", 40.0)},
       0},
      {"touch", "relative-move", {parameter("dz", -1.0), parameter("speed", 500.0)}, 0},
      {"touch", "relative-move", {parameter("dx", 300.0), parameter("dy", 300.0), parameter("dz", 300.0)}, 1},
      {"touch", "move-to-location", {parameter("speed", 5.0)}, 0},
      {"parts", "pick-at-location", {parameter("approach", 200.0), parameter("speed", 20.0)}, 0},
      {"parts", "pick-at-location", {parameter("location", std::string("PLACE"))}, 1},
      {"pallet", "palletize", {parameter("placed", 9.0)}, 1},
      {"waves", "rub", {parameter("distance", 2.0), parameter("speed", 2.0)}, 0},
      {"flat", "standoff", {parameter("speed", 3.0)}, 0},
      {"seam", "follow-edge", {parameter("distance", 3.0), parameter("rotation", 0.05)}, 0},
  };
  for (const Case& each : cases) {
    INFO(each.skill << " in " << each.scene);
    pal::sim::Cell cell(pal::sim::find_scene(each.scene, {PAL_SOURCE_DIR "/sim/scenes"}));
    const auto known = installed_skills();
    CellRunner runner(cell, known, pal::runtime::CostPolicy::worst, 1);
    const auto result = runner.run(each.skill, each.parameters, std::nullopt);
    INFO(result.reason);
    CHECK(result.code == each.code);
    CHECK(result.reason.find("is declared") == std::string::npos);
    const auto longest = pal::operations::declared_longest(templates_of(known).at(each.skill), each.code,
                                                           each.parameters, nullptr, longest_of(known));
    CHECK(longest);
  }
}

TEST_CASE("a cell's skills say which values they refuse together") {
  const auto scene = pal::sim::find_scene("touch", {PAL_SOURCE_DIR "/sim/scenes"});
  pal::sim::Cell cell(scene);
  const auto known = installed_skills();
  const auto refused = cell_of(cell, known, scene, {PAL_SOURCE_DIR "/sim/scenes"}).refused_together;
  REQUIRE(refused);
  CHECK_FALSE(refused("rub", {parameter("distance", 2.0)}));
  CHECK(refused("rub", {parameter("greatest-force", -10.0), parameter("least-force", -20.0)})
            .value_or("")
            .find("greatest-force must be below least-force") != std::string::npos);
  CHECK_FALSE(refused("juggle", {}));
}

TEST_CASE(
    "every completion of a skill of the workcell has a longest time, but of one that lasts as long as a "
    "person holds") {
  const auto known = installed_skills();
  const auto longest = longest_of(known);
  for (const auto& [name, skill] : templates_of(known))
    for (const auto& each : skill.completions) {
      INFO(name << ' ' << each.code);
      CHECK(longest.count({name, each.code}) == (name == "jog" ? 0 : 1));
    }
}

TEST_CASE("rub gives up within its time if its band is too soft to bring the tool down") {
  pal::sim::Cell cell(pal::sim::find_scene("waves", {PAL_SOURCE_DIR "/sim/scenes"}));
  const auto known = installed_skills();
  CellRunner runner(cell, known, pal::runtime::CostPolicy::worst, 1);
  const pal::runtime::Time begin = runner.now();
  const auto result =
      runner.run("rub", {parameter("greatest-force", -1.0), parameter("least-force", 0.0)}, std::nullopt);
  CHECK(result.code == 2);
  CHECK(result.reason.find("has not landed within 60 s") != std::string::npos);
  CHECK(runner.now() - begin < std::chrono::seconds(62));
}

TEST_CASE("a skill that takes longer than is declared says so") {
  pal::sim::Cell cell(pal::sim::find_scene("touch", {PAL_SOURCE_DIR "/sim/scenes"}));
  auto known = installed_skills();
  for (KnownSkill& skill : known)
    if (skill.name == "touch")
      skill.declared =
          std::get<pal::operations::Declared>(pal::operations::read_declared("longest 0: 0.01 * reach"));
  CellRunner runner(cell, known, pal::runtime::CostPolicy::worst, 1);
  const auto result = runner.run("touch", {}, std::nullopt);
  INFO(result.reason);
  CHECK(result.code == 0);
  CHECK(result.reason.find("broken promise: touch took ") != std::string::npos);
  CHECK(result.reason.find("at most 600 ms is declared") != std::string::npos);
}

TEST_CASE("each formula of a longest time can be read, and names parameters of its skill") {
  const auto known = installed_skills();
  const auto skills = templates_of(known);
  const auto longest = longest_of(known);
  CHECK(longest.size() > 30);
  for (const auto& [of, formula] : longest) {
    INFO(of.first << ' ' << of.second << ": " << formula.text());
    const auto usual =
        pal::operations::declared_longest(skills.at(of.first), of.second, {}, nullptr, longest);
    CHECK(usual);
    const auto& codes = skills.at(of.first).completions;
    CHECK(std::any_of(codes.begin(), codes.end(), [&](const auto& each) { return each.code == of.second; }));
  }
}

TEST_CASE("limits that skills declare are shown in the channels that they name") {
  const auto shown = [](pal::sim::ToolKind tool, const std::vector<KnownSkill>& skills) {
    std::set<std::string> result;
    for (const pal::server::Channel& channel : live_channels(tool, skills))
      for (const pal::server::ShownLimit& limit : channel.limits) {
        std::ostringstream text;
        text << channel.name << ' ' << limit.skill << ' ' << static_cast<int>(limit.kind);
        for (const std::string& field : limit.fields) text << ' ' << field;
        if (limit.around) text << ' ' << limit.around->factor << ' ' << limit.around->parameter;
        text << (limit.both ? " +- " : " ") << limit.factor << ' ' << limit.parameter;
        result.insert(text.str());
      }
    return result;
  };
  const auto known = installed_skills();
  const std::set<std::string> force{"force touch 1 fz -1 threshold",
                                    "force touch-read-first 1 fz -1 threshold",
                                    "force rub 0 fz 0.05 greatest-force",
                                    "force rub 0 fz 0.05 least-force",
                                    "force rub 2 fx fy fz +- 0.05 stop-force",
                                    "force rub 3 fx fy fz +- 0.05 error-force",
                                    "force press 1 fz -1 force",
                                    "force press 0 fz -1 force +- 1 band",
                                    "force press 2 fx fy fz +- 1 stop-force"};
  CHECK(shown(pal::sim::ToolKind::pad, known) == force);
  std::set<std::string> all = force;
  all.insert({"profile standoff 1 z 1 distance", "profile standoff 0 z 1 distance +- 1 tolerance",
              "profile align 1 z 1 standoff", "profile follow-edge 1 z 10 standoff"});
  CHECK(shown(pal::sim::ToolKind::range_finder, known) == all);

  const auto why = [&](const std::string& text) -> std::string {
    auto wrong = known;
    wrong.front().declared_file = "a.declared";
    wrong.front().declared = std::get<pal::operations::Declared>(pal::operations::read_declared(text));
    try {
      live_channels(pal::sim::ToolKind::pad, wrong);
    } catch (const Failure& failure) {
      std::ostringstream out;
      failure.print(out);
      return out.str();
    }
    return {};
  };
  CHECK(why("limit width of gripper: target threshold").empty());  // of another tool
  CHECK(why("\nlimit fz of forse: target x").find("a.declared:2: a cell has no channel 'forse'") !=
        std::string::npos);
  CHECK(why("limit fz, fw of force: target x").find("its fields are fx, fy, fz, tx, ty, tz") !=
        std::string::npos);
}

TEST_CASE("the document of longest times has each of them") {
  std::ifstream file(PAL_SOURCE_DIR "/docs/workcell/longest-times.md");
  std::ostringstream text;
  text << file.rdbuf();
  std::size_t rows = 0;
  for (const auto& [of, formula] : longest_of(installed_skills())) {
    if (of.first == "touch-read-first") continue;  // as touch
    const std::string row =
        "| " + of.first + " | " + std::to_string(of.second) + " | `" + formula.text() + "` |\n";
    CAPTURE(row);
    CHECK(text.str().find(row) != std::string::npos);
    ++rows;
  }
  const std::string table = text.str().substr(text.str().find("| --- |"));
  const auto lines =
      std::count(table.begin(), table.begin() + static_cast<std::ptrdiff_t>(table.find("\n\n")), '\n');
  CHECK(static_cast<std::size_t>(lines) == rows);
}
