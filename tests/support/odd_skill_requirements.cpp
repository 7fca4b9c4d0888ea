// What is asked about the skill.
#include "tests/support/odd_skill.hpp"

namespace pal::test {

std::string OddSkill::requirements() {
  Requirements out;
  const std::string most = " AT MOST 1 s";
  for (int i = 0; i < 3; ++i) {
    out.add("RESPONSE FROM tick OF robot TO " + at() + most);
    out.add("RESPONSE FROM tock OF hand TO " + at() + most);
    out.add("AGE OF c" + any_module() + " AT " + at() + most);
    out.add("REACTION OF c" + any_module() + " AT " + at() + most);
    out.add("AGE OF value FROM sensor AT " + at() + most);
    out.add("REACTION OF value FROM sensor AT " + at() + most);
    out.add("AGE OF tick FROM robot AT " + at() + most);
    out.add("INTERVAL OF " + at() + most);
    out.add("INTERVAL OF " + at() + " AT LEAST 1 ms");
  }
  for (const auto& [in, statement] : said_) {
    if (statement.rfind("TXM( ", 0) != 0 || chance_(2) == 0) continue;
    const bool asks = statement.rfind("TXM( request", 0) == 0;
    out.add("RESPONSE FROM " + statement.substr(5, statement.find(asks ? " from " : " to ") - 5) + " OF " +
            in + " TO " + at() + most);
  }
  for (const auto& [in, statement] : said_) {
    if (!calm_ || chance_(2) == 0) continue;
    const std::string there = statement + " IN " + in + most;
    out.add("RESPONSE FROM tick OF robot TO " + there);
    out.add("REACTION OF value FROM sensor AT " + there);
    out.add("REACTION OF c" + any_module() + " AT " + there);
    out.add("INTERVAL OF " + there);
  }
  for (const std::string& age : ages_) {
    out.add("AGE OF " + age + most);
    out.add("REACTION OF " + age + most);
  }
  out.add("LOSS OF sensor AT MOST 1 IN 3");
  out.add("LOSS OF robot NONE");
  out.add("DURATION TO COMPLETION 0" + most);
  out.add("LOAD OF EACH PROCESSOR AT MOST 90 %");
  out.add("BUSY PERIOD OF EACH PROCESSOR" + most);
  return out.text();
}

}  // namespace pal::test
