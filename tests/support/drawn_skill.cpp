#include "tests/support/drawn_skill.hpp"

#include <algorithm>

namespace pal::test {

DrawnSkill::Module& DrawnSkill::module(const std::string& name) {
  const auto found = std::find_if(modules_.begin(), modules_.end(),
                                  [&name](const Module& each) { return each.name == name; });
  return found == modules_.end() ? modules_.front() : *found;
}

void DrawnSkill::serves(const std::string& server, const std::string& client, const std::string& message) {
  messages_.push_back(message);
  module(server).triggers.push_back(
      {"request " + message + " from " + client, "TXM( " + message + " to " + client + " )"});
  module(client).calls.push_back({message, server});
}

void DrawnSkill::sends(const std::string& from, const std::string& to, const std::string& message) {
  messages_.push_back(message);
  module(from).sends.push_back("TXM( " + message + " to " + to + " )");
  module(to).triggers.push_back({message + " from " + from, ""});
}

std::string DrawnSkill::declarations() const {
  std::string out;
  for (const std::string& message : messages_) out += "MESSAGE " + message + " : SIGNAL\n";
  for (const Module& module : modules_) out += "CONDITION c" + module.name + "\n";
  return out + "DEVICE robot\nDEVICE hand\n";
}

std::string DrawnSkill::head(const std::string& kind, const std::string& name) {
  std::string out = kind + ": " + name + "\n";
  for (int i = 1; i <= 3; ++i) out += "  ACTIVITY w" + std::to_string(i) + name + "\n";
  return out;
}

std::string DrawnSkill::say(const Module& in, const std::string& statement, const std::string& indent) {
  said_.emplace_back(in.name, statement);
  return indent + statement + "\n";
}

std::string DrawnSkill::work(const Module& in, const std::string& indent) {
  return say(in, "w" + std::to_string(chance_.between(1, 3)) + in.name, indent);
}

std::string DrawnSkill::ask(const Module& in, const Call& call, const std::string& indent) {
  return say(in, "TXM( request " + call.message + " from " + call.server + " )", indent);
}

std::string DrawnSkill::answer_of(const Call& call) {
  return "WTM( " + call.message + " from " + call.server + " )";
}

std::string DrawnSkill::cases(const std::string& condition, const std::string& then, const std::string& other,
                              const std::string& otherwise, const std::string& indent) {
  return indent + "CASE\n" + indent + "  ( " + condition + " ):\n" + then + indent + "  ( " + other +
         " ):\n" + otherwise + indent + "END CASE\n";
}

std::string DrawnSkill::concurrent(const std::vector<std::string>& blocks, const std::string& indent) {
  std::string out = indent + "CONCURRENT\n";
  for (const std::string& each : blocks) out += indent + "BEGIN\n" + each + indent + "END\n";
  return out + indent + "END CONCURRENT\n";
}

std::string DrawnSkill::forever(const std::string& inside, const std::string& indent) {
  return indent + "REPEAT\n" + inside + indent + "UNTIL( forever )\n";
}

std::string DrawnSkill::condition(const Module& in, int one_time_in) {
  return "c" + (chance_(one_time_in) == 0 ? any_module() : in.name);
}

std::string DrawnSkill::at() {
  if (said_.empty()) return "w1SM1 IN SM1";
  const auto& [in, statement] = chance_.one_of(said_);
  return statement + " IN " + in;
}

std::string DrawnSkill::processors(int one_nonpreemptive_in) {
  processors_ = chance_.between(1, 3);
  std::string out;
  for (int p = 1; p <= processors_; ++p) {
    out += "  PROCESSOR P" + std::to_string(p) +
           (chance_(one_nonpreemptive_in) == 0 ? " NONPREEMPTIVE\n" : "\n");
  }
  return out;
}

std::string DrawnSkill::place(const std::string& thread, int priorities) {
  return "  PLACE " + thread + " ON P" + std::to_string(chance_.between(1, processors_)) + " PRIORITY " +
         std::to_string(chance_.between(1, priorities)) + "\n";
}

std::string DrawnSkill::places_of_blocks(int priorities) {
  std::string out;
  for (const std::string& block : blocks_) {
    if (chance_(2) == 0) out += place(block, priorities);
  }
  return out;
}

std::string DrawnSkill::costs_and_latencies() {
  std::string out;
  for (const char* cost : {"SEND", "RECEIVE", "SET", "READ", "TEST"}) {
    if (chance_(3) == 0)
      out += "  COST " + std::string(cost) + (chance_(2) == 0 ? " 0.5 ms\n" : " 0 TO 1 ms\n");
  }
  if (chance_(3) == 0) out += "  LATENCY WITHIN PROCESSOR " + chance_.interval(0, 1) + "\n";
  if (chance_(3) == 0) out += "  LATENCY BETWEEN PROCESSORS " + chance_.interval(0, 3) + "\n";
  return out;
}

}  // namespace pal::test
