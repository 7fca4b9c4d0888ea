// Skills by chance whose modules take what others send in the middle of their rounds, and give up.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// A method, one or two controllers with events far apart, a sensor that is asked, and messages between them
/// of which a module takes one at the beginning of its rounds and the others somewhere else: within a limit,
/// as one of several, in a block beside, or before its rounds. Clients give up or are cancelled while they
/// are answered; blocks leave their rounds and end the skill; a module is executed in several places; slots
/// are filled before anybody takes from them.
/// Calm ones have one trigger a module and little that is odd, so that more is bounded: clients that wait for
/// one another, or a sensor that asks before it has finished what it does, and sends to a slow method.
class OddSkill {
 public:
  explicit OddSkill(std::uint64_t seed, bool calm = false) : chance_(seed), calm_(calm) {
    for (int& each : odd_) each = chance_(calm ? 15 : 3);
  }

  std::string text() {
    draw();
    std::string bodies;
    for (Module& module : modules_) bodies += body(module);
    if (contingency_) bodies += contingency();
    std::string out;
    for (const std::string& message : messages_) out += "MESSAGE " + message + " : SIGNAL\n";
    for (const Module& module : modules_) out += "CONDITION c" + module.name + "\n";
    out += "DEVICE robot\nDEVICE hand\nDEVICE sensor\nSKILL odd\n";
    out += "  SENSOR DRIVER SD1\n  LOGICAL SENSOR LS1\n  MACHINE CONTROLLER MC1" +
           std::string(second_ ? ", MC2" : "") + "\n  SKILL METHOD SM1\n";
    if (contingency_) out += "  CONTINGENCY 1 \"no\" METHOD CM1\n";
    out += "  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n";
    out += requirements() + "END SKILL\n";
    return out + bodies + environment();
  }

 private:
  struct Trigger {
    std::string wait;   // "tick from robot"
    std::string reply;  // a statement, or nothing
  };
  struct Call {
    std::string message;
    std::string server;
  };
  struct Module {
    std::string kind;
    std::string name;
    std::vector<Trigger> triggers;
    std::vector<Call> calls;
    std::vector<std::string> sends;
  };

  enum class Odd { tests, limits, asks, twice, arms, beside, before, within, leaves, executes };

  /// Of what is odd only some is in one skill, so that something is bounded.
  bool odd(Odd what, int one_in) { return odd_[static_cast<std::size_t>(what)] == 0 && chance_(one_in) == 0; }

  Module& module(const std::string& name) {
    for (Module& each : modules_) {
      if (each.name == name) return each;
    }
    return modules_.front();
  }
  void serves(const std::string& server, const std::string& client, const std::string& message) {
    messages_.push_back(message);
    module(server).triggers.push_back(
        {"request " + message + " from " + client, "TXM( " + message + " to " + client + " )"});
    module(client).calls.push_back({message, server});
  }
  void sends(const std::string& from, const std::string& to, const std::string& message) {
    messages_.push_back(message);
    module(from).sends.push_back("TXM( " + message + " to " + to + " )");
    module(to).triggers.push_back({message + " from " + from, ""});
  }

  void draw() {
    second_ = chance_(2) == 0;
    contingency_ = odd(Odd::executes, 1);
    modules_.push_back({"Sensor Driver", "SD1", {}, {}, {}});
    modules_.push_back({"Logical Sensor", "LS1", {}, {}, {}});
    modules_.push_back({"Machine Controller", "MC1", {}, {}, {}});
    if (second_) modules_.push_back({"Machine Controller", "MC2", {}, {}, {}});
    modules_.push_back({"Skill Module", "SM1", {}, {}, {}});
    messages_ = {"tick", "tock", "value"};
    module("MC1").triggers.push_back({"tick from robot", ""});
    module(second_ ? "MC2" : "MC1").triggers.push_back({"tock from hand", ""});
    serves("SD1", "LS1", "raw");
    module("SD1").calls.push_back({"value", "sensor"});
    if (calm_) return calm_links();
    if (chance_(3) != 0) {
      serves("LS1", "SM1", "force");
    } else {
      sends("LS1", "SM1", "force");
    }
    if (chance_(3) == 0) serves("SM1", "MC1", "motion");
    if (chance_(2) == 0) serves("MC1", "SM1", "state");
    if (chance_(3) == 0) sends("MC1", "SM1", "go");
    if (chance_(2) == 0) sends("SM1", "MC1", "stop");
    if (second_ && chance_(2) == 0) serves("MC2", "SM1", "grip");
    if (second_ && chance_(3) == 0) sends("SM1", "MC2", "halt");
  }

  void calm_links() {
    switch (chance_(4)) {
      case 0:
        serves("LS1", "SM1", "force");
        serves("SM1", "MC1", "motion");
        break;
      case 1:
        serves("LS1", "SM1", "force");
        sends("MC1", "SM1", "go");
        break;
      case 2:
        serves("LS1", "SM1", "force");
        polls_ = "SM1";
        break;
      default:
        sends("LS1", "SM1", "force");
        polls_ = "LS1";
    }
    if (second_ && chance_(2) == 0 && module("SM1").triggers.empty()) sends("MC2", "SM1", "halt");
  }

  std::string say(const Module& in, const std::string& statement, const std::string& indent) {
    said_.emplace_back(in.name, statement);
    return indent + statement + "\n";
  }
  std::string work(const Module& in, const std::string& indent) {
    return say(in, "w" + std::to_string(chance_.between(1, 3)) + in.name, indent);
  }
  std::string condition(const Module& in) {
    return "c" + (chance_(3) == 0 ? chance_.one_of(modules_).name : in.name);
  }

  /// Takes no message, and sends none.
  std::string small(const Module& in, const std::string& indent) {
    switch (chance_(7)) {
      case 0:
        if (chance_(2) == 0)
          return indent + "SPC( c" + in.name + (chance_(2) == 0 ? " = TRUE )\n" : " = FALSE )\n");
        return say(in, "SPC( c" + in.name + " )", indent);
      case 1:
        return say(in, "RPC( " + condition(in) + " )", indent);
      case 2:
        return indent + "Do Nothing\n";
      case 3:
        return choice(in, work(in, indent + "    "), indent + "    Do Nothing\n", indent);
      default:
        return work(in, indent);
    }
  }

  std::string choice(const Module& in, const std::string& yes, const std::string& no,
                     const std::string& indent) {
    const std::string c = condition(in);
    // The second arm may exclude the first, overlap with it, or leave something out.
    const std::string other = odd(Odd::tests, 3) ? condition(in) : "NOT " + c;
    return indent + "CASE\n" + indent + "  ( " + c + " ):\n" + yes + indent + "  ( " + other + " ):\n" + no +
           indent + "END CASE\n";
  }
  std::string limit() { return std::to_string(chance_(4) == 0 ? 0 : chance_.between(1, 8)) + " ms"; }

  std::string limited(const Module& in, const std::string& wait, const std::string& then,
                      const std::string& indent) {
    said_.emplace_back(in.name, "WTM( " + wait + " )");
    return indent + "WTM( " + wait + " ) WITHIN " + limit() + "\n" +
           (then.empty() ? indent + "  Do Nothing\n" : then) + indent + "ELSE\n" + small(in, indent + "  ") +
           indent + "END WTM\n";
  }
  std::string serve(const Module& in, const Trigger& trigger, const std::string& indent) {
    std::string out = chance_(2) == 0 ? small(in, indent) : "";
    if (!trigger.reply.empty()) out += say(in, trigger.reply, indent);
    if (out.empty() || chance_(4) == 0) out += small(in, indent);
    return out;
  }

  std::string ask(const Module& in, const Call& call, const std::string& indent) {
    return say(in, "TXM( request " + call.message + " from " + call.server + " )", indent);
  }
  std::string take(const Module& in, const Call& call, const std::string& indent) {
    const std::string answer = call.message + " from " + call.server;
    if (!odd(Odd::limits, 2)) return say(in, "WTM( " + answer + " )", indent);
    return limited(in, answer, small(in, indent + "  "), indent);
  }
  std::string blocks(const std::vector<std::string>& all, const std::string& indent) {
    std::string out = indent + "CONCURRENT\n";
    for (const std::string& each : all) out += indent + "BEGIN\n" + each + indent + "END\n";
    return out + indent + "END CONCURRENT\n";
  }
  static std::string forever(const std::string& inside, const std::string& indent) {
    return indent + "REPEAT\n" + inside + indent + "UNTIL( forever )\n";
  }

  std::string asks(const Module& in, const Call& call, const std::string& indent) {
    const std::string more = indent + "  ";
    switch (odd(Odd::asks, 2) ? chance_(5) : 5) {
      case 0:
        // What is asked for is taken beside, or after.
        return ask(in, call, indent) + blocks({small(in, more), take(in, call, more)}, indent);
      case 1:
        // Cancelled while it waits, or is answered.
        return blocks(
            {forever(ask(in, call, more + "  ") + take(in, call, more + "  ") + work(in, more + "  "), more),
             work(in, more) + small(in, more)},
            indent);
      case 2:
        return choice(in, ask(in, call, more + "  ") + take(in, call, more + "  "), more + "  Do Nothing\n",
                      indent);
      case 3:
        return blocks({ask(in, call, more) + take(in, call, more), work(in, more)}, indent);
      case 4:
        return take(in, call, indent) + small(in, indent) + ask(in, call, indent);
      default:
        return ask(in, call, indent) + (chance_(2) == 0 ? small(in, indent) : "") + take(in, call, indent);
    }
  }

  /// What a round does besides what it takes.
  std::string stuff(Module& in, const std::string& indent) {
    std::vector<std::string> parts;
    for (const Call& call : in.calls) parts.push_back(asks(in, call, indent));
    for (const std::string& send : in.sends) {
      const std::string deep = indent + "    ";
      parts.push_back(chance_(3) == 0 ? choice(in, say(in, send, deep), deep + "Do Nothing\n", indent)
                                      : say(in, send, indent));
      if (odd(Odd::twice, 3)) parts.push_back(say(in, send, indent));
    }
    if (in.name == "SM1" && contingency_) {
      parts.push_back(indent + "Execute CM1\n");
      if (chance_(2) == 0)
        parts.push_back(blocks({indent + "  Execute CM1\n", small(in, indent + "  ")}, indent));
    }
    for (int i = chance_.between(0, 2); i > 0; --i) parts.push_back(small(in, indent));
    if (calm_ && chance_(2) == 0) parts.push_back(say(in, "SPC( c" + in.name + " )", indent));
    if (calm_ && chance_(2) == 0) parts.push_back(say(in, "RPC( c" + module_name() + " )", indent));
    chance_.shuffle(parts);
    std::string out;
    for (const std::string& part : parts) out += part;
    return out;
  }

  std::string loop(const Module& in, const std::string& inside, const std::string& indent) {
    if (!odd(Odd::leaves, 3)) return forever(inside, indent);
    return indent + "REPEAT\n" + inside + indent + "  SPC( c" + in.name + " )\n" + indent + "UNTIL( c" +
           in.name + " )\n";
  }

  /// What is asked for in one round is taken in the next.
  std::string polling(const Module& in, const std::string& indent) {
    const std::string more = indent + "  ";
    const Call& call = in.calls.front();
    std::vector<std::string> after = in.sends;
    if (chance_(3) != 0) after.push_back("w" + std::to_string(chance_.between(1, 3)) + in.name);
    chance_.shuffle(after);
    std::string inside = say(in, answer_of(call), more) + work(in, more) + ask(in, call, more);
    for (const std::string& each : after) inside += say(in, each, more);
    return ask(in, call, indent) + forever(inside, indent);
  }

  /// One of the triggers begins a round; the others are taken elsewhere.
  std::string rounds(Module& in, const std::string& indent) {
    std::vector<Trigger> triggers = in.triggers;
    chance_.shuffle(triggers);
    const std::string more = indent + "  ";
    const std::string deep = more + "    ";
    std::string inside;
    std::vector<std::string> beside;
    std::string before;
    std::vector<Trigger> arms;
    std::string within;
    for (std::size_t i = triggers.empty() ? 0 : 1; i < triggers.size(); ++i) {
      const Trigger& trigger = triggers[i];
      if (odd(Odd::within, 1)) {
        if (odd(Odd::before, 2))
          before += limited(in, trigger.wait, serve(in, trigger, indent + "  "), indent);
        within += limited(in, trigger.wait, serve(in, trigger, more + "  "), more);
      } else if (odd(Odd::beside, 1)) {
        beside.push_back(loop(
            in, say(in, "WTM( " + trigger.wait + " )", more + "  ") + serve(in, trigger, more + "  "), more));
      } else {
        arms.push_back(trigger);
      }
    }
    if (polls_ == in.name && triggers.empty()) return polling(in, indent);
    const std::string work_of_round = stuff(in, more);
    if (triggers.empty()) {
      inside = say(in, "p" + in.name, more) + within + work_of_round;
    } else if (!arms.empty() || odd(Odd::arms, 2)) {
      arms.push_back(triggers.front());
      const bool gives_up = odd(Odd::arms, 2);
      inside = more + "WTM FIRST" +
               (gives_up ? " WITHIN " + std::to_string(chance_.between(2, 30)) + " ms\n" : "\n");
      for (const Trigger& arm : arms) inside += more + "  ( " + arm.wait + " ):\n" + serve(in, arm, deep);
      if (gives_up) inside += more + "ELSE\n" + small(in, deep);
      inside += more + "END WTM\n" + within + work_of_round;
    } else {
      const Trigger& trigger = triggers.front();
      inside = say(in, "WTM( " + trigger.wait + " )", more);
      const std::string answer = serve(in, trigger, more);
      inside += chance_(2) == 0 ? answer + within + work_of_round : within + work_of_round + answer;
    }
    const std::string main = loop(in, inside, indent);
    if (beside.empty() && (in.name != "SM1" || !odd(Odd::leaves, 1))) return before + main;
    std::vector<std::string> all = beside;
    all.push_back(main);
    if (chance_(4) == 0) all.push_back(work(in, more));
    for (std::size_t i = 0; i < all.size(); ++i) blocks_.push_back(in.name + "." + std::to_string(i + 1));
    return before + blocks(all, indent);
  }

  /// Blocks, of which one is cancelled that sets what is read in the next ones.
  std::string one_after_the_other(const Module& in) {
    const std::string deep = "      ";
    const std::string set = deep + "SPC( c" + in.name + " )\n";
    const std::string paced =
        in.calls.empty() ? say(in, "p" + in.name, deep)
                         : ask(in, in.calls.front(), deep) + say(in, answer_of(in.calls.front()), deep);
    std::string out =
        blocks({forever(paced + set, "    "), work(in, "    ") + say(in, "p" + in.name, "    ")}, "  ");
    out += blocks({say(in, "p" + in.name, "    ") + "    RPC( c" + in.name + " )\n" + work(in, "    "),
                   small(in, "    ")},
                  "  ");
    ages_.push_back("c" + in.name + " AT " + said_[said_.size() - 1].second + " IN " + in.name);
    return out;
  }
  static std::string answer_of(const Call& call) {
    return "WTM( " + call.message + " from " + call.server + " )";
  }

  std::string body(Module& in) {
    std::string out = in.kind + ": " + in.name + "\n";
    for (int i = 1; i <= 3; ++i) out += "  ACTIVITY w" + std::to_string(i) + in.name + "\n";
    out += "  ACTIVITY p" + in.name + "\nBEGIN\n";
    if (in.name == "SM1") out += "  WTM( Coordinator )\n";
    if (chance_(6) == 0) out += small(in, "  ");
    if (!in.sends.empty() && chance_(5) == 0) out += say(in, in.sends.front(), "  ");
    if (!in.calls.empty() && polls_ != in.name && chance_(8) == 0) out += asks(in, in.calls.front(), "  ");
    if (odd(Odd::leaves, 2)) out += one_after_the_other(in);
    out += rounds(in, "  ");
    if (in.name == "SM1") out += work(in, "  ") + "  TXM( Completion Protocol 0 )\n";
    return out + "END\n";
  }

  std::string contingency() {
    Module in{"Contingency Module", "CM1", {}, {}, {}};
    std::string out = "Contingency Module: CM1\n";
    for (int i = 1; i <= 3; ++i) out += "  ACTIVITY w" + std::to_string(i) + "CM1\n";
    const std::string inside = chance_(2) == 0 ? "  w1CM1\n" : blocks({"    w1CM1\n", "    w2CM1\n"}, "  ");
    said_.emplace_back("CM1", "w1CM1");
    return out + "BEGIN\n" + inside + "END\n";
  }

  std::string at() {
    const auto& [in, statement] = chance_.one_of(said_);
    return statement + " IN " + in;
  }
  std::string module_name() { return chance_.one_of(modules_).name; }

  std::string requirements() {
    std::string out;
    int number = 0;
    const auto add = [&](const std::string& measure) {
      out += "  REQUIREMENT r" + std::to_string(number++) + " : " + measure + "\n";
    };
    const std::string most = " AT MOST 1 s";
    for (int i = 0; i < 3; ++i) {
      add("RESPONSE FROM tick OF robot TO " + at() + most);
      add("RESPONSE FROM tock OF hand TO " + at() + most);
      add("AGE OF c" + module_name() + " AT " + at() + most);
      add("REACTION OF c" + module_name() + " AT " + at() + most);
      add("AGE OF value FROM sensor AT " + at() + most);
      add("REACTION OF value FROM sensor AT " + at() + most);
      add("AGE OF tick FROM robot AT " + at() + most);
      add("INTERVAL OF " + at() + most);
      add("INTERVAL OF " + at() + " AT LEAST 1 ms");
    }
    for (const auto& [in, statement] : said_) {
      if (statement.rfind("TXM( ", 0) != 0 || chance_(2) == 0) continue;
      const bool asks = statement.rfind("TXM( request", 0) == 0;
      add("RESPONSE FROM " + statement.substr(5, statement.find(asks ? " from " : " to ") - 5) + " OF " + in +
          " TO " + at() + most);
    }
    for (const auto& [in, statement] : said_) {
      if (!calm_ || chance_(2) == 0) continue;
      const std::string there = statement + " IN " + in + most;
      add("RESPONSE FROM tick OF robot TO " + there);
      add("REACTION OF value FROM sensor AT " + there);
      add("REACTION OF c" + module_name() + " AT " + there);
      add("INTERVAL OF " + there);
    }
    for (const std::string& age : ages_) {
      add("AGE OF " + age + most);
      add("REACTION OF " + age + most);
    }
    add("LOSS OF sensor AT MOST 1 IN 3");
    add("LOSS OF robot NONE");
    add("DURATION TO COMPLETION 0" + most);
    add("LOAD OF EACH PROCESSOR AT MOST 90 %");
    add("BUSY PERIOD OF EACH PROCESSOR" + most);
    return out;
  }

  std::string environment() {
    std::string out = "ENVIRONMENT cell\n";
    const int processors = chance_.between(1, 3);
    for (int p = 1; p <= processors; ++p)
      out += "  PROCESSOR P" + std::to_string(p) + (chance_(4) == 0 ? " NONPREEMPTIVE\n" : "\n");
    const auto place = [&](const std::string& thread) {
      out += "  PLACE " + thread + " ON P" + std::to_string(chance_.between(1, processors)) + " PRIORITY " +
             std::to_string(chance_.between(1, 4)) + "\n";
    };
    for (const Module& module : modules_) {
      place(module.name);
      for (int i = 1; i <= 3; ++i)
        out += "  TIME w" + std::to_string(i) + module.name + " : " +
               chance_.interval(chance_(4) == 0 ? 0 : 1, 2) + "\n";
    }
    for (const Module& module : modules_)
      out += "  TIME p" + module.name + " : " + chance_.interval(chance_(4) == 0 ? 1 : 10, 50) + "\n";
    if (contingency_) {
      for (int i = 1; i <= 3; ++i)
        out += "  TIME w" + std::to_string(i) + "CM1 : " + chance_.interval(0, 2) + "\n";
    }
    for (const std::string& block : blocks_) {
      if (chance_(2) == 0) place(block);
    }
    if (chance_(3) == 0) {
      const int period = chance_.between(4, 12);
      out += "  DEVICE sensor FRAMES EVERY " + std::to_string(period) + " ms COLLECTING " +
             std::to_string(chance_.between(1, period)) + " ms\n";
    } else {
      out += "  DEVICE sensor ON REQUEST " + chance_.interval(chance_(4) == 0 ? 0 : 1, 4) + "\n";
    }
    const auto event = [&](const std::string& device, const std::string& message) {
      const int period = chance_(3) == 0 && !calm_ ? chance_.between(15, 40) : chance_.between(40, 150);
      out += "  DEVICE " + device + " EVENT " + message + (chance_(5) == 0 ? " SPORADIC " : " EVERY ") +
             std::to_string(period) + " ms";
      if (chance_(3) == 0) out += " JITTER " + std::to_string(chance_.between(1, period - 1)) + " ms";
      if (chance_(4) == 0 && out.rfind(" SPORADIC ") < out.rfind(" DEVICE "))
        out += " PHASE " + std::to_string(chance_.between(0, period - 1)) + " ms";
      out += "\n";
    };
    event("robot", "tick");
    event("hand", "tock");
    for (const char* cost : {"SEND", "RECEIVE", "SET", "READ", "TEST"}) {
      if (chance_(3) == 0)
        out += "  COST " + std::string(cost) + (chance_(2) == 0 ? " 0.5 ms\n" : " 0 TO 1 ms\n");
    }
    if (chance_(3) == 0) out += "  LATENCY WITHIN PROCESSOR " + chance_.interval(0, 1) + "\n";
    if (chance_(3) == 0) out += "  LATENCY BETWEEN PROCESSORS " + chance_.interval(0, 3) + "\n";
    return out + "END ENVIRONMENT\n";
  }

  Chance chance_;
  int odd_[10] = {};  // by Odd; 0: it is
  std::vector<Module> modules_;
  std::vector<std::string> messages_;
  std::vector<std::string> blocks_;
  std::vector<std::pair<std::string, std::string>> said_;  // module and statement
  std::vector<std::string> ages_;                          // "condition AT statement IN module"
  bool calm_;
  std::string polls_;  // the module that asks before it has finished; nothing: there is none
  bool second_ = false;
  bool contingency_ = false;
};

}  // namespace pal::test
