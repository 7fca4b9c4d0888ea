#include <catch2/catch.hpp>
#include <sstream>

#include "sim/random.hpp"
#include "tests/unit/sim/val_support.hpp"

using namespace pal::sim;
using namespace pal::sim::val;
using namespace pal::sim::val::test;

namespace {

constexpr const char* where_at_start = "    X        Y        Z        O        A        T\r\n";

double x_of(Bench& bench, const std::string& name) {
  return figures_of(bench.machine.store.locations.at(name))[0];
}

}  // namespace

TEST_CASE("VAL: a prompt, an echo, an answer") {
  Bench bench;
  CHECK(bench.type("\r") == "\r\n.");
  CHECK(bench.type("speed 50\r") == "speed 50\r\n.");
  CHECK(bench.machine.monitor_speed == 50);
  // A line feed ends a line as well, and means nothing after a Return.
  CHECK(bench.type("SPEED 30\r\nSPEED 40\n") == "SPEED 30\r\nSPEED 40\r\n..");
  CHECK(bench.machine.monitor_speed == 40);
  CHECK(bench.ask("BEGONE") == "*Unknown command* BEGONE\r\n");
  CHECK(bench.ask("12") == "*Unknown command*\r\n");
  CHECK(bench.ask("DO") == "*Missing instruction*\r\n");
  CHECK(bench.ask("DO BEGONE") == "*Unknown instruction* BEGONE\r\n");
}

TEST_CASE("VAL: the echo takes its time on the line") {
  Bench bench;
  bench.type("SP", 1100us);  // two characters take 2.08 ms at 9600 baud
  bench.timeline.advance_to(bench.timeline.now() + 900us);
  CHECK(bench.seen.empty());
  bench.timeline.advance_to(bench.timeline.now() + 2300us);
  CHECK(bench.seen == "SP");
}

TEST_CASE("VAL: keys that take back what was typed") {
  Bench bench;
  CHECK(bench.type("SPEX\bED 6\x7f"
                   "7\r") == "SPEX\b \bED 6\b \b7\r\n.");
  CHECK(bench.machine.monitor_speed == 100 - 93);
  CHECK(bench.type("\b\x7f") == "");
  CHECK(bench.type("DO RUBBISH\x15SPEED 8\r") == "DO RUBBISH^U\r\nSPEED 8\r\n.");
  CHECK(bench.machine.monitor_speed == 8);
  CHECK(bench.type("\xff\x01\tSPEED\t9\r") == " SPEED 9\r\n.");
  CHECK(bench.machine.monitor_speed == 9);
  const std::string much(200, 'X');
  CHECK(bench.type(much + "\r").find(std::string(128, 'X') + '\a') == 0);
}

TEST_CASE("VAL: WHERE has its figures in lines 3 and 5, and five line feeds") {
  Bench bench;
  const std::string answer = bench.type("WHERE\r");
  CHECK(answer.find(std::string("WHERE\r\n") + where_at_start) == 0);
  std::vector<std::string> lines;
  std::istringstream in(answer);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  REQUIRE(lines.size() == 6);
  CHECK(lines[5] == ".");
  std::istringstream pose(lines[2]), joints(lines[4]);
  const Figures wanted = figures_of(tool_pose(PlainArm::start(), Pose::Identity()));
  for (std::size_t i = 0; i < 6; ++i) {
    double shown = 0, angle = 0;
    REQUIRE(pose >> shown);
    REQUIRE(joints >> angle);
    CHECK(shown == Approx(wanted[i]).margin(i < 3 ? 0.0051 : 0.00051));
    CHECK(angle == Approx(val_joints(PlainArm::start())[i]).margin(0.00051));
  }
}

TEST_CASE("VAL: DO answers when the motion is over") {
  Bench bench;
  CHECK(bench.ask("DO HERE start") == "");
  CHECK(bench.ask("DO SET there = SHIFT(start BY 0, 100, 0)") == "");
  CHECK(bench.ask("SPEED 20") == "");  // 0.1 m/s: 1.1 s
  CHECK(bench.type("DO MOVES there\r", 1s) == "DO MOVES there\r\n");
  CHECK(bench.type("", 300ms) == ".");
  bench.ask("DO HERE now");
  CHECK((bench.machine.store.locations["NOW"].matrix() - bench.machine.store.locations["THERE"].matrix())
            .norm() < 1e-9);
  // The rest of the motions, each back and forth.
  const Pose start = bench.machine.store.locations["START"];
  const auto there = [&] { return bench.machine.here(bench.arm.joints()); };
  const auto is = [&](const Pose& pose) { return (there().matrix() - pose.matrix()).norm() < 1e-8; };
  CHECK(bench.ask("DO MOVE start") == "");
  CHECK(is(start));
  CHECK(bench.ask("DO APPRO start 50") == "");
  CHECK(is(start * Eigen::Translation3d(0, 0, -0.05)));
  CHECK(bench.ask("DO APPROS start, 20") == "");
  CHECK(is(start * Eigen::Translation3d(0, 0, -0.02)));
  CHECK(bench.ask("DO APPROX start 30") == "");
  CHECK(is(start * Eigen::Translation3d(0, 0, -0.03)));
  CHECK(bench.ask("DO DEPART 10") == "");
  CHECK(is(start * Eigen::Translation3d(0, 0, -0.04)));
  CHECK(bench.ask("DO DEPARTS -40") == "");
  CHECK(is(start));
  CHECK(bench.ask("DO SET step=TRANS(0,0,-15,90,-90,0)") == "");
  CHECK(bench.ask("DO MOVE HERE:step") == "");
  CHECK(is(start * Eigen::Translation3d(0, 0, -0.015)));
  CHECK(bench.ask("DO MOVES start:step:step") == "");
  CHECK(is(start * Eigen::Translation3d(0, 0, -0.030)));
  const double before = bench.arm.joints()[5];
  CHECK(bench.ask("DO DRI 6, -10, 50") == "");
  CHECK(degrees(bench.arm.joints()[5] - before) == Approx(-10));
}

TEST_CASE("VAL: speeds are per cent, or mm/s in a program") {
  Bench bench;
  bench.ask("DO HERE a");
  bench.ask("DO SET b=SHIFT(a BY 0,100,0)");
  const auto seconds = [&](const std::string& to) {
    const auto begin = bench.timeline.now();
    bench.type("DO MOVES " + to + "\r", 40ms);
    while (!bench.arm.at_rest()) bench.timeline.advance_to(bench.timeline.now() + 1ms);
    const double taken = std::chrono::duration<double>(bench.timeline.now() - begin).count();
    bench.type("", 1s);
    return taken;
  };
  bench.ask("DO SPEED 50 MMPS ALWAYS");
  CHECK(seconds("b") == Approx(2.05).margin(0.05));
  bench.ask("SPEED 50");
  CHECK(seconds("a") == Approx(4.03).margin(0.05));
  bench.ask("DO SPEED 100 MMPS");  // the next motion only
  CHECK(seconds("b") == Approx(2.05).margin(0.05));
  CHECK(seconds("a") == Approx(4.03).margin(0.05));
  for (const char* wrong : {"SPEED 0", "SPEED 101", "SPEED -5"})
    CHECK(bench.ask(wrong) == "*Illegal speed* above 0 to 100 is wanted\r\n");
  CHECK(bench.ask("SPEED") == "*Missing number*\r\n");
  CHECK(bench.ask("DO SPEED 501 MMPS") == "*Illegal speed* above 0 to 500 is wanted\r\n");
}

TEST_CASE("VAL: motions that cannot be made are refused and nothing moves") {
  Bench bench;
  const Joints before = bench.arm.joints();
  CHECK(bench.ask("DO MOVE nowhere") == "*Undefined value* NOWHERE\r\n");
  CHECK(bench.ask("DO MOVE TRANS(2000,0,0)") == "*Location too far*\r\n");
  CHECK(bench.ask("DO MOVE TRANS(10,0,200,90,90,0)") == "*Location too close*\r\n");
  CHECK(bench.ask("DO DRIVE 3, 200, 50") == "*Joint out of range* Jt 3\r\n");
  CHECK(bench.ask("DO DRIVE 7, 1, 50") == "*Illegal value* 1 to 6 is wanted\r\n");
  CHECK(bench.ask("DO DRIVE 1,5, 10, 50") == "*Syntax error* not understood from ', 50' on\r\n");
  CHECK(bench.ask("DO DRIVE 1.5, 10, 50") == "*Illegal value* a whole number is wanted\r\n");
  CHECK(bench.ask("DO DRIVE 1, 10, 0") == "*Illegal speed* above 0 to 100 is wanted\r\n");
  CHECK(bench.ask("DO MOVE here now") == "*Syntax error* not understood from 'NOW' on\r\n");
  CHECK(bench.ask("DO APPRO here") == "*Missing number*\r\n");
  CHECK((bench.arm.joints() - before).norm() == 0);
}

TEST_CASE("VAL: the configuration changes with MOVE, not along a straight line") {
  Bench bench;
  bench.ask("DO DRIVE 4, 70, 100");  // joint 4 has half a turn to go back then
  bench.ask("DO HERE a");
  const Configuration before = configuration_of(bench.arm.joints());
  CHECK(bench.ask(before.flip ? "DO NOFLIP" : "DO FLIP") == "");
  CHECK(bench.ask("DO MOVES a") == "*Configuration* no straight line changes it, use MOVE\r\n");
  CHECK(bench.ask("DO MOVE a") == "");
  CHECK(configuration_of(bench.arm.joints()).flip != before.flip);
  CHECK(configuration_of(bench.arm.joints()).righty == before.righty);
  CHECK(
      (bench.machine.here(bench.arm.joints()).matrix() - bench.machine.store.locations["A"].matrix()).norm() <
      1e-8);
  CHECK(bench.ask("DO READY") == "");
  CHECK(bench.ask("STATUS").find("above") != std::string::npos);
}

TEST_CASE("VAL: BASE and TOOL move what locations mean") {
  Bench bench;
  bench.ask("DO HERE a");
  const double x = x_of(bench, "A");
  CHECK(bench.ask("BASE 100, 0, 0, 0") == "");
  bench.ask("DO HERE b");
  CHECK(x_of(bench, "B") == Approx(x - 100));
  CHECK(bench.ask("BASE") == "");
  CHECK(bench.ask("BASE 0,0,0,90") == "");
  bench.ask("DO HERE c");
  CHECK(figures_of(bench.machine.store.locations["C"])[1] == Approx(-x));
  CHECK(bench.ask("BASE") == "");
  CHECK(bench.ask("DO SET seam = TRANS(49,0,397,90,-90,0)") == "");
  CHECK(bench.ask("TOOL seam") == "");
  bench.ask("DO HERE d");
  const Pose moved = bench.machine.store.locations["A"].inverse() * bench.machine.store.locations["D"];
  CHECK((moved.translation() - Eigen::Vector3d(0.049, 0, 0.397)).norm() < 1e-9);
  CHECK(bench.ask("TOOL") == "");
  bench.ask("DO HERE e");
  CHECK((bench.machine.store.locations["A"].matrix() - bench.machine.store.locations["E"].matrix()).norm() <
        1e-12);
}

TEST_CASE("VAL: POINT shows a location, asks, and takes changes until an empty line") {
  Bench bench;
  bench.ask("DO SET corner = TRANS(1,2,3,90,-90,0)");
  CHECK(bench.type("POINT corner\r") ==
        "POINT corner\r\n"
        "  X/JT1    Y/JT2    Z/JT3    O/JT4    A/JT5    T/JT6\r\n"
        "     1.00     2.00     3.00   90.000  -90.000    0.000\r\n"
        "Change? ");
  CHECK(bench.type("10,,-4.5\r") ==
        "10,,-4.5\r\n"
        "  X/JT1    Y/JT2    Z/JT3    O/JT4    A/JT5    T/JT6\r\n"
        "    10.00     2.00    -4.50   90.000  -90.000    0.000\r\n"
        "Change? ");
  CHECK(bench.type("1,2,wrong\r").find("*Syntax error* not understood from 'WRONG' on\r\n") !=
        std::string::npos);
  CHECK(bench.type("\r") == "\r\n.");
  CHECK(figures_of(bench.machine.store.locations["CORNER"])[2] == Approx(-4.5));
  // What is not defined says so; figures define it.
  CHECK(bench.type("POINT fresh\r").find("*Undefined value*") != std::string::npos);
  CHECK(bench.type("\r") == "\r\n.");
  CHECK_FALSE(bench.machine.store.locations.contains("FRESH"));
  bench.type("POINT fresh\r");
  bench.type("7\r");
  CHECK(bench.type("\r") == "\r\n.");
  CHECK(x_of(bench, "FRESH") == Approx(7));
  // ABORT and Control-C leave the question, too.
  bench.type("POINT fresh\r");
  CHECK(bench.type("ABORT\r") == "ABORT\r\n.");
  bench.type("POINT fresh\r");
  CHECK(bench.type("8\x03") == "8^C\r\n.");
  CHECK(x_of(bench, "FRESH") == Approx(7));
}

TEST_CASE("VAL: DELAY, the hand, numbers") {
  Bench bench;
  CHECK(bench.type("DO DELAY 2\r", 1900ms) == "DO DELAY 2\r\n");
  CHECK(bench.type("", 200ms) == ".");
  CHECK(bench.ask("DO DELAY -1") == "*Illegal value* 0 to 3600 is wanted\r\n");
  CHECK(bench.type("DO OPENI\r", 290ms) == "DO OPENI\r\n");
  CHECK(bench.type("", 100ms) == ".");
  CHECK(bench.hand.is_open);
  CHECK(bench.ask("DO CLOSEI") == "");
  CHECK_FALSE(bench.hand.is_open);
  CHECK(bench.ask("DO MODE3 = 5") == "");
  CHECK(bench.machine.store.reals["MODE3"] == 5);
  CHECK(bench.ask("DO TYPE mode3") == "5\r\n");
  CHECK(bench.ask("LISTR") == "MODE3                5\r\n");
  bench.machine.hand = nullptr;
  CHECK(bench.ask("DO OPENI") == "*No hand*\r\n");
}

TEST_CASE("VAL: a program runs beside the monitor") {
  Bench bench;
  bench.ask("DO HERE a");
  bench.machine.store.programs["PROG1"] = {"MOVES SHIFT(a BY 0,50,0)", "MOVES a"};
  CHECK(bench.type("EXECUTE PROG1,2\r", 100ms) == "EXECUTE PROG1,2\r\n.");
  CHECK(bench.ask("STATUS", 200ms).find("PROG1 runs, step 1") != std::string::npos);
  CHECK(bench.ask("DO MOVES a", 100ms) == "*Arm is a program's*\r\n");
  CHECK(bench.ask("EXECUTE PROG1", 100ms) == "*Program is running* PROG1\r\n");
  CHECK(bench.type("", 20s) == "\r\nProgram PROG1 completed\r\n.");
  CHECK(
      (bench.machine.here(bench.arm.joints()).matrix() - bench.machine.store.locations["A"].matrix()).norm() <
      1e-8);
  CHECK(bench.ask("EXECUTE PROG9") == "*Undefined program* PROG9\r\n");
  CHECK(bench.ask("EXECUTE PROG1,1.5") == "*Illegal value* a whole number is wanted\r\n");
  // One that goes wrong says where, when nothing is being typed.
  bench.machine.store.programs["PROG2"] = {"TYPE 5", "DELAY 0.1", "MOVE nowhere"};
  CHECK(bench.type("EXECUTE PROG2\r", 60ms) == "EXECUTE PROG2\r\n.\r\nProgram PROG2: 5\r\n.");
  CHECK(bench.type("SPEED 10", 1s) == "SPEED 10");
  CHECK(bench.type("\r", 1s) == "\r\n.\r\nProgram PROG2 stopped at step 3: *Undefined value* NOWHERE\r\n.");
}

TEST_CASE("VAL: a program is typed, changed and run") {
  Bench bench;
  CHECK(bench.type("EDIT PROG1\r") == "EDIT PROG1\r\n .PROGRAM PROG1\r\n   1? ");
  CHECK(bench.type("do nothing\r") == "do nothing\r\n   2? ");
  CHECK(bench.type("COUNT = COUNT + 1\r") == "COUNT = COUNT + 1\r\n   3? ");
  CHECK(bench.type("TYPE 5\r") == "TYPE 5\r\n   4? ");
  CHECK(bench.type("E\r") == "E\r\n.");
  CHECK(bench.machine.store.programs.at("PROG1") ==
        std::vector<std::string>{"do nothing", "COUNT = COUNT + 1", "TYPE 5"});
  // The first step is deleted, the second stays, one is put before the third, which is replaced.
  CHECK(bench.type("EDIT PROG1\r") == "EDIT PROG1\r\n .PROGRAM PROG1\r\n   1  do nothing\r\n   1? ");
  CHECK(bench.type("D\r") == "D\r\n   1  COUNT = COUNT + 1\r\n   1? ");
  CHECK(bench.type("\r") == "\r\n   2  TYPE 5\r\n   2? ");
  CHECK(bench.type("I DELAY 0.01\r") == "I DELAY 0.01\r\n   3  TYPE 5\r\n   3? ");
  CHECK(bench.type("TYPE 6\r") == "TYPE 6\r\n   4? ");
  CHECK(bench.type("\x03") == "^C\r\n.");
  CHECK(bench.machine.store.programs.at("PROG1") ==
        std::vector<std::string>{"COUNT = COUNT + 1", "DELAY 0.01", "TYPE 6"});
  bench.machine.store.programs["PROG1"].erase(bench.machine.store.programs["PROG1"].begin());
  CHECK(bench.type("EXECUTE PROG1,2\r", 300ms).find("Program PROG1: 6") != std::string::npos);
  // A program without steps is none; ABORT leaves the editor.
  bench.type("EDIT PROG2\r");
  CHECK(bench.type("ABORT\r") == "ABORT\r\n.");
  CHECK(bench.ask("EXECUTE PROG2") == "*Undefined program* PROG2\r\n");
}

TEST_CASE("VAL: ALTER that ends by itself is told behind a prompt") {
  Bench bench;
  bench.seen.clear();
  bench.terminal.monitor().alter_ended("got no correction within 2.4 ms");
  bench.timeline.advance_to(bench.timeline.now() + 1s);
  CHECK(bench.seen == "\r\n*ALTER ended* got no correction within 2,4 ms\r\n.");
}

TEST_CASE("VAL: ABORT stops the arm, the program and ALTER") {
  Bench bench;
  bench.ask("DO HERE a");
  bench.machine.store.programs["PROG1"] = {"MOVES SHIFT(a BY 0,50,0)", "MOVES a"};
  bench.type("EXECUTE PROG1,-1\r", 300ms);
  CHECK(bench.ask("ABORT") == "Stopped PROG1 at step 1\r\n");
  CHECK(bench.arm.at_rest());
  CHECK_FALSE(bench.machine.attached);
  CHECK(bench.ask("PCABORT") == "");
  // During DO: its answer is an error, then ABORT has its own.
  CHECK(bench.type("DO MOVES SHIFT(a BY 0,200,0)\r", 400ms) == "DO MOVES SHIFT(a BY 0,200,0)\r\n");
  CHECK(bench.type("ABORT\r", 2s) == "ABORT\r\n*Aborted*\r\n..");
  CHECK(bench.arm.at_rest());
  bench.type("DO DELAY 100\r", 400ms);
  CHECK(bench.type("\x03", 100ms) == "^C\r\n*Aborted*\r\n.");
  bench.ask("DO ALTER(3)");
  bench.ask("ABORT");
  CHECK_FALSE(bench.alter.opened);
}

TEST_CASE("VAL: lines that are typed ahead wait their turn") {
  Bench bench;
  CHECK(bench.type("DO DELAY 1\rSPEED 11\rSPEED 12\r", 900ms) == "DO DELAY 1\r\nSPEED 11\r\nSPEED 12\r\n");
  CHECK(bench.machine.monitor_speed == 100);
  CHECK(bench.type("", 300ms) == "...");
  CHECK(bench.machine.monitor_speed == 12);
}

TEST_CASE("VAL: ALTER is opened and closed by instructions") {
  Bench bench;
  CHECK(bench.ask("DO ALTER(1)") == "");
  CHECK(bench.alter.opened);
  CHECK(bench.alter.mode == AlterMode{.world = false, .cumulative = true});
  CHECK(bench.ask("DO MOVES HERE") == "*ALTER is open*\r\n");
  CHECK(bench.ask("TOOL") == "");  // the arm stands still
  CHECK(bench.ask("DO NOALTER") == "");
  CHECK_FALSE(bench.alter.opened);
  CHECK(bench.ask("DO ALTER(-1,18)") == "");
  CHECK(bench.alter.mode == AlterMode{.world = true, .cumulative = false});
  bench.alter.trouble = "no answer within 20.0 ms";
  CHECK(bench.ask("DO NOALTER") == "*ALTER* no answer within 20,0 ms\r\n");
  CHECK(bench.ask("DO ALTER(8)") ==
        "*Illegal value* a mode is the sum of 1 (cumulative), 2 (world), 4 (joints) and 16\r\n");
  bench.machine.alter = nullptr;
  CHECK(bench.ask("DO ALTER(1)") == "*No ALTER port*\r\n");
}

TEST_CASE("VAL: a fault of the arm ends what moves, and stays until CALIBRATE") {
  Bench bench;
  bench.ask("DO HERE a");
  bench.type("DO MOVES SHIFT(a BY 0,200,0)\r", 400ms);
  bench.arm.break_down("the forearm hit post 2.");
  CHECK(bench.type("", 100ms) == "*Arm fault* the forearm hit post 2,\r\n.");
  CHECK(bench.ask("DO MOVE a") == "*Arm fault* the forearm hit post 2,\r\n");
  CHECK(bench.ask("WHERE").starts_with(where_at_start));
  CHECK(bench.ask("CALIBRATE") == "");
  CHECK(bench.ask("DO MOVE a") == "");
}

TEST_CASE("VAL: lists, forgetting, help") {
  Bench bench;
  bench.ask("DO SET a = TRANS(1,2,3,90,-90,0)");
  CHECK(bench.ask("LISTL") ==
        "A                        1.00     2.00     3.00   90.000  -90.000    0.000\r\n");
  CHECK(bench.ask("DELETEL a") == "");
  CHECK(bench.ask("DELETEL a") == "*Undefined value* A\r\n");
  bench.machine.store.programs["P"] = {"MOVE a"};
  CHECK(bench.ask("LISTP") == " .PROGRAM P\r\n   1  MOVE a\r\n .END\r\n");
  CHECK(bench.ask("HELP").find("CALIBRATE") != std::string::npos);
  CHECK(bench.ask("DO SET averyveryverylongname1 = NULL") == "*Name too long* AVERYVERYVERYLONGNAME1\r\n");
}

TEST_CASE("VAL: every line is answered, and ABORT brings back the prompt") {
  constexpr std::uint64_t seed = 11;
  INFO("seed " << seed);
  Random random(seed, 0);
  const std::vector<std::string> words{
      "DO",   "MOVE", "MOVES", "APPRO",   "DEPART",  "DRI",   "SET",   "SPEED", "POINT", "HERE",    "WHERE",
      "TOOL", "BASE", "ALTER", "NOALTER", "EXECUTE", "ABORT", "TRANS", "SHIFT", "BY",    "INVERSE", "NULL",
      "A",    "B",    "PROG1", "(",       ")",       ",",     ":",     "=",     "1",     "-7.5",    "300",
      "1e3",  ".",    "*",     "?",       "\x03",    "\x15",  "\x7f",  "\xff",  "MODE1", "LISTL"};
  Bench bench;
  bench.machine.store.programs["PROG1"] = {"MOVES A", "TYPE MODE1", "DELAY 1"};
  for (int i = 0; i < 600; ++i) {
    std::string line = i % 2 == 0 ? "DO" : "";
    for (auto n = 1 + static_cast<int>(6 * random.unit()); n > 0; --n)
      line += " " + words[static_cast<std::size_t>(random.unit() * static_cast<double>(words.size()))];
    CAPTURE(line);
    bench.type(line + "\r", 2s);
    const std::string answer = bench.type("ABORT\r", 3s);
    REQUIRE(answer.ends_with("."));
  }
}
