#include "tests/support/nested_skill.hpp"

#include <algorithm>
#include <utility>

namespace pal::test {

std::string NestedSkill::at() {
  const auto& [in, statement] = said_[static_cast<std::size_t>(chance_(static_cast<int>(said_.size())))];
  return statement + " IN " + in;
}

std::string NestedSkill::requirements() {
  std::string out;
  int number = 0;
  const auto add = [&](const std::string& measure) {
    out += "  REQUIREMENT r" + std::to_string(number++) + " : " + measure + "\n";
  };
  const std::string most = " AT MOST 1 s";
  for (int i = 0; i < 4; ++i) {
    add("RESPONSE FROM tick OF robot TO " + at() + most);
    add("RESPONSE FROM tock OF hand TO " + at() + most);
    if (tack_) add("RESPONSE FROM tack OF foot TO " + at() + most);
    add("AGE OF c" + any_module() + " AT " + at() + most);
    add("AGE OF c" + any_module() + " AT " + at() + most);
    add("REACTION OF c" + any_module() + " AT " + at() + most);
    if (value_) add("AGE OF value FROM sensor AT " + at() + most);
    if (value_) add("REACTION OF value FROM sensor AT " + at() + most);
    if (tack_) add("REACTION OF tack FROM foot AT " + at() + most);
    add("AGE OF tick FROM robot AT " + at() + most);
    add("INTERVAL OF " + at() + most);
    add("INTERVAL OF " + at() + most);
    add("INTERVAL OF " + at() + " AT LEAST 1 ms");
  }
  for (const auto& [in, statement] : said_) {
    if (chance_(4) == 0) {
      // What a thread has read, at each of its statements.
      add("AGE OF c" + any_module() + " AT " + statement + " IN " + in + most);
    }
    if (statement.rfind("TXM( ", 0) != 0 || chance_(2) == 0) continue;
    const bool asks = statement.rfind("TXM( request", 0) == 0;
    add("RESPONSE FROM " + statement.substr(5, statement.find(asks ? " from " : " to ") - 5) + " OF " + in +
        " TO " + at() + most);
  }
  if (value_) add("LOSS OF sensor AT MOST 1 IN 3");
  add("LOSS OF robot NONE");
  if (tack_) add("LOSS OF foot NONE");
  for (const char* code : {"0", "1", "2"}) add("DURATION TO COMPLETION " + std::string(code) + most);
  add("LOAD OF EACH PROCESSOR AT MOST 90 %");
  add("BUSY PERIOD OF EACH PROCESSOR" + most);
  return out;
}

std::string NestedSkill::interval(int low, int high) {
  const int best = chance_.between(low, high);
  const int worst = chance_(2) != 0 ? best : chance_.between(best, high);
  return best == worst ? std::to_string(best) + " ms"
                       : std::to_string(best) + " TO " + std::to_string(worst) + " ms";
}

std::string NestedSkill::environment() {
  std::string out = "ENVIRONMENT cell\n";
  const int processors = chance_.between(1, 3);
  for (int p = 1; p <= processors; ++p)
    out += "  PROCESSOR P" + std::to_string(p) + (chance_(4) == 0 ? " NONPREEMPTIVE\n" : "\n");
  for (const Module& module : modules_) {
    out += "  PLACE " + module.name + " ON P" + std::to_string(chance_.between(1, processors)) +
           " PRIORITY " + std::to_string(chance_.between(1, 4)) + "\n";
    for (int i = 1; i <= 3; ++i)
      out +=
          "  TIME w" + std::to_string(i) + module.name + " : " + interval(chance_(4) == 0 ? 0 : 1, 2) + "\n";
    out += "  TIME p" + module.name + " : " + interval(10, 50) + "\n";
  }
  for (const std::string& block : blocks_) {
    if (chance_(2) == 0)
      out += "  PLACE " + block + " ON P" + std::to_string(chance_.between(1, processors)) + " PRIORITY " +
             std::to_string(chance_.between(1, 4)) + "\n";
  }
  if (chance_(3) == 0) {
    const int period = chance_.between(4, 12);
    out += "  DEVICE sensor FRAMES EVERY " + std::to_string(period) + " ms COLLECTING " +
           std::to_string(chance_.between(1, period)) + " ms\n";
  } else {
    out += "  DEVICE sensor ON REQUEST " + interval(chance_(4) == 0 ? 0 : 1, 4) + "\n";
  }
  const auto event = [&](const std::string& device, const std::string& message) {
    const int period = chance_(3) == 0 ? chance_.between(15, 40) : chance_.between(40, 150);
    out += "  DEVICE " + device + " EVENT " + message + (chance_(5) == 0 ? " SPORADIC " : " EVERY ") +
           std::to_string(period) + " ms";
    if (chance_(3) == 0) out += " JITTER " + std::to_string(chance_.between(1, period - 1)) + " ms";
    out += "\n";
  };
  event("robot", "tick");
  event("hand", "tock");
  event("foot", "tack");
  for (const char* cost : {"SEND", "RECEIVE", "SET", "READ", "TEST"}) {
    if (chance_(3) == 0)
      out += "  COST " + std::string(cost) + (chance_(2) == 0 ? " 0.5 ms\n" : " 0 TO 1 ms\n");
  }
  if (chance_(3) == 0) out += "  LATENCY WITHIN PROCESSOR " + interval(0, 1) + "\n";
  if (chance_(3) == 0) out += "  LATENCY BETWEEN PROCESSORS " + interval(0, 3) + "\n";
  return out + "END ENVIRONMENT\n";
}

}  // namespace pal::test
