#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/unit/program/program.hpp"

using namespace pal::test;
using pal::program::ExitStatus;
namespace fs = std::filesystem;

namespace {

/// A folder that is gone when the test is.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(fs::temp_directory_path() / pal::test::own_name("pal-driver-" + name)) {
    fs::remove_all(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("pal pan draws every module with a body, or the one that is named") {
  const Folder folder("pan");
  CHECK(pal::test::pal({"pan", touch, "-o", folder.path()}).status == ExitStatus::all_hold);
  for (const std::string module : {"SM1", "LS1", "SD1", "MC1", "CM1"}) {
    CHECK(content(folder.file("touch." + module + ".pan.svg")).find("</svg>") != std::string::npos);
  }
  CHECK(pal::test::pal({"pan", touch, "-m", "SM9", "-o", folder.path()}).status == ExitStatus::usage);
}

TEST_CASE("pal pan draws conditions as they are written") {
  const Folder folder("pan-written");
  fs::create_directories(folder.path());
  std::ofstream(folder.file("written.pal")) << R"(Logical Sensor: LS1
BEGIN
  REPEAT
    SPC( near )
    SPC( far )
    RPC( near )
    RPC( far )
    CASE
      ( near ):
        Do Nothing
      ( NOT near ):  # nothing there
        CASE
          ( far = TRUE ):
            Do Nothing
          ( far = FALSE  # not yet
          ):
            Do Nothing
        END CASE
    END CASE
  UNTIL( ( near = TRUE  AND
           NOT ( far = TRUE ) ) OR far )
END
)";
  REQUIRE(pal::test::pal({"pan", folder.file("written.pal"), "--dot", "-o", folder.path()}).status ==
          ExitStatus::all_hold);
  const std::string dot = content(folder.file("LS1.LS1.pan.dot"));
  CHECK_THAT(dot, Catch::Contains("label=\"near\"") && Catch::Contains("label=\"NOT near\"") &&
                      Catch::Contains("label=\"far = TRUE\""));
  CHECK_THAT(dot, Catch::Contains("label=\"far = FALSE\""));  // as it would be spelt: it has a comment inside
  CHECK_THAT(dot, Catch::Contains("UNTIL( ( near = TRUE") && Catch::Contains("NOT ( far = TRUE ) )"));
  CHECK_THAT(dot, Catch::Contains("pal_guard=\"near = TRUE\""));  // the content stays in one spelling

  // Drawn again from the drawing, which has one spelling.
  fs::rename(folder.file("LS1.LS1.pan.dot"), folder.file("LS1.dot"));
  REQUIRE(pal::test::pal({"pan", folder.file("LS1.dot"), "--dot", "-o", folder.path()}).status ==
          ExitStatus::all_hold);
  CHECK_THAT(content(folder.file("LS1.LS1.pan.dot")), Catch::Contains("label=\"near = TRUE\""));
}

TEST_CASE("pal atc draws the worst run and writes it as a trace") {
  const Folder folder("atc");
  const std::vector<std::string> arguments{"atc",     touch,
                                           "-e",      cell,
                                           "-r",      "fresh-force",
                                           "-o",      folder.file("a.svg"),
                                           "--trace", folder.file("a.json")};
  REQUIRE(pal::test::pal(arguments).status == ExitStatus::all_hold);
  const std::string picture = content(folder.file("a.svg"));
  CHECK(picture.find("7.3 ms") != std::string::npos);
  REQUIRE(pal::test::pal(arguments).status == ExitStatus::all_hold);
  CHECK(content(folder.file("a.svg")) == picture);

  // The worst run laid over itself: measured is proved.
  const auto overlay = pal::test::pal({"atc", touch, "-e", cell, "-r", "fresh-force", "-o",
                                       folder.file("b.svg"), "--measured", folder.file("a.json")});
  CHECK(overlay.status == ExitStatus::all_hold);
  CHECK(content(folder.file("b.svg")).find("proved at most 7.3 ms, measured 7.3 ms") != std::string::npos);
}

TEST_CASE("pal atc says what it cannot draw") {
  const Folder folder("atc-bad");
  const std::string out = folder.file("x.svg");
  CHECK(pal::test::pal({"atc", touch, "-o", out}).err.find("--environment") != std::string::npos);
  CHECK(pal::test::pal({"atc", touch, "-e", cell, "-r", "nonsense", "-o", out}).err.find("'fresh-force'") !=
        std::string::npos);
  const auto no_trace = pal::test::pal({"atc", touch, "-e", cell, "-o", out, "--measured", touch});
  CHECK(no_trace.status == ExitStatus::usage);
  CHECK(no_trace.err.find("is no trace") != std::string::npos);
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("the chart of a loss shows the lost frame, the next one, and the request that came too late") {
  const Folder folder("loss");
  const std::string example = std::string(PAL_SOURCE_DIR) + "/examples/range_finder/";
  REQUIRE(pal::test::pal(
              {"atc", example + "without_courier.pal", "-r", "every-frame", "-o", folder.file("a.svg")})
              .status == ExitStatus::all_hold);
  const std::string lost = content(folder.file("a.svg"));
  CHECK(lost.find("class=\"loss\"") != std::string::npos);
  CHECK(lost.find("lost: no request for it was open when it began\n78 ms to 154 ms") != std::string::npos);
  CHECK(lost.find("asked for too late by 13 ms") != std::string::npos);
  CHECK(lost.find("Reader: runs interpret") != std::string::npos);
  CHECK(lost.find("156 ms to 232 ms") != std::string::npos);  // the next frame

  REQUIRE(
      pal::test::pal({"atc", example + "range_finder.pal", "-r", "every-frame", "-o", folder.file("b.svg")})
          .status == ExitStatus::all_hold);
  const std::string kept = content(folder.file("b.svg"));
  CHECK(kept.find("every-frame holds") != std::string::npos);
  CHECK(kept.find("a simulated run") != std::string::npos);
  CHECK(kept.find("class=\"loss\"") == std::string::npos);
}

TEST_CASE("pal atc --format html writes one page with every requirement and run") {
  const Folder folder("html");
  const std::vector<std::string> arguments{"atc",      touch,  "-e", cell,
                                           "--format", "html", "-o", folder.file("a.html")};
  REQUIRE(pal::test::pal(arguments).status == ExitStatus::all_hold);
  const std::string page = content(folder.file("a.html"));
  for (const std::string requirement : {"answer-alter", "fresh-force", "headroom"})
    CHECK(page.find("\"name\":\"" + requirement + "\"") != std::string::npos);
  CHECK(page.find("\"worst run\"") != std::string::npos);
  CHECK(page.find("\"measured run\"") == std::string::npos);
  REQUIRE(pal::test::pal(arguments).status == ExitStatus::all_hold);
  CHECK(content(folder.file("a.html")) == page);

  const auto run = pal::test::pal({"atc", touch, "-e", cell, "-r", "fresh-force", "-o", folder.file("a.svg"),
                                   "--trace", folder.file("a.json")});
  REQUIRE(run.status == ExitStatus::all_hold);
  const auto both = pal::test::pal({"atc", touch, "-e", cell, "--format", "html", "-o", folder.file("b.html"),
                                    "--measured", folder.file("a.json")});
  CHECK(both.status == ExitStatus::all_hold);
  CHECK(content(folder.file("b.html")).find("\"measured run\"") != std::string::npos);
}

TEST_CASE("pal generate writes nothing when something is wrong") {
  const Folder folder("generate");
  CHECK(pal::test::pal({"generate", touch, "-o", folder.path()}).status == ExitStatus::usage);
  CHECK_FALSE(fs::exists(folder.path()));
  CHECK(pal::test::pal({"generate", touch, "-e", cell, "-o", folder.path(), "--depfile", folder.file("d")})
            .status == ExitStatus::all_hold);
  CHECK(content(folder.file("d")).find("touch_modules.pal") != std::string::npos);
}

TEST_CASE("the rule of pal generate --depfile names files by absolute paths, spelled for make") {
  const Folder folder("depfile");
  fs::create_directories(folder.path());
  fs::copy_file(cell, folder.file("a cell.pal"));
  const std::string relative = fs::relative(touch).string();
  const auto run =
      pal::test::pal({"generate", relative, "-e", folder.file("a cell.pal"), "-o", folder.path(), "--depfile",
                      folder.file("d"), "--depfile-target", "touch.hpp", "--depfile-folder", "/some where"});
  REQUIRE(run.status == ExitStatus::all_hold);
  const std::string rule = content(folder.file("d"));
  CHECK(rule.starts_with("touch.hpp: \\\n  /some\\ where/" + relative + " \\\n  /"));
  CHECK(rule.find("/a\\ cell.pal \\\n  /some\\ where/") != std::string::npos);
}

TEST_CASE("a plug-in has what its skill declares, if that fits the skill") {
  const Folder folder("declared");
  fs::create_directories(folder.path());
  const std::string file = folder.file("touch.declared");
  const auto generate = [&](const std::string& text) {
    std::ofstream(file) << text;
    return pal::test::pal({"generate", touch, "-e", cell, "-o", folder.file("out"), "--allow-failing",
                           "--plugin", "--declared", file, "--depfile", folder.file("d")});
  };
  const std::string text = "longest 0: reach / approach-speed + 2\nlimit fz of force: target -threshold\n";
  CHECK(generate(text).status == ExitStatus::all_hold);
  const std::string plugin = content(folder.file("out") + "/touch_plugin.cpp");
  CHECK(plugin.find("\"longest 0: reach / approach-speed + 2\\n\"") != std::string::npos);
  CHECK(plugin.find("\"" + file + "\", pal::skills::sources}") != std::string::npos);
  CHECK(content(folder.file("d")).find("touch.declared") != std::string::npos);

  fs::remove_all(folder.file("out"));
  const Answer form = generate(text + "longest 1\n");
  CHECK(form.status == ExitStatus::wrong_specification);
  CHECK(form.err.find("touch.declared:3: a line is written as") != std::string::npos);
  const Answer fit = generate("\nlongest 7: 2\n");
  CHECK(fit.status == ExitStatus::wrong_specification);
  CHECK(fit.err.find("touch.declared:2: touch has no completion 7") != std::string::npos);
  fs::remove(file);
  const Answer none = pal::test::pal({"generate", touch, "-e", cell, "-o", folder.file("out"),
                                      "--allow-failing", "--plugin", "--declared", file});
  CHECK(none.status == ExitStatus::usage);
  CHECK(none.err.find("cannot read '" + file) != std::string::npos);
  CHECK_FALSE(fs::exists(folder.file("out")));
}

TEST_CASE("the class of a module has the module's name, also beside a message of that name") {
  const Folder folder("force");
  fs::create_directories(folder.path());
  std::ofstream(folder.file("s.pal")) << R"(
DEVICE scale
MESSAGE force : REAL N
SKILL press
  SENSOR DRIVER Force
  SKILL METHOD SM1
  LOGICAL SENSOR LS1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
END SKILL
Sensor Driver: Force
  ACTIVITY filter WRITES force
BEGIN
  REPEAT
    WTM( request force from LS1 )
    TXM( request force from scale )
    WTM( force from scale )
    filter
    TXM( force to LS1 )
  UNTIL( forever )
END
Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request force from SM1 )
    TXM( request force from Force )
    WTM( force from Force )
    TXM( force to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  TXM( request force from LS1 )
  WTM( force from LS1 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P
  DEVICE scale ON REQUEST 5 TO 6 ms
  PLACE Force ON P PRIORITY 3
  PLACE LS1   ON P PRIORITY 2
  PLACE SM1   ON P PRIORITY 1
  TIME filter : 1 ms
END ENVIRONMENT
)";
  const std::string out = folder.file("out");
  const Answer answer = pal::test::pal({"generate", folder.file("s.pal"), "-o", out, "--allow-failing"});
  INFO(answer.err);
  std::string all;
  for (const auto& file : fs::directory_iterator(out)) all += content(file.path().string());
  CHECK(all.find("ForceActivities") != std::string::npos);
  CHECK(all.find("Force2Activities") == std::string::npos);
  // The class of a device that answers each request knows when it works.
  CHECK(all.find("class ScaleDevice : public runtime::ServingDevice") != std::string::npos);
}

TEST_CASE("the chart of a long run tells its story in short, as the finding does") {
  const Folder folder("long");
  fs::create_directories(folder.path());
  std::string ticks;
  for (int n = 0; n < 120; ++n) ticks += "  WTM( tick from Clock )\n";
  std::ofstream(folder.file("rounds.pal")) << R"(
DEVICE clock
MESSAGE tick : SIGNAL
SKILL rounds
  MACHINE CONTROLLER Clock
  SKILL METHOD Rounds
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT soon : DURATION TO COMPLETION 0 AT MOST 2 s
END SKILL
Machine Controller: Clock
BEGIN
  REPEAT
    WTM( tick from clock )
    TXM( tick to Rounds )
  UNTIL( forever )
END
Skill Module: Rounds
BEGIN
  WTM( Coordinator )
)" << ticks << R"(  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P
  DEVICE clock EVENT tick EVERY 5 ms
  PLACE Clock  ON P PRIORITY 2
  PLACE Rounds ON P PRIORITY 1
  COST SEND 0.1 ms
END ENVIRONMENT
)";
  const Answer answer =
      pal::test::pal({"atc", folder.file("rounds.pal"), "-r", "soon", "-o", folder.file("soon.svg")});
  INFO(answer.err);
  REQUIRE(answer.status == ExitStatus::all_hold);
  const std::string picture = content(folder.file("soon.svg"));
  CHECK(picture.find(" more, one after the other") != std::string::npos);
  // Its height in pixels.
  const auto height = picture.find("height=\"");
  CHECK(std::stoi(picture.substr(height + 8)) < 2'000);
}

TEST_CASE("atc says so if its search ends before there is a run") {
  const std::string nowhere = (std::filesystem::temp_directory_path() / own_name("no_run")).string();
  const Answer drawn = pal::test::pal({"atc", touch, "-e", cell, "-o", nowhere, "--timeout", "1ns"});
  CHECK(drawn.status == ExitStatus::not_met);
  CHECK(drawn.err.find("ended the search before there was a run to draw") != std::string::npos);
  const Answer made = pal::test::pal({"simulate", touch, "-e", cell, "--trace", nowhere, "--timeout", "1ns"});
  CHECK(made.status == ExitStatus::not_met);
  CHECK_FALSE(std::filesystem::exists(nowhere));
}

TEST_CASE("the chart of a missing response shows the unanswered event") {
  const std::string picture = (std::filesystem::temp_directory_path() / own_name("passed_over.svg")).string();
  const pal::MemoryFileSystem files = in_memory(text_of("passed_over"));
  CHECK(pal::test::pal({"atc", "s.pal", "-o", picture}, files).status == ExitStatus::all_hold);
  std::stringstream drawn;
  drawn << std::ifstream(picture).rdbuf();
  CHECK(drawn.str().find("an event has no response in this run, limit 50 ms") != std::string::npos);
  CHECK(drawn.str().find("tick without a response 12 ms") != std::string::npos);
  CHECK(drawn.str().find("response to tick") == std::string::npos);
  std::filesystem::remove(picture);
}

TEST_CASE("a value that is not a time is drawn in its own unit, or not at all") {
  const pal::MemoryFileSystem files = in_memory(text_of("skipped_frames"));
  const Folder folder("numbers");
  const std::string picture = folder.file("s.svg");
  const auto draw = [&](const std::string& requirement) {
    return pal::test::pal({"atc", "s.pal", "-r", requirement, "-o", picture}, files);
  };
  CHECK(draw("skipped").status == ExitStatus::all_hold);
  CHECK(content(picture).find("worst case 2 lost (exact: by 234 ms), limit 1, 1 too much") !=
        std::string::npos);
  CHECK(draw("apart").status == ExitStatus::all_hold);
  CHECK(content(picture).find("limit 1 ms, margin 155 ms") != std::string::npos);
  const Answer refused = draw("busy");
  CHECK(refused.status == ExitStatus::usage);
  CHECK(refused.err.find("'busy' has no run to draw") != std::string::npos);
  // The first that fails and has a run.
  CHECK(pal::test::pal({"atc", "s.pal", "-o", picture}, files).status == ExitStatus::all_hold);
  CHECK(content(picture).find("skipped fails") != std::string::npos);
}
