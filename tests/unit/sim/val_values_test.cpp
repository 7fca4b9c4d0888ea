#include <catch2/catch.hpp>

#include "sim/random.hpp"
#include "sim/val/error.hpp"
#include "sim/val/expression.hpp"
#include "sim/val/store.hpp"

using namespace pal::sim;
using namespace pal::sim::val;

namespace {

double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

std::string problem_of(const std::string& text) {
  Store store;
  store.locations["A"] = Pose::Identity();
  Line line(text);
  try {
    location(line, {store, Pose::Identity()});
    line.end();
  } catch (const Error& error) {
    return error.shown();
  }
  return "none";
}

}  // namespace

TEST_CASE("VAL: O, A and T") {
  // The tool of figure F.2: its angles turn nothing.
  CHECK(difference(pose_of({49, 0, 397, 90, -90, 0}), Pose(Eigen::Translation3d(0.049, 0, 0.397))) < 1e-12);
  // All zero: the tool points along -y.
  CHECK((pose_of({}).linear() * Eigen::Vector3d::UnitZ() + Eigen::Vector3d::UnitY()).norm() < 1e-12);
  // Straight down: A is 90 and T is 0.
  Pose down = Pose::Identity();
  down.linear() = Eigen::AngleAxisd(radians(180), Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Figures figures = figures_of(down);
  CHECK(figures[4] == Approx(90));
  CHECK(figures[5] == 0);
  CHECK(difference(pose_of(figures), down) < 1e-12);

  // All but straight down: the joints' last counts do not decide on what is shown.
  const Pose tilted = down * Eigen::AngleAxisd(1e-4, Eigen::Vector3d(1, 3, 0).normalized());
  CHECK(shown_figures(tilted)[5] == 0);
  CHECK(shown_figures(tilted)[3] == Approx(figures[3]).margin(0.01));

  constexpr std::uint64_t seed = 3;
  INFO("seed " << seed);
  Random random(seed, 0);
  for (int i = 0; i < 1000; ++i) {
    const auto angle = [&](double most) { return most * (2 * random.unit() - 1); };
    const Figures made{100 * random.unit(), -5, 7, angle(180), angle(i % 10 == 0 ? 90.0 : 89.9), angle(180)};
    REQUIRE(difference(pose_of(figures_of(pose_of(made))), pose_of(made)) < 1e-9);
    const Figures back = figures_of(pose_of(made));
    for (std::size_t j = 0; j < 6; ++j) REQUIRE(back[j] == Approx(made[j]).margin(1e-6));
  }
}

TEST_CASE("VAL: joint angles as the machine shows them") {
  Joints q = Joints::Zero();
  q[1] = radians(90);
  q[2] = radians(-90);
  CHECK(joint_columns(val_joints(q)) == "    0.000  -90.000   90.000    0.000    0.000    0.000");
  CHECK(columns({450, -200.004, -0.001, 90, -90, -0.0001}) ==
        "   450.00  -200.00     0.00   90.000  -90.000    0.000");
}

TEST_CASE("VAL: locations in expressions") {
  Store store;
  store.locations["A"] = pose_of({100, 0, 0, 90, -90, 0});
  store.locations["B"] = pose_of({0, 0, 50, 90, -90, 30});
  const Pose here(Eigen::Translation3d(0, 0, 1));
  const auto value = [&](const std::string& text) {
    Line line(text);
    const Pose pose = location(line, {store, here});
    line.end();
    return pose;
  };
  CHECK(difference(value("a:b"), store.locations["A"] * store.locations["B"]) < 1e-12);
  CHECK(difference(value(" HERE : a"), here * store.locations["A"]) < 1e-12);
  CHECK(difference(value("trans(100,0,0,90,-90)"), store.locations["A"]) < 1e-12);
  CHECK(difference(value("SHIFT(B BY 1.5, -2, +3)"),
                   Eigen::Translation3d(0.0015, -0.002, 0.003) * store.locations["B"]) < 1e-12);
  CHECK(difference(value("B:INVERSE(B):NULL"), Pose::Identity()) < 1e-12);

  CHECK(problem_of("C") == "*Undefined value* C");
  CHECK(problem_of("") == "*Missing location*");
  CHECK(problem_of("A:") == "*Missing location*");
  CHECK(problem_of("A B") == "*Syntax error* not understood from 'B' on");
  CHECK(problem_of("TRANS(1,2") == "*Syntax error* ')' is missing");
  CHECK(problem_of("TRANS(1,x)") == "*Undefined value* X");
  CHECK(problem_of("SHIFT(A 1,2,3)") == "*Syntax error* BY is missing");
  CHECK(problem_of("TRANS(1e9)") == "*Syntax error* ')' is missing");
  CHECK(problem_of("TRANS(123456789)") == "*Illegal value* beyond 1000000");
  CHECK(problem_of("TRANS(nan)") == "*Undefined value* NAN");
}

TEST_CASE("VAL: a store survives its file") {
  Store store;
  store.locations["PART"] = pose_of({450.1234, -200, -150.5, 12.34567, -80, 179});
  store.locations["DOWN"] = pose_of({0, 0, 0, 45, 90, 0});
  store.reals["MODE1"] = -2.5;
  store.programs["PROG1"] = {"MOVE PART", "MOVES PART:DOWN"};
  const std::string text = write_store(store);
  Store read;
  CHECK(read_store(text, read).empty());
  CHECK(write_store(read) == text);
  CHECK(difference(read.locations["PART"], store.locations["PART"]) < 1e-6);
  CHECK(read.programs == store.programs);
}

TEST_CASE("VAL: what is wrong with a file of locations, and in which line") {
  const auto problem = [](const std::string& text) {
    Store store;
    const auto problems = read_store(text, store);
    return problems.empty() ? "none" : std::to_string(problems[0].line) + ": " + problems[0].cause;
  };
  CHECK(problem("; nothing\n\n.LOCATIONS\r\n a 1 2 3 4 5 6 ; the corner\r\n.END\r\n") == "none");
  CHECK(problem("a 1 2 3 4 5 6") == "1: the line stands in no section (.LOCATIONS, .REALS or .PROGRAM)");
  CHECK(problem(".LOCATIONS\na 1 2 3 4 5\n.END") == "2: *a number is missing*");
  CHECK(problem(".LOCATIONS\na 1 2 3 4 5 6 7\n.END") == "2: *Syntax error* not understood from '7' on");
  CHECK(problem(".LOCATIONS\nhere 1 2 3 4 5 6\n.END") == "2: *Illegal name* HERE");
  CHECK(problem(".LOCATIONS\n") == "1: the section has no .END");
  CHECK(problem(".LOCATIONS\n.REALS\n") == "2: the section of line 1 has no .END");
  CHECK(problem(".LOCATION\n") == "1: no section is called '.LOCATION'");
  CHECK(problem(".END") == "1: .END closes no section");
  CHECK(problem(".PROGRAM\n") == "1: *Missing name*");
}
