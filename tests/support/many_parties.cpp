#include "tests/support/many_parties.hpp"

#include <algorithm>
#include <utility>

namespace pal::test {

std::string ManyParties::text() {
  period_ = 2 + chance_(5);
  loops_ = chance_(3) == 0;
  const std::string first = controller("MC1", {"Y to SM1"}, "d1", "tick", "e");
  const std::string second =
      controller("MC2", chance_(2) == 0 ? Lines{"Y to SM1"} : Lines{"Z to SM1"}, "d2", "tock", "f");
  const std::string method = this->method();
  std::string out =
      "MESSAGE X : SIGNAL\nMESSAGE Y : SIGNAL\nMESSAGE Z : SIGNAL\nMESSAGE tick : SIGNAL\n"
      "MESSAGE tock : SIGNAL\nCONDITION c\nCONDITION e\nCONDITION f\nDEVICE d1\nDEVICE d2\n"
      "SKILL parties\n  MACHINE CONTROLLER MC1, MC2\n  SKILL METHOD SM1\n";
  if (!loops_) out += "  COMPLETION 0 NORMAL\n";
  out += "  COMPLETION 1 ERROR\n" + requirements() + "END SKILL\n" + first + second + method;
  return out + environment();
}

std::string ManyParties::say(const std::string& statement) {
  said_.push_back({module_, statement});
  return statement + "\n";
}

std::string ManyParties::send() {
  const std::string what = chance_.one_of(sends_);
  std::erase(unsent_, what);
  return say("TXM( " + what + " )");
}

std::string ManyParties::wait() {
  const std::string from = chance_.one_of(waits_);
  std::erase(untaken_, from);
  switch (chance_(module_ == "SM1" ? 5 : 8)) {
    case 0:
    case 1:
      return say("WTM( " + from + " )").substr(0, from.size() + 7) + " WITHIN " + ms(chance_(5)) + "\n" +
             little() + "ELSE\n" + little() + "END WTM\n";
    case 2: {
      if (waits_.size() < 2) return say("WTM( " + from + " )");
      Lines all = waits_;
      chance_.shuffle(all);
      all.resize(std::max<std::size_t>(2, static_cast<std::size_t>(chance_(4))));
      all.resize(std::min(all.size(), waits_.size()));
      const bool limited = chance_(3) != 0;
      std::string out = "WTM FIRST" + (limited ? " WITHIN " + ms(chance_(5)) : std::string()) + "\n";
      for (const std::string& each : all) {
        std::erase(untaken_, each);
        out += "( " + each + " ):\n" + little();
      }
      return out + (limited ? "ELSE\n" + little() : "") + "END WTM\n";
    }
    default:
      return say("WTM( " + from + " )");
  }
}

std::string ManyParties::little() {
  switch (chance_(6)) {
    case 0:
      return work();
    case 1:
      return say("SPC( " + sets_ + (chance_(2) == 0 ? " = TRUE )" : " )"));
    case 2:
      return say("RPC( " + chance_.one_of({"c", "e", "f"}) + " )");
    case 3:
      return send();
    default:
      return "Do Nothing\n";
  }
}

std::string ManyParties::statement(int depth) {
  switch (chance_(12)) {
    case 0:
    case 1:
    case 2:
      return send();
    case 3:
    case 4:
    case 5:
      return wait();
    case 6:
    case 7:
      return work();
    case 8: {
      std::string out = "CASE\n";
      for (int arms = 1 + chance_(3); arms > 0; --arms) out += "( " + test() + " ):\n" + little();
      if (chance_(5) != 0) out += "( c OR NOT c ):\n" + little();
      return out + "END CASE\n";
    }
    case 9:
      return depth > 1 ? little()
                       : "REPEAT\n" + statement(2) + work() + "SPC( " + sets_ + " )\nUNTIL( " + sets_ +
                             " OR " + test() + " )\n";
    case 10:
      return depth > 0 ? little() : blocks(1);
    default:
      return little();
  }
}

std::string ManyParties::statements(int depth) {
  std::string out;
  for (int left = 1 + chance_(2); left > 0; --left) out += statement(depth);
  return out;
}

std::string ManyParties::loop(const std::string& body, const std::string& until) {
  return "REPEAT\n" + body + "UNTIL( " + until + " )\n";
}

std::string ManyParties::block(int depth) {
  switch (chance_(5)) {
    case 0:
      return loop(statements(depth) + chance_.one_of({"rest", "work"}) + "\n" + wait(), "forever");
    case 1:
      return loop(wait() + statements(depth) + "SPC( " + sets_ + " )\n", sets_ + " OR " + test());
    case 2:
      return little();
    default:
      return statements(depth);
  }
}

std::string ManyParties::blocks(int depth) {
  std::string out = "CONCURRENT\n";
  for (int left = 2 + chance_(2); left > 0; --left) {
    ++blocks_;
    out += "BEGIN\n" + block(depth) + "END\n";
  }
  return out + "END CONCURRENT\n";
}

void ManyParties::begin(const std::string& module, Lines sends, Lines waits, const std::string& sets) {
  module_ = module;
  sends_ = unsent_ = std::move(sends);
  waits_ = untaken_ = std::move(waits);
  sets_ = sets;
  blocks_ = 0;
}

std::string ManyParties::rest_of() {
  std::string out;
  for (const std::string& each : Lines(unsent_)) out += say("TXM( " + each + " )");
  for (const std::string& each : Lines(untaken_)) out += say("WTM( " + each + " )");
  return out;
}

std::string ManyParties::finished(const std::string& head, const std::string& body) {
  places_.push_back(module_);
  for (int b = 1; b <= blocks_; ++b) {
    if (chance_(2) == 0) places_.push_back(module_ + "." + std::to_string(b));
  }
  return head + module_ + "\n  ACTIVITY work\n  ACTIVITY rest\nBEGIN\n" + body + "END\n";
}

std::string ManyParties::controller(const std::string& name, Lines sends, const std::string& device,
                                    const std::string& message, const std::string& sets) {
  for (const std::string& each : sends) from_.push_back(each.substr(0, 1) + " from " + name);
  Lines waits = {"X from SM1", message + " from " + device};
  Asked asked;
  asked.device = device;
  asked.message = message;
  asked.kind = chance_(6);
  if (asked.kind >= 4) sends.push_back("request " + message + " from " + device);
  devices_.push_back(asked);
  begin(name, sends, waits, sets);
  std::string body;
  switch (chance_(4)) {
    case 0:
      body = blocks(0) + loop(wait() + rest_of());
      break;
    case 1: {
      const std::string once = statements(0);
      body = once + loop(wait() + statements(0) + rest_of());
      break;
    }
    case 2: {
      std::string inner =
          "CONCURRENT\nBEGIN\n" + loop("WTM( X from SM1 )\n" + statements(1)) + "END\nBEGIN\n";
      std::erase(untaken_, std::string("X from SM1"));
      blocks_ += 2;
      inner += loop("WTM( " + waits_[1] + " )\n" + statements(1) + rest_of()) + "END\nEND CONCURRENT\n";
      body = inner;
      break;
    }
    default:
      body = loop(wait() + statements(0) + rest_of());
  }
  return finished("Machine Controller: ", body);
}

std::string ManyParties::method() {
  begin("SM1", {"X to MC1", "X to MC2"}, from_, "c");
  std::string body = blocks(0);
  if (chance_(2) == 0) body = statements(0) + body;
  for (const std::string& each : Lines(unsent_)) body = say("TXM( " + each + " )") + body;
  for (const std::string& each : Lines(untaken_))
    body += "WTM( " + each + " ) WITHIN " + ms(chance_(4)) + "\nDo Nothing\nELSE\n" + little() + "END WTM\n";
  body += work();
  body = "WTM( Coordinator )\n" + (loops_ ? loop(body) : body + "TXM( Completion Protocol 0 )\n");
  return finished("Skill Module: ", body);
}

std::string ManyParties::put() {
  Lines all = {"X OF SM1"};
  for (const std::string& each : from_) all.push_back(each.substr(0, 1) + " OF " + each.substr(7));
  for (const Asked& each : devices_) all.push_back(each.message + " OF " + each.device);
  return chance_.one_of(all);
}

std::string ManyParties::times_of(const Asked& device) {
  // Equal, a multiple, or another.
  const int period = period_ * (chance_(3) == 0 ? 2 : 1) + (chance_(3) == 0 ? 1 : 0);
  const std::string event = " EVENT " + device.message;
  switch (device.kind) {
    case 0:
      return event + " EVERY " + ms(period) + " PHASE " + ms(chance_(period));
    case 1:
      return event + " SPORADIC " + ms(period);
    case 2:
      return event + " EVERY " + ms(period) + " JITTER " + ms(chance_(2) == 0 ? period - 1 : 1);
    case 3:
      return event + " EVERY " + ms(period);
    case 4:
      return " FRAMES EVERY " + ms(period) + " COLLECTING " + ms(1 + chance_(period)) +
             (chance_(2) == 0 ? " PHASE " + ms(chance_(period)) : std::string());
    default:
      return " ON REQUEST " + chance_.one_of({"0 ms", "1 ms", "1 TO 2 ms", "0 TO 3 ms", "4 ms"});
  }
}

}  // namespace pal::test
