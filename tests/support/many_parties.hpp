// Skills by chance in which many have to do with one message.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace pal::test {

/// A skill method and two controllers, each one loop or several blocks on processors of their own. Any block
/// of them sends any message of its module, and takes any, with limits and without; so several wait to send
/// one message and several to take it, and one wait may take the same message from two parties. Each
/// controller has a device: events at known phases, at unknown ones or sporadic, answers, or frames, with
/// periods that are equal or multiples more often than not. Loops and blocks end early. What is required is
/// about statements that stand in the text, of each measure. All times are whole milliseconds; the same seed
/// gives the same text.
class ManyParties {
 public:
  explicit ManyParties(std::uint64_t seed) : engine_(seed) {}

  std::string text() {
    period_ = 2 + chance(5);
    loops_ = chance(3) == 0;
    const std::string first = controller("MC1", {"Y to SM1"}, "d1", "tick", "e");
    const std::string second =
        controller("MC2", chance(2) == 0 ? Lines{"Y to SM1"} : Lines{"Z to SM1"}, "d2", "tock", "f");
    const std::string method = this->method();
    std::string out =
        "MESSAGE X : SIGNAL\nMESSAGE Y : SIGNAL\nMESSAGE Z : SIGNAL\nMESSAGE tick : SIGNAL\n"
        "MESSAGE tock : SIGNAL\nCONDITION c\nCONDITION e\nCONDITION f\nDEVICE d1\nDEVICE d2\n"
        "SKILL parties\n  MACHINE CONTROLLER MC1, MC2\n  SKILL METHOD SM1\n";
    if (!loops_) out += "  COMPLETION 0 NORMAL\n";
    out += "  COMPLETION 1 ERROR\n" + requirements() + "END SKILL\n" + first + second + method;
    return out + environment();
  }

 private:
  using Lines = std::vector<std::string>;
  struct Asked {
    std::string device;
    std::string message;
    int kind = 0;
  };

  int chance(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  const std::string& one_of(const Lines& all) {
    return all[static_cast<std::size_t>(chance(static_cast<int>(all.size())))];
  }
  static std::string ms(int time) { return std::to_string(time) + " ms"; }

  /// Remembers a statement, for the requirements.
  std::string say(const std::string& statement) {
    said_.push_back({module_, statement});
    return statement + "\n";
  }
  std::string send() {
    const std::string what = one_of(sends_);
    std::erase(unsent_, what);
    return say("TXM( " + what + " )");
  }
  std::string wait() {
    const std::string from = one_of(waits_);
    std::erase(untaken_, from);
    switch (chance(module_ == "SM1" ? 5 : 8)) {
      case 0:
      case 1:
        return say("WTM( " + from + " )").substr(0, from.size() + 7) + " WITHIN " + ms(chance(5)) + "\n" +
               little() + "ELSE\n" + little() + "END WTM\n";
      case 2: {
        if (waits_.size() < 2) return say("WTM( " + from + " )");
        Lines all = waits_;
        std::shuffle(all.begin(), all.end(), engine_);
        all.resize(std::max<std::size_t>(2, static_cast<std::size_t>(chance(4))));
        all.resize(std::min(all.size(), waits_.size()));
        const bool limited = chance(3) != 0;
        std::string out = "WTM FIRST" + (limited ? " WITHIN " + ms(chance(5)) : std::string()) + "\n";
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
  std::string work() { return say(one_of({"work", "work", "rest"})); }
  std::string test() { return one_of({"c", "e", "NOT c", "c OR e", "e AND NOT f", "f", "NOT ( e OR c )"}); }

  std::string little() {
    switch (chance(6)) {
      case 0:
        return work();
      case 1:
        return say("SPC( " + sets_ + (chance(2) == 0 ? " = TRUE )" : " )"));
      case 2:
        return say("RPC( " + one_of({"c", "e", "f"}) + " )");
      case 3:
        return send();
      default:
        return "Do Nothing\n";
    }
  }

  std::string statement(int depth) {
    switch (chance(12)) {
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
        for (int arms = 1 + chance(3); arms > 0; --arms) out += "( " + test() + " ):\n" + little();
        if (chance(5) != 0) out += "( c OR NOT c ):\n" + little();
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
  std::string statements(int depth) {
    std::string out;
    for (int left = 1 + chance(2); left > 0; --left) out += statement(depth);
    return out;
  }
  std::string loop(const std::string& body, const std::string& until = "forever") {
    return "REPEAT\n" + body + "UNTIL( " + until + " )\n";
  }

  std::string block(int depth) {
    switch (chance(5)) {
      case 0:
        return loop(statements(depth) + one_of({"rest", "work"}) + "\n" + wait(), "forever");
      case 1:
        return loop(wait() + statements(depth) + "SPC( " + sets_ + " )\n", sets_ + " OR " + test());
      case 2:
        return little();
      default:
        return statements(depth);
    }
  }
  std::string blocks(int depth) {
    std::string out = "CONCURRENT\n";
    for (int left = 2 + chance(2); left > 0; --left) {
      ++blocks_;
      out += "BEGIN\n" + block(depth) + "END\n";
    }
    return out + "END CONCURRENT\n";
  }

  void begin(const std::string& module, Lines sends, Lines waits, const std::string& sets) {
    module_ = module;
    sends_ = unsent_ = std::move(sends);
    waits_ = untaken_ = std::move(waits);
    sets_ = sets;
    blocks_ = 0;
  }
  std::string rest_of() {
    std::string out;
    for (const std::string& each : Lines(unsent_)) out += say("TXM( " + each + " )");
    for (const std::string& each : Lines(untaken_)) out += say("WTM( " + each + " )");
    return out;
  }
  std::string finished(const std::string& head, const std::string& body) {
    places_.push_back(module_);
    for (int b = 1; b <= blocks_; ++b) {
      if (chance(2) == 0) places_.push_back(module_ + "." + std::to_string(b));
    }
    return head + module_ + "\n  ACTIVITY work\n  ACTIVITY rest\nBEGIN\n" + body + "END\n";
  }

  std::string controller(const std::string& name, Lines sends, const std::string& device,
                         const std::string& message, const std::string& sets) {
    for (const std::string& each : sends) from_.push_back(each.substr(0, 1) + " from " + name);
    Lines waits = {"X from SM1", message + " from " + device};
    Asked asked;
    asked.device = device;
    asked.message = message;
    asked.kind = chance(6);
    if (asked.kind >= 4) sends.push_back("request " + message + " from " + device);
    devices_.push_back(asked);
    begin(name, sends, waits, sets);
    std::string body;
    switch (chance(4)) {
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

  std::string method() {
    begin("SM1", {"X to MC1", "X to MC2"}, from_, "c");
    std::string body = blocks(0);
    if (chance(2) == 0) body = statements(0) + body;
    for (const std::string& each : Lines(unsent_)) body = say("TXM( " + each + " )") + body;
    for (const std::string& each : Lines(untaken_))
      body += "WTM( " + each + " ) WITHIN " + ms(chance(4)) + "\nDo Nothing\nELSE\n" + little() + "END WTM\n";
    body += work();
    body = "WTM( Coordinator )\n" + (loops_ ? loop(body) : body + "TXM( Completion Protocol 0 )\n");
    return finished("Skill Module: ", body);
  }

  std::string at() {
    const auto& [module, statement] = said_[static_cast<std::size_t>(chance(static_cast<int>(said_.size())))];
    return statement + " IN " + module;
  }
  std::string put() {
    Lines all = {"X OF SM1"};
    for (const std::string& each : from_) all.push_back(each.substr(0, 1) + " OF " + each.substr(7));
    for (const Asked& each : devices_) all.push_back(each.message + " OF " + each.device);
    return one_of(all);
  }
  std::string requirements() {
    std::string out;
    const auto add = [&](int number, const std::string& what) {
      out += "  REQUIREMENT r" + std::to_string(number) + " : " + what + "\n";
    };
    const std::string most = " AT MOST " + ms(2 + chance(10));
    for (int n = 0; n < 5; ++n) {
      const Asked& device = devices_[static_cast<std::size_t>(chance(2))];
      switch (chance(10)) {
        case 0:
        case 1:
          add(n, "RESPONSE FROM " + put() + " TO " + at() + most);
          break;
        case 2:
          add(n, "AGE OF " + one_of({"c", "e", "f"}) + " AT " + at() + most);
          break;
        case 3:
          add(n, "REACTION OF " + one_of({"c", "e", "f"}) + " AT " + at() + most);
          break;
        case 4:
          add(n, "AGE OF " + device.message + " FROM " + device.device + " AT " + at() + most);
          break;
        case 5:
          add(n, "REACTION OF " + device.message + " FROM " + device.device + " AT " + at() + most);
          break;
        case 6:
          add(n, "INTERVAL OF " + at() + " BETWEEN " + ms(1 + chance(4)) + " AND " + ms(5 + chance(8)));
          break;
        case 7:
          add(n, "LOSS OF " + device.device + " AT MOST " + std::to_string(1 + chance(2)) + " IN " +
                     std::to_string(3 + chance(2)));
          break;
        case 8:
          add(n, loops_ || chance(4) == 0 ? "DURATION TO COMPLETION 1" + most
                                          : "DURATION TO COMPLETION 0" + most);
          break;
        default:
          add(n, "BUSY PERIOD OF EACH PROCESSOR" + most);
      }
    }
    return out;
  }

  std::string times_of(const Asked& device) {
    // Equal, a multiple, or another.
    const int period = period_ * (chance(3) == 0 ? 2 : 1) + (chance(3) == 0 ? 1 : 0);
    const std::string event = " EVENT " + device.message;
    switch (device.kind) {
      case 0:
        return event + " EVERY " + ms(period) + " PHASE " + ms(chance(period));
      case 1:
        return event + " SPORADIC " + ms(period);
      case 2:
        return event + " EVERY " + ms(period) + " JITTER " + ms(chance(2) == 0 ? period - 1 : 1);
      case 3:
        return event + " EVERY " + ms(period);
      case 4:
        return " FRAMES EVERY " + ms(period) + " COLLECTING " + ms(1 + chance(period)) +
               (chance(2) == 0 ? " PHASE " + ms(chance(period)) : std::string());
      default:
        return " ON REQUEST " + one_of({"0 ms", "1 ms", "1 TO 2 ms", "0 TO 3 ms", "4 ms"});
    }
  }

  std::string environment() {
    const int processors = 1 + chance(3);
    std::string out = "ENVIRONMENT cell\n";
    for (int p = 0; p < processors; ++p)
      out += "  PROCESSOR P" + std::to_string(p) + (chance(5) == 0 ? " NONPREEMPTIVE\n" : "\n");
    for (const std::string& thread : places_)
      out += "  PLACE " + thread + " ON P" + std::to_string(chance(processors)) + " PRIORITY " +
             std::to_string(1 + chance(2)) + "\n";
    for (const Asked& each : devices_) out += "  DEVICE " + each.device + times_of(each) + "\n";
    out += "  TIME work : " + one_of({"1 ms", "0 ms", "2 ms", "1 TO 2 ms"}) +
           "\n  TIME rest : " + one_of({"1 ms", "3 ms", "0 TO 1 ms"}) + "\n";
    for (const char* cost : {"RECEIVE", "SEND", "TEST", "SET", "READ"}) {
      if (chance(5) == 0) out += std::string("  COST ") + cost + one_of({" 1 ms\n", " 0 TO 1 ms\n"});
    }
    if (chance(3) == 0) out += "  LATENCY BETWEEN PROCESSORS " + one_of({"1 ms", "2 ms", "0 TO 1 ms"}) + "\n";
    if (chance(3) == 0) out += "  LATENCY WITHIN PROCESSOR " + one_of({"1 ms", "2 ms", "0 TO 1 ms"}) + "\n";
    return out + "END ENVIRONMENT\n";
  }

  std::mt19937_64 engine_;
  int period_ = 2;
  bool loops_ = false;
  std::string module_;
  std::string sets_;
  int blocks_ = 0;
  Lines sends_, waits_, unsent_, untaken_, from_, places_;
  std::vector<Asked> devices_;
  std::vector<std::pair<std::string, std::string>> said_;  // module and statement
};

}  // namespace pal::test
