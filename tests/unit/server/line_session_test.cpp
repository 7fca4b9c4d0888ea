// The lines of the thesis: '#' and a code, '!' and 50 characters, '>' and six numbers.
#include "tests/unit/server/session_support.hpp"

using namespace pal;
using namespace pal::server;
using Said = std::vector<std::string>;

namespace {

struct Line : test::SessionFixture {
  Line() : SessionFixture(line_session) {}
  void enter() { REQUIRE(say("token secret\r") == Said{"#0\r\n"}); }
};

std::string complaint(const std::string& text) {
  return "!" + text + std::string(50 - text.size(), ' ') + "\r\n";
}

}  // namespace

TEST_CASE("nothing moves without the token") {
  Line line;
  const std::string before =
      GENERATE("quick 0", "run", "stop", "token wrong", "token", "token secre", "token secrets");
  line.say(before + "\r");
  CHECK(line.hung_up);
  CHECK_FALSE(line.session->admitted());
  CHECK_FALSE(line.desk.work());
  CHECK(line.cell.runs == 0);
}

TEST_CASE("a skill is a line, its completion code the answer") {
  Line line;
  line.enter();
  CHECK(line.say("quick 3\r").empty());
  CHECK(line.work() == Said{"#3\r\n"});
  CHECK(line.say("quick code=4\n").empty());
  CHECK(line.work() == Said{"#4\r\n"});
  CHECK(line.say("quick\r\n").empty());
  CHECK(line.work() == Said{"#0\r\n"});
  CHECK(line.say("why\r") == Said{"=as told\r\n"});
  for (const char byte : std::string("quick 2\r")) line.session->take({&byte, 1});
  CHECK(line.work() == Said{"#2\r\n"});
}

TEST_CASE("a line that is wrong moves nothing and says why in 50 characters") {
  Line line;
  line.enter();
  CHECK(line.say("rub 1\r") == Said{complaint("no skill or command 'rub'")});
  CHECK(line.say("quick x\r") == Said{complaint("'x' is no value of code")});
  CHECK(line.say("quick 1 2\r") == Said{complaint("quick has 1 parameters")});
  CHECK(line.say("quick speed=1\r") == Said{complaint("quick has no parameter 'speed'")});
  CHECK(line.say("quick 99\r").front().size() == 53);
  CHECK(line.say(std::string(5000, 'x') + "\r").front().rfind("!a line has at most", 0) == 0);
  CHECK(line.say("\r\n\r\n").empty());
  CHECK_FALSE(line.desk.work());
}

TEST_CASE("an operation is loaded as lines, and answers when it halts") {
  Line line;
  line.enter();
  CHECK(line.say("load o\r").empty());
  CHECK(line.say(std::string(test::endless) + "\r").empty());
  CHECK(line.say(".\r") == Said{"#0\r\n"});
  CHECK(line.say("step\r").empty());
  CHECK(line.work() == Said{complaint("paused before a")});
  CHECK(line.say("set a code 5\r") == Said{"#0\r\n"});
  CHECK(line.say("run\r").empty());
  CHECK(line.work() == Said{"#5\r\n"});
  CHECK(line.say("state\r") == Said{"=idle endless ended at end code 5 steps 2 controls a line\r\n"});
  CHECK(line.say("resume\r") == Said{complaint("the operation is ended, neither paused nor stopped")});
}

TEST_CASE("forces are six numbers of eight characters, while they are wanted") {
  Line line;
  line.enter();
  auto telemetry = std::make_shared<Telemetry>();
  telemetry->force = {1.25, -170, 0, 0.5, 0, -12345678};
  line.session->show(telemetry);
  CHECK(line.said == Said{"#0\r\n"});
  line.say("data on\r");
  line.said.clear();
  line.session->show(telemetry);
  REQUIRE(line.said.size() == 1);
  CHECK(line.said.front() == ">    1.25 -170.00    0.00    0.50    0.00-1234567\r\n");
}

TEST_CASE("the controls become free when their client goes") {
  Line line;
  line.enter();
  line.say("take\r");
  CHECK(line.desk.status(0).holder == "a line");
  line.session.reset();
  CHECK(line.desk.status(0).holder.empty());
}
