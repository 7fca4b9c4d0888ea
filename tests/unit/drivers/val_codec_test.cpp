#include <catch2/catch.hpp>

#include "runtime/drivers/val/codec.hpp"

using namespace pal::runtime::drivers;
using namespace pal::runtime::drivers::val;

namespace {

std::string line(Verb verb, std::array<double, 6> figures = {}, std::string location = {},
                 std::string second = {}) {
  const LineOf made = line_of({verb, std::move(location), std::move(second), figures});
  return made.problem.empty() ? made.line : "not sent: " + made.problem;
}

}  // namespace

TEST_CASE("VAL's lines as the thesis prints them") {
  CHECK(line(Verb::delay, {2}) == "DO DELAY 2");
  CHECK(line(Verb::open_hand) == "DO OPENI");
  CHECK(line(Verb::close_hand) == "DO CLOSEI");
  CHECK(line(Verb::speed, {50}) == "SPEED 50");
  CHECK(line(Verb::set, {}, "A", "B") == "DO SET A = B");
  CHECK(line(Verb::set_figures, {49, 0, 397, 90, -90, 0}, "SEAM") == "DO SET SEAM=TRANS(49,0,397,90,-90,0)");
  CHECK(line(Verb::shift, {1, -2, 3}, "A") == "DO SET A=SHIFT(A BY 1, -2, 3)");
  CHECK(line(Verb::drive, {6, -10, 50}) == "DO DRI 6, -10, 50");
  CHECK(line(Verb::depart, {50}) == "DO DEPART 50");
  CHECK(line(Verb::depart_straight, {50}) == "DO DEPARTS 50");
  CHECK(line(Verb::approach, {50}, "A") == "DO APPRO A 50");
  CHECK(line(Verb::approach_straight, {50}, "A") == "DO APPROS A 50");
  CHECK(line(Verb::where) == "WHERE");
  CHECK(line(Verb::move, {}, "A") == "DO MOVE A");
  CHECK(line(Verb::move_relative, {}, "A") == "DO MOVE HERE:A");
  CHECK(line(Verb::move_straight, {}, "A:B") == "DO MOVES A:B");
  CHECK(line(Verb::execute, {1, 3}) == "EXECUTE PROG1,3");
  CHECK(line(Verb::base, {1, 2, 3, 90}) == "BASE 1, 2, 3, 90");
  CHECK(line(Verb::tool, {}, "SEAM") == "TOOL SEAM");
  CHECK(line(Verb::here, {}, "A") == "DO HERE A");
  CHECK(line(Verb::mode, {2, 7}) == "DO MODE2 = 7");
  CHECK(line(Verb::abort) == "ABORT");
  CHECK(line(Verb::abort_process) == "PCABORT");
  CHECK(line(Verb::point, {}, "A") == "POINT A");
  CHECK(line(Verb::clear).empty());
}

TEST_CASE("VAL's lines that are ours") {
  CHECK(line(Verb::straight_to, {450.5, -200, 0.0004, 45.1234, 90, -0.0001}) ==
        "DO MOVES TRANS(450.5,-200,0,45.123,90,0)");
  CHECK(line(Verb::straight_relative, {}, "STEP") == "DO MOVES HERE:STEP");
  CHECK(line(Verb::straight_speed, {12.5}) == "DO SPEED 12.5 MMPS ALWAYS");
  CHECK(line(Verb::joint_speed, {100}) == "DO SPEED 100 ALWAYS");
  CHECK(line(Verb::open_alter, {3}) == "DO ALTER(3)");
  CHECK(line(Verb::close_alter) == "DO NOALTER");
  CHECK(line(Verb::calibrate) == "CALIBRATE");
  CHECK(line(Verb::configure, {}, "LEFTY") == "DO LEFTY");
  CHECK(line(Verb::ready) == "DO READY");
}

TEST_CASE("what no line can say is not sent") {
  CHECK(line(Verb::move) == "not sent: the name of a location is missing");
  CHECK(line(Verb::move, {}, "A\rABORT") == "not sent: 'A\rABORT' is no location's name");
  CHECK(line(Verb::drive, {1.5, 10, 50}) == "not sent: the joint is no whole number");
  CHECK(line(Verb::speed, {std::numeric_limits<double>::quiet_NaN()}) ==
        "not sent: a number is beyond 1000000");
  CHECK(line(static_cast<Verb>(99)) == "not sent: there is no verb 99");
}

TEST_CASE("VAL's answers") {
  CHECK(read_answer({Verb::move, "A", {}, {}}, "").ok);
  const auto error = [](const std::string& shown) {
    const Answer answer = read_answer({}, shown);
    return std::pair(answer.error, answer.text);
  };
  CHECK(error("*Joint out of range* Jt 3\r\n") ==
        std::pair(Error::unreachable, std::string("Joint out of range Jt 3")));
  CHECK(error("*Undefined value* PART\r\n") ==
        std::pair(Error::undefined, std::string("Undefined value PART")));
  CHECK(error("*Location too far*\r\n") == std::pair(Error::unreachable, std::string("Location too far")));
  CHECK(error("*Something new*\r\n") == std::pair(Error::refused, std::string("Something new")));
  CHECK(error("ABORT\r\n*Aborted*\r\n") == std::pair(Error::aborted, std::string("Aborted")));
  CHECK(error("*cut") == std::pair(Error::refused, std::string("cut")));

  const Answer where = read_answer({Verb::where, {}, {}, {}},
                                   "  X  Y\r\n 1.5 -2 3 90 -90 0.001\r\n JT1\r\n 10 20 30 40 50 -60\r\n");
  REQUIRE(where.ok);
  CHECK(where.values == std::array<double, 12>{1.5, -2, 3, 90, -90, 0.001, 10, 20, 30, 40, 50, -60});
  CHECK(read_answer({Verb::where, {}, {}, {}}, "  X  Y\r\n 1.5 -2 3 90 -9").error == Error::no_answer);
  CHECK(read_answer({Verb::where, {}, {}, {}}, "  X  Y\r\n 1 2 3 4 5 6 7\r\n\r\n1 2 3 4 5 6\r\n").error ==
        Error::no_answer);
  CHECK(answer_time({Verb::delay, {}, {}, {5}}, std::chrono::seconds(3), std::chrono::seconds(60)) ==
        std::chrono::seconds(8));
  CHECK(answer_time({Verb::delay, {}, {}, {500}}, std::chrono::seconds(3), std::chrono::seconds(60)) ==
        std::chrono::seconds(60));
}
