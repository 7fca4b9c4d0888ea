// Skills by chance whose modules ask, serve and send in many ways at a time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// Two to six modules with events of several periods, on one to three processors of both kinds. A module has
/// one loop, a loop for each of its triggers in blocks of their own, or waits for the first of them; it asks
/// before, in, or a round after it takes, in blocks that go on beside others, and in branches; it sends what
/// nobody need take in time.
class WovenSkill {
 public:
  /// `calm`: events are far apart, and more is set and read, so that more is bounded.
  explicit WovenSkill(std::uint64_t seed, bool calm = false)
      : chance_(seed), messages_asked_(seed), calm_(calm) {}

  std::string text() {
    draw();
    std::string bodies;
    for (Module& module : modules_) bodies += body(module);
    std::string out;
    for (const std::string& message : messages_) out += "MESSAGE " + message + " : SIGNAL\n";
    for (const Module& module : modules_) out += "CONDITION c" + module.name + "\n";
    out += "DEVICE robot\nDEVICE hand\n";
    if (drives_) out += "DEVICE sensor\n";
    out += "SKILL woven\n";
    for (const char* kind : {"Sensor Driver", "Logical Sensor", "Machine Controller"}) {
      std::string names;
      for (const Module& module : modules_) {
        if (module.kind == kind) names += (names.empty() ? "" : ", ") + module.name;
      }
      if (kind == std::string("Sensor Driver") && !drives_) names += names.empty() ? "SD1" : ", SD1";
      if (!names.empty()) out += "  " + upper(kind) + " " + names + "\n";
    }
    out += "  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n";
    out += requirements();
    out += "END SKILL\n";
    if (!drives_) out += "Sensor Driver: SD1\n";
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
    std::size_t called = 0;  // of calls: so many are in the text
    std::size_t sent = 0;
  };

  static std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    return text;
  }

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
    drives_ = chance_(3) == 0;
    const bool second_sensor = chance_(3) == 0;
    const bool second_machine = chance_(2) == 0;
    if (drives_) modules_.push_back({"Sensor Driver", "SD1", {}, {}, {}});
    modules_.push_back({"Logical Sensor", "LS1", {}, {}, {}});
    if (second_sensor) modules_.push_back({"Logical Sensor", "LS2", {}, {}, {}});
    modules_.push_back({"Machine Controller", "MC1", {}, {}, {}});
    if (second_machine) modules_.push_back({"Machine Controller", "MC2", {}, {}, {}});
    modules_.push_back({"Skill Module", "SM1", {}, {}, {}});
    messages_ = {"tick", "tock", "correction"};
    module("MC1").triggers.push_back(
        {"tick from robot", chance_(3) != 0 ? "TXM( correction to robot )" : ""});
    if (second_machine) {
      module("MC2").triggers.push_back({"tock from hand", ""});
    } else if (chance_(2) == 0) {
      module("MC1").triggers.push_back({"tock from hand", ""});
    }
    if (drives_) {
      serves("SD1", "LS1", "raw");
      messages_.push_back("value");
      module("SD1").calls.push_back({"value", "sensor"});
    } else {
      messages_.push_back("raw");
      module("LS1").calls.push_back({"raw", "SD1"});
    }
    if (chance_(4) != 0) {
      serves("LS1", "SM1", "force");
    } else {
      sends("LS1", "SM1", "force");
    }
    if (second_sensor) serves("LS2", "SM1", "slide");
    switch (chance_(4)) {
      case 0:
        serves("SM1", "MC1", "motion");
        break;
      case 1:
        sends("MC1", "SM1", "go");
        sends("SM1", "MC1", "motion");
        break;
      case 2:
        sends("MC1", "SM1", "go");
        break;
      default:
        sends("SM1", "MC1", "motion");
        break;
    }
    if (second_machine) {
      if (chance_(2) == 0) {
        serves("MC2", "SM1", "state");
      } else if (chance_(2) == 0) {
        sends("SM1", "MC2", "halt");
      } else {
        sends("MC2", "SM1", "touch");
      }
    }
  }

  std::string say(const Module& in, const std::string& statement, const std::string& indent) {
    if (statement.rfind("TXM( Completion", 0) != 0) said_.push_back({in.name, statement});
    return indent + statement + "\n";
  }

  std::string work(const Module& in, const std::string& indent) {
    return say(in, "w" + std::to_string(chance_.between(1, 3)) + in.name, indent);
  }

  std::string condition(const Module& in) {
    return "c" + (chance_(4) == 0 ? chance_.one_of(modules_).name : in.name);
  }

  std::string ask(const Module& in, const Call& call, const std::string& indent) {
    return say(in, "TXM( request " + call.message + " from " + call.server + " )", indent);
  }
  std::string take(const Module& in, const Call& call, const std::string& indent) {
    const std::string wait = "WTM( " + call.message + " from " + call.server + " )";
    if (chance_(8) != 0) return say(in, wait, indent);
    return indent + wait + " WITHIN " + std::to_string(chance_(3) == 0 ? 0 : chance_.between(1, 12)) +
           " ms\n" + small(in, indent + "  ") + indent + "ELSE\n" + small(in, indent + "  ") + indent +
           "END WTM\n";
  }

  std::string set_or_read(const Module& in, const std::string& indent) {
    if (chance_(2) == 0) return indent + "SPC( c" + in.name + " )\n";
    const Module& other = chance_.one_of(modules_);
    read_.emplace_back(in.name, "c" + other.name);
    return indent + "RPC( c" + other.name + " )\n";
  }

  /// Takes no message, and sends none.
  std::string small(const Module& in, const std::string& indent) {
    if (calm_ && chance_(2) == 0) return set_or_read(in, indent);
    switch (chance_(6)) {
      case 0:
        return indent + "SPC( c" + in.name +
               (chance_(2) == 0   ? ""
                : chance_(2) == 0 ? " = TRUE"
                                  : " = FALSE") +
               " )\n";
      case 1:
        return indent + "RPC( " + condition(in) + " )\n";
      case 2:
        return indent + "Do Nothing\n";
      default:
        return work(in, indent);
    }
  }

  std::string choice(const Module& in, const std::string& yes, const std::string& no,
                     const std::string& indent) {
    const std::string c = condition(in);
    return indent + "CASE\n" + indent + "  ( " + c + " ):\n" + yes + indent + "  ( NOT " + c + " ):\n" + no +
           indent + "END CASE\n";
  }

  std::string blocks(const std::string& one, const std::string& other, const std::string& indent) {
    return indent + "CONCURRENT\n" + indent + "BEGIN\n" + one + indent + "END\n" + indent + "BEGIN\n" +
           other + indent + "END\n" + indent + "END CONCURRENT\n";
  }

  std::string asks(const Module& in, const Call& call, const std::string& indent, int depth) {
    const std::string more = indent + "  ";
    switch (depth > 1 ? chance_(7) : chance_(18)) {
      case 7:
        return blocks(ask(in, call, more) + small(in, more),
                      small(in, more) + take(in, call, more) + work(in, more), indent);
      case 8:
        return blocks(more + "REPEAT\n" + ask(in, call, more + "  ") + take(in, call, more + "  ") +
                          small(in, more + "  ") + more + "UNTIL( forever )\n",
                      work(in, more) + small(in, more), indent);
      case 9: {
        const std::string c = "c" + in.name;
        const std::string deep = more + "  ";
        return indent + "CASE\n" + more + "( " + c + " ):\n" + take(in, call, deep) + work(in, deep) + deep +
               "SPC( " + c + " = FALSE )\n" + more + "( NOT " + c + " ):\n" + ask(in, call, deep) + deep +
               "SPC( " + c + " = TRUE )\n" + indent + "END CASE\n";
      }
      case 10:
        return choice(in, ask(in, call, more + "  ") + take(in, call, more + "  ") + small(in, more + "  "),
                      small(in, more + "  "), indent);
      case 11:
        return blocks(ask(in, call, more) + take(in, call, more), work(in, more), indent);
      default:
        return ask(in, call, indent) + (chance_(2) == 0 ? small(in, indent) : "") + take(in, call, indent);
    }
  }

  /// What a round does, or what is done once; calls and sends that are not in the text yet come first.
  std::string stuff(Module& in, const std::string& indent, int depth = 0) {
    std::string out;
    for (int i = chance_.between(1, 3); i > 0; --i) {
      const bool calls = in.called < in.calls.size() || (!in.calls.empty() && chance_(6) == 0);
      const bool sends = in.sent < in.sends.size() || (!in.sends.empty() && chance_(8) == 0);
      if (calls && chance_(2) == 0) {
        out += asks(in,
                    in.calls[in.called < in.calls.size()
                                 ? in.called++
                                 : static_cast<std::size_t>(chance_(static_cast<int>(in.calls.size())))],
                    indent, depth);
      } else if (sends && chance_(2) == 0) {
        out += say(in,
                   in.sends[in.sent < in.sends.size()
                                ? in.sent++
                                : static_cast<std::size_t>(chance_(static_cast<int>(in.sends.size())))],
                   indent);
      } else if (depth == 0 && chance_(10) == 0) {
        const std::string yes = stuff(in, indent + "    ", 2);
        out += choice(in, yes, small(in, indent + "    "), indent);
      } else if (depth == 0 && chance_(14) == 0) {
        out += blocks(work(in, indent + "  ") + small(in, indent + "  "), small(in, indent + "  "), indent);
      } else {
        out += small(in, indent);
      }
    }
    return out;
  }

  /// What must be in the text, in one round.
  std::string rest(Module& in, const std::string& indent, int depth) {
    std::string out;
    while (in.called < in.calls.size()) out += asks(in, in.calls[in.called++], indent, depth);
    while (in.sent < in.sends.size()) out += say(in, in.sends[in.sent++], indent);
    return out;
  }

  std::string round(Module& in, const Trigger& trigger, bool last, const std::string& indent, int depth) {
    std::string out = stuff(in, indent, depth);
    if (last) out += rest(in, indent, depth);
    if (!trigger.reply.empty()) {
      out += say(in, trigger.reply, indent);
      if (chance_(4) == 0) out += small(in, indent);
    } else if (chance_(3) == 0) {
      out += work(in, indent);
    }
    return out;
  }

  std::string loop(const std::string& inside, const std::string& indent, const Module& in) {
    return indent + "REPEAT\n" + inside + indent +
           (chance_(10) == 0 ? "UNTIL( " + condition(in) + " )\n" : "UNTIL( forever )\n");
  }

  std::string body(Module& in) {
    std::string out = in.kind + ": " + in.name + "\n";
    for (int i = 1; i <= 3; ++i) out += "  ACTIVITY w" + std::to_string(i) + in.name + "\n";
    out += "BEGIN\n";
    const bool method = in.name == "SM1";
    if (method) out += "  WTM( Coordinator )\n";
    if (chance_(5) == 0) out += stuff(in, "  ", 0);
    const std::size_t count = in.triggers.size();
    const int form = count == 0 ? 3 : count == 1 ? (chance_(4) == 0 ? 2 : 0) : chance_(3);
    std::string loops;
    if (form == 3) {
      // It goes on by itself.
      std::string inside;
      if (!in.calls.empty()) {
        const Call& call = in.calls[in.called < in.calls.size() ? in.called++ : 0];
        inside = ask(in, call, "    ") + take(in, call, "    ");
      }
      loops += loop(inside + rest(in, "    ", 0) + stuff(in, "    ") + work(in, "    "), "  ", in);
    } else if (form == 0) {
      // All in one loop, one after the other.
      std::string inside;
      for (std::size_t i = 0; i < count; ++i) {
        inside += say(in, "WTM( " + in.triggers[i].wait + " )", "    ");
        inside += round(in, in.triggers[i], i + 1 == count, "    ", 0);
      }
      loops += loop(inside, "  ", in);
    } else if (form == 1) {
      // The first of them.
      std::string inside = "    WTM FIRST\n";
      for (std::size_t i = 0; i < count; ++i) {
        inside += "      ( " + in.triggers[i].wait + " ):\n";
        inside += round(in, in.triggers[i], i + 1 == count, "        ", 1);
      }
      loops += loop(inside + "    END WTM\n", "  ", in);
    } else {
      // A block each.
      loops += "  CONCURRENT\n";
      for (std::size_t i = 0; i < count; ++i) {
        loops += "  BEGIN\n" +
                 loop(say(in, "WTM( " + in.triggers[i].wait + " )", "      ") +
                          round(in, in.triggers[i], i + 1 == count, "      ", 2),
                      "    ", in) +
                 "  END\n";
        blocks_.push_back(in.name + "." + std::to_string(i + 1));
      }
      if (chance_(3) == 0) loops += "  BEGIN\n" + work(in, "    ") + small(in, "    ") + "  END\n";
      loops += "  END CONCURRENT\n";
    }
    out += loops;
    if (method) out += (chance_(2) == 0 ? work(in, "  ") : "") + "  TXM( Completion Protocol 0 )\n";
    return out + "END\n";
  }

  std::string at() {
    if (said_.empty()) return "w1SM1 IN SM1";
    const auto& [in, statement] = chance_.one_of(said_);
    return statement + " IN " + in;
  }

  /// Some of what modules put: "message OF module".
  std::vector<std::string> messages_put() {
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

  std::string requirements() {
    std::string out;
    int number = 0;
    const auto add = [&](const std::string& measure) {
      out += "  REQUIREMENT r" + std::to_string(number++) + " : " + measure + "\n";
    };
    const std::string most = " AT MOST 1 s";
    add("RESPONSE FROM tick OF robot TO " + at() + most);
    add("RESPONSE FROM tick OF robot TO " + at() + most);
    add("AGE OF c" + chance_.one_of(modules_).name + " AT " + at() + most);
    add("AGE OF c" + chance_.one_of(modules_).name + " AT " + at() + most);
    add("REACTION OF c" + chance_.one_of(modules_).name + " AT " + at() + most);
    const std::string sample = drives_ ? "value FROM sensor" : "raw FROM SD1";
    add("AGE OF " + sample + " AT " + at() + most);
    add("AGE OF " + sample + " AT " + at() + most);
    add("REACTION OF " + sample + " AT " + at() + most);
    add("AGE OF tick FROM robot AT " + at() + most);
    add("INTERVAL OF " + at() + most);
    add("INTERVAL OF " + at() + most);
    add("INTERVAL OF " + at() + " AT LEAST 1 ms");
    add("INTERVAL OF " + at() + " AT LEAST 1 ms");
    add(std::string("LOSS OF ") + (drives_ ? "sensor" : "SD1") + " AT MOST 1 IN 3");
    add("LOSS OF robot NONE");
    for (const std::string& from : messages_put()) {
      const auto& [in, statement] = said_[messages_asked_() % said_.size()];
      add("RESPONSE FROM " + from + " TO " + statement + " IN " + in + most);
    }
    add("DURATION TO COMPLETION 0" + most);
    add("LOAD OF EACH PROCESSOR AT MOST 90 %");
    add("BUSY PERIOD OF EACH PROCESSOR" + most);
    for (std::size_t i = 0; i < read_.size() && i < 4; ++i) {
      const auto& [in, condition] = read_[i];
      for (const auto& [module, statement] : said_) {
        if (module != in || chance_(3) != 0) continue;
        add("AGE OF " + condition + " AT " + statement + " IN " + in + most);
        add("REACTION OF " + condition + " AT " + statement + " IN " + in + most);
        break;
      }
    }
    return out;
  }

  std::string environment() {
    std::string out = "ENVIRONMENT cell\n";
    const int processors = chance_.between(1, 3);
    for (int p = 1; p <= processors; ++p)
      out += "  PROCESSOR P" + std::to_string(p) + (chance_(3) == 0 ? " NONPREEMPTIVE\n" : "\n");
    const auto place = [&](const std::string& thread) {
      out += "  PLACE " + thread + " ON P" + std::to_string(chance_.between(1, processors)) + " PRIORITY " +
             std::to_string(chance_.between(1, 5)) + "\n";
    };
    for (const Module& module : modules_) {
      place(module.name);
      for (int i = 1; i <= 3; ++i)
        out += "  TIME w" + std::to_string(i) + module.name + " : " +
               chance_.interval(chance_(8) == 0 ? 0 : 1, chance_(6) == 0 ? 8 : 2) + "\n";
    }
    for (const std::string& block : blocks_) {
      if (chance_(2) == 0) place(block);
    }
    const std::string sensor = drives_ ? "sensor" : "SD1";
    if (chance_(4) == 0) {
      const int period = chance_.between(5, 15);
      out += "  DEVICE " + sensor + " FRAMES EVERY " + std::to_string(period) + " ms COLLECTING " +
             std::to_string(chance_.between(1, period)) + " ms\n";
    } else {
      out += "  DEVICE " + sensor + " ON REQUEST " +
             chance_.interval(chance_(8) == 0 ? 0 : 1, chance_(3) == 0 ? 12 : 4) + "\n";
    }
    const auto event = [&](const std::string& device, const std::string& message) {
      const int period = calm_             ? chance_.between(50, 250)
                         : chance_(3) == 0 ? chance_.between(8, 30)
                                           : chance_.between(25, 120);
      out += "  DEVICE " + device + " EVENT " + message + (chance_(6) == 0 ? " SPORADIC " : " EVERY ") +
             std::to_string(period) + " ms";
      if (chance_(3) == 0) out += " JITTER " + std::to_string(chance_.between(1, period - 1)) + " ms";
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
  std::mt19937_64 messages_asked_;  // apart, so that the skills of seeds stay what they are
  std::vector<Module> modules_;
  std::vector<std::string> messages_;
  std::vector<std::string> blocks_;
  std::vector<std::pair<std::string, std::string>> said_;  // module and statement
  std::vector<std::pair<std::string, std::string>> read_;  // module and condition
  bool calm_;
  bool drives_ = false;
};

}  // namespace pal::test
