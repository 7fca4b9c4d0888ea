// What is asked about the skill.
#include "tests/support/woven_skill.hpp"

#include <algorithm>

namespace pal::test {

std::vector<std::string> WovenSkill::messages_put() {
  std::vector<std::string> all;
  for (const auto& [module, statement] : said_) {
    if (statement.rfind("TXM( ", 0) != 0) continue;
    const std::string message = statement.substr(
        5,
        statement.find(statement[5] == 'r' && statement.rfind("TXM( request", 0) == 0 ? " from " : " to ") -
            5);
    all.push_back(message + " OF " + module);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<std::string> some;
  for (int i = 0; i < 8 && !all.empty(); ++i) some.push_back(all[messages_asked_() % all.size()]);
  return some;
}

std::string WovenSkill::requirements() {
  Requirements out;
  const std::string most = " AT MOST 1 s";
  out.add("RESPONSE FROM tick OF robot TO " + at() + most);
  out.add("RESPONSE FROM tick OF robot TO " + at() + most);
  out.add("AGE OF c" + any_module() + " AT " + at() + most);
  out.add("AGE OF c" + any_module() + " AT " + at() + most);
  out.add("REACTION OF c" + any_module() + " AT " + at() + most);
  const std::string sample = drives_ ? "value FROM sensor" : "raw FROM SD1";
  out.add("AGE OF " + sample + " AT " + at() + most);
  out.add("AGE OF " + sample + " AT " + at() + most);
  out.add("REACTION OF " + sample + " AT " + at() + most);
  out.add("AGE OF tick FROM robot AT " + at() + most);
  out.add("INTERVAL OF " + at() + most);
  out.add("INTERVAL OF " + at() + most);
  out.add("INTERVAL OF " + at() + " AT LEAST 1 ms");
  out.add("INTERVAL OF " + at() + " AT LEAST 1 ms");
  out.add(std::string("LOSS OF ") + (drives_ ? "sensor" : "SD1") + " AT MOST 1 IN 3");
  out.add("LOSS OF robot NONE");
  for (const std::string& from : messages_put()) {
    const auto& [in, statement] = said_[messages_asked_() % said_.size()];
    out.add("RESPONSE FROM " + from + " TO " + statement + " IN " + in + most);
  }
  out.add("DURATION TO COMPLETION 0" + most);
  out.add("LOAD OF EACH PROCESSOR AT MOST 90 %");
  out.add("BUSY PERIOD OF EACH PROCESSOR" + most);
  for (std::size_t i = 0; i < read_.size() && i < 4; ++i) {
    const auto& [in, condition] = read_[i];
    for (const auto& [module, statement] : said_) {
      if (module != in || chance_(3) != 0) continue;
      out.add("AGE OF " + condition + " AT " + statement + " IN " + in + most);
      out.add("REACTION OF " + condition + " AT " + statement + " IN " + in + most);
      break;
    }
  }
  return out.text();
}

}  // namespace pal::test
