// Skills by chance that nobody would write: every statement of the language in every place, and workcells of
// every kind with times so small that all of their runs can be tried.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// The text of a skill and its environment; all times are whole milliseconds, none above `longest`. The same
/// seed gives the same text. `deep` bounds how far statements stand inside one another.
class RandomCell {
 public:
  /// What the skill is required to keep: an age, a response; or something of every measure.
  enum class Asks { little, all };

  RandomCell(std::uint64_t seed, int longest, int deep = 2, Asks asks = Asks::little)
      : chance_(seed),
        required_(seed),
        executed_(~seed),
        longest_(longest),
        deep_(deep),
        asks_(asks),
        asks_events_(seed % 4 == 1) {}

  std::string text() {
    sensor_ =
        chance_(5);  // 0 answers, 1 frames, 2 event, 3 a body that asks a device, 4 two kinds of request
    controller_ = chance_(4) != 0;
    lonely_ = chance_(6) == 0;  // no logical sensor
    const std::string limit = std::to_string(2 * longest_) + " ms\n";
    std::string out =
        "MESSAGE force : SIGNAL\nMESSAGE raw : SIGNAL\nMESSAGE extra : SIGNAL\nMESSAGE motion : SIGNAL\n"
        "MESSAGE correction : SIGNAL\nMESSAGE tick : SIGNAL\nCONDITION c\nCONDITION d\n"
        "DEVICE robot\n";
    if (sensor_ == 3) out += "DEVICE gauge\n";
    out += "SKILL random\n";
    if (!lonely_) out += "  SENSOR DRIVER SD1\n  LOGICAL SENSOR LS1\n";
    out +=
        "  MACHINE CONTROLLER MC1\n  SKILL METHOD SM1\n  CONTINGENCY 1 \"no\" METHOD CM1\n  COMPLETION 0 "
        "NORMAL\n  COMPLETION 1 ERROR\n"
        "  REQUIREMENT age-c : AGE OF c AT TXM( motion to MC1 ) IN SM1 AT MOST " +
        limit + "  REQUIREMENT age-d : AGE OF d AT think IN SM1 AT MOST " + limit;
    if (controller_) {
      out +=
          "  REQUIREMENT answer : RESPONSE FROM tick OF robot TO TXM( correction to robot ) AT MOST " + limit;
      out += "  REQUIREMENT through : RESPONSE FROM tick OF robot TO TXM( motion to MC1 ) AT MOST " + limit;
    } else {
      out += "  REQUIREMENT answer : RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 ) AT MOST " +
             limit;
    }
    if (!lonely_ && sensor_ == 2)
      out += "  REQUIREMENT sensed : RESPONSE FROM raw OF SD1 TO TXM( force to SM1 ) AT MOST " + limit;
    if (asks_ == Asks::all) out += requirements();
    out += "END SKILL\n";
    const std::string modules = bodies();
    return out + modules + environment();
  }

 private:
  using Lines = std::vector<std::string>;

  std::string ms(int time) { return std::to_string(time) + " ms"; }

  /// Some requirements of the other measures; drawn apart, so that the skill is the same without them.
  std::string requirements() {
    const std::string most = " AT MOST " + ms(2 * longest_);
    const std::string at = " AT TXM( motion to MC1 ) IN SM1" + most;
    const std::string robot = controller_ ? "robot" : "MC1";
    const std::string sensor = sensor_ == 3 ? "gauge" : "SD1";
    Lines all = {"REACTION OF c" + at,
                 "REACTION OF d AT think IN SM1" + most,
                 "INTERVAL OF TXM( motion to MC1 ) IN SM1" + most,
                 "INTERVAL OF think IN SM1 AT LEAST 2 ms",
                 "INTERVAL OF TXM( motion to MC1 ) IN SM1 BETWEEN 1 ms AND " + ms(longest_),
                 "LOSS OF " + robot + " NONE",
                 "LOSS OF " + robot + " AT MOST 1 IN 3",
                 "DURATION TO COMPLETION 0" + most,
                 "DURATION TO COMPLETION 1" + most,
                 "BUSY PERIOD OF EACH PROCESSOR" + most,
                 "LOAD OF EACH PROCESSOR AT MOST 60 %"};
    if (!lonely_) {
      all.push_back("REACTION OF raw FROM " + sensor + at);
      all.push_back("AGE OF raw FROM " + sensor + at);
      all.push_back("AGE OF raw FROM " + sensor + " AT SPC( c ) IN SM1" + most);
      all.push_back("INTERVAL OF WTM( raw from SD1 ) IN LS1" + most);
      all.push_back("LOSS OF " + sensor + " NONE");
      all.push_back("LOSS OF " + sensor + " AT MOST 1 IN 2");
      all.push_back("RESPONSE FROM force OF LS1 TO TXM( motion to MC1 )" + most);
      all.push_back("RESPONSE FROM force OF LS1 TO SPC( c ) IN SM1" + most);
      all.push_back("RESPONSE FROM request force OF SM1 TO TXM( force to SM1 )" + most);
      all.push_back("RESPONSE FROM raw OF SD1 TO TXM( force to SM1 )" + most);
    }
    all.push_back("RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 )" + most);
    if (controller_) {
      all.push_back("RESPONSE FROM motion OF SM1 TO TXM( correction to robot )" + most);
      all.push_back("RESPONSE FROM motion request OF MC1 TO obey IN MC1" + most);
    }
    std::string out;
    int number = 0;
    for (const std::string& each : all) {
      if (required_() % 4 == 0) out += "  REQUIREMENT more-" + std::to_string(++number) + " : " + each + "\n";
    }
    return out;
  }

  std::string guard() {
    switch (chance_(5)) {
      case 0:
        return "c AND NOT ( d )";
      case 1:
        return "c OR d";
      case 2:
        return "c = FALSE";
      case 3:
        return "d";
      default:
        return "c";
    }
  }

  /// WTM( what ) in one of its forms.
  std::string wait(const std::string& what, int deeper) {
    if (chance_(4) != 0) return "WTM( " + what + " )\n";
    const int limit = chance_(3) == 0 ? 0 : chance_.between(0, longest_);
    return "WTM( " + what + " ) WITHIN " + ms(limit) + "\n" + few(deeper) + "ELSE\n" + few(deeper) +
           "END WTM\n";
  }

  std::string few(int deeper) {
    std::string out;
    for (int count = chance_(3); count > 0; --count) out += statement(deeper);
    return out;
  }

  /// A statement of the module that is being written.
  std::string statement(int deeper) {
    const int kind = chance_(deeper <= 0 ? 8 : 14);
    switch (kind) {
      case 0:
        return "Do Nothing\n";
      case 1:
      case 2:
        return chance_.one_of(activities_) + "\n";
      case 3:
        return sets_ ? chance_.one_of({"SPC( c )\n", "SPC( d )\n", "SPC( c = TRUE )\n"})
                     : chance_.one_of(activities_) + "\n";
      case 4:
        return chance_.one_of({"RPC( c )\n", "RPC( d )\n"});
      case 5:
        return "TXM( " + chance_.one_of(sends_) + " )\n";
      case 6:
        return wait(chance_.one_of(waits_), deeper - 1);
      case 7:
        return executes_ ? "Execute CM1\n" : chance_.one_of(activities_) + "\n";
      case 8: {
        const std::string out = "CASE\n( " + guard() + " ):\n" + few(deeper - 1);
        const bool total = chance_(4) != 0;
        return out + (total ? "( c OR NOT ( c ) ):\nDo Nothing\n" : "") + "END CASE\n";
      }
      case 9:
        return "REPEAT\n" + few(deeper - 1) + chance_.one_of(activities_) + "\nUNTIL( " + guard() + " )\n";
      case 10:
      case 11: {
        std::string out = "CONCURRENT\n";
        for (int blocks = chance_.between(1, 2 + chance_(2)); blocks > 0; --blocks) {
          const bool forever = chance_(3) == 0;
          out += "BEGIN\n" + std::string(forever ? "REPEAT\n" : "") + few(deeper - 1) +
                 (forever ? chance_.one_of(activities_) + "\n" : "") +
                 (chance_(2) == 0 && !backbone_.empty() ? chance_.one_of(backbone_) : "") +
                 (forever ? "UNTIL( forever )\n" : "") + "END\n";
        }
        return out + "END CONCURRENT\n";
      }
      case 12: {
        if (waits_.size() < 2) return wait(waits_.front(), deeper - 1);
        const bool limited = chance_(2) == 0;
        std::string out =
            "WTM FIRST" + (limited ? " WITHIN " + ms(chance_.between(0, longest_)) : std::string()) + "\n";
        Lines each = waits_;
        if (each.size() > 2 && chance_(2) == 0)
          each.erase(each.begin() + chance_(static_cast<int>(each.size())));
        chance_.shuffle(each);
        for (const std::string& what : each) out += "( " + what + " ):\n" + few(deeper - 1);
        return out + (limited ? "ELSE\n" + few(deeper - 1) : "") + "END WTM\n";
      }
      default:
        return backbone_.empty() ? std::string("Do Nothing\n") : chance_.one_of(backbone_);
    }
  }

  /// The backbone, with statements thrown in and a few of its own out of order.
  std::string mixed(Lines lines) {
    if (chance_(6) == 0 && lines.size() > 1) std::swap(lines[0], lines[1]);
    std::string out;
    for (const std::string& line : lines) {
      if (chance_(4) == 0) out += statement(deep_);
      out += line;
    }
    if (chance_(5) == 0) out += statement(deep_);
    return out;
  }

  std::string bodies() {
    std::string out;
    sets_ = executes_ = false;
    if (!lonely_) {
      if (sensor_ == 3) {
        begin({"filter"}, {"request raw from gauge", "raw to LS1"},
              {"raw from gauge", "request raw from LS1"});
        backbone_ = {
            "WTM( request raw from LS1 )\nTXM( request raw from gauge )\nWTM( raw from gauge )\nTXM( raw to "
            "LS1 )\n"};
        out += "Sensor Driver: SD1\nACTIVITY filter\nBEGIN\nREPEAT\n" + mixed(backbone_) +
               "UNTIL( forever )\nEND\n";
      } else {
        out += "Sensor Driver: SD1\n";
      }
      begin({"extract"}, {"force to SM1"}, {"request force from SM1", "raw from SD1"});
      const bool asks = sensor_ != 2 || asks_events_;
      if (asks) sends_.push_back("request raw from SD1");
      std::string get = asks ? "TXM( request raw from SD1 )\nWTM( raw from SD1 )\n" : "WTM( raw from SD1 )\n";
      if (sensor_ == 4) {
        sends_.push_back("request extra from SD1");
        waits_.push_back("extra from SD1");
        get =
            "TXM( request raw from SD1 )\nTXM( request extra from SD1 )\nWTM( raw from SD1 )\nWTM( extra "
            "from SD1 )\n";
      }
      backbone_ = {get, "extract\n"};
      Lines lines = chance_(3) == 0 ? Lines{get, "WTM( request force from SM1 )\n", "TXM( force to SM1 )\n"}
                                    : Lines{"WTM( request force from SM1 )\n", get, "TXM( force to SM1 )\n"};
      out +=
          "Logical Sensor: LS1\nACTIVITY extract\nBEGIN\nREPEAT\n" + mixed(lines) + "UNTIL( forever )\nEND\n";
    }
    out += "Machine Controller: MC1\n";
    if (controller_) {
      begin({"obey"}, {"correction to robot", "request motion from SM1"},
            {"motion from SM1", "tick from robot"});
      backbone_ = {"TXM( request motion from SM1 )\nWTM( motion from SM1 )\n",
                   "TXM( correction to robot )\n"};
      Lines lines = {"WTM( tick from robot )\n", "TXM( request motion from SM1 )\n",
                     wait("motion from SM1", 1), "TXM( correction to robot )\n"};
      out += "ACTIVITY obey\nBEGIN\nREPEAT\n" + mixed(lines) + "UNTIL( forever )\nEND\n";
    }
    sets_ = executes_ = true;
    begin({"think", "prepare"}, {"motion to MC1"}, {"request motion from MC1"});
    const std::string act =
        std::string(chance_(2) == 0 ? "RPC( c )\n" : "") + "WTM( request motion from MC1 )\n" +
        (chance_(2) == 0 ? "CASE\n( c ):\nSPC( d = TRUE )\n( c = FALSE ):\nDo Nothing\nEND CASE\n" : "") +
        "TXM( motion to MC1 )\n";
    std::string sense = "SPC( c )\n";
    if (!lonely_) {
      sends_.push_back("request force from LS1");
      waits_.push_back("force from LS1");
      sense = "TXM( request force from LS1 )\nWTM( force from LS1 )\nSPC( c )\n";
    }
    backbone_ = {act, sense};
    executes_ = false;
    activities_ = {"recover"};
    const std::string executed = "Contingency Module: CM1\nACTIVITY recover\nBEGIN\nrecover\n" +
                                 mixed({act}) + executed_blocks() + "END\n";
    executes_ = true;
    activities_ = {"think", "prepare"};
    std::string method;
    if (chance_(2) == 0) {
      method = "CONCURRENT\nBEGIN\nREPEAT\n" + mixed({sense}) + call() +
               "UNTIL( forever )\nEND\nBEGIN\nREPEAT\n" + call() + mixed({act, "SPC( d )\n"}) +
               "UNTIL( d )\nEND\nEND CONCURRENT\n";
    } else {
      method = "REPEAT\n" + mixed({sense, act, "SPC( d )\n"}) + "UNTIL( d )\n";
    }
    if (blocks_ && executed_() % 2 == 0)
      method += "CONCURRENT\nBEGIN\n" + call() + "think\nEND\nBEGIN\nExecute CM1\nEND\nEND CONCURRENT\n";
    if (chance_(3) == 0) method = few(deep_) + method;
    if (chance_(3) == 0) method += few(deep_);
    out += executed +
           "Skill Module: SM1\nACTIVITY think\nACTIVITY prepare\nBEGIN\nWTM( Coordinator )\nExecute "
           "CM1\nthink\n" +
           method + (chance_(5) != 0 ? "TXM( Completion Protocol 0 )\n" : "") + "END\n";
    return out;
  }

  /// A CONCURRENT in the module that is executed; drawn apart, so that other skills are the same without.
  std::string executed_blocks() {
    blocks_ = executed_() % 4 == 0;
    if (!blocks_) return "";
    const auto some = [this] {
      Lines lines = {"recover\n",
                     "RPC( c )\n",
                     "TXM( motion to MC1 )\n",
                     "WTM( request motion from MC1 ) WITHIN 1 ms\nrecover\nELSE\nDo Nothing\nEND WTM\n",
                     "REPEAT\nrecover\nUNTIL( d )\n",
                     "CONCURRENT\nBEGIN\nrecover\nEND\nBEGIN\nSPC( d )\nEND\nEND CONCURRENT\n",
                     "REPEAT\nrecover\nUNTIL( forever )\n"};
      if (!lonely_) lines.insert(lines.begin(), "TXM( request force from LS1 )\n");
      if (!lonely_) lines.insert(lines.begin(), "TXM( request force from LS1 )\nWTM( force from LS1 )\n");
      std::string out;
      for (auto count = 1 + executed_() % 2; count > 0; --count) out += lines[executed_() % lines.size()];
      return out;
    };
    return "CONCURRENT\nBEGIN\n" + some() + "END\nBEGIN\n" + some() + "END\nEND CONCURRENT\n";
  }
  std::string call() { return blocks_ && executed_() % 2 == 0 ? "Execute CM1\n" : ""; }

  void begin(Lines activities, Lines sends, Lines waits) {
    activities_ = std::move(activities);
    sends_ = std::move(sends);
    waits_ = std::move(waits);
    backbone_.clear();
  }

  std::string place(const std::string& thread, int processors) {
    return "  PLACE " + thread + " ON P" + std::to_string(chance_(processors)) + " PRIORITY " +
           std::to_string(chance_.between(1, 3)) + "\n";
  }

  std::string event(const std::string& device, const std::string& message, bool answer) {
    const int period = chance_.between(longest_ / 2 + 1, longest_);
    const bool odd = asks_ == Asks::all;
    const bool sporadic = chance_(8) == 0 || (odd && required_() % 5 == 0);
    std::string out =
        "  DEVICE " + device + " EVENT " + message + (sporadic ? " SPORADIC " : " EVERY ") + ms(period);
    int jitter = 0;
    if (period > 1 && odd && required_() % 6 == 0) {
      jitter = period - 1;
    } else if (chance_(4) == 0 && period > 1) {
      jitter = chance_.between(1, period - 1);
    }
    if (jitter > 0) out += " JITTER " + ms(jitter);
    if (!sporadic && chance_(3) == 0) out += " PHASE " + ms(chance_.between(0, period - 1));
    if (answer && chance_(3) == 0) out += " ANSWER correction WITHIN " + ms(period - jitter);
    return out + "\n";
  }

  std::string environment() {
    std::string out = "ENVIRONMENT cell\n";
    const int processors = chance_.between(1, 3);
    for (int p = 0; p < processors; ++p)
      out += "  PROCESSOR P" + std::to_string(p) + (chance_(4) == 0 ? " NONPREEMPTIVE\n" : "\n");
    if (!lonely_) {
      if (sensor_ == 2) {
        out += event("SD1", "raw", false);
      } else {
        const std::string device = sensor_ == 3 ? "gauge" : "SD1";
        if (sensor_ == 1 || chance_(3) == 0) {
          const int period = chance_.between(1, longest_);
          out += "  DEVICE " + device + " FRAMES EVERY " + ms(period) + " COLLECTING " +
                 ms(chance_.between(1, period)) +
                 (chance_(3) == 0 ? " PHASE " + ms(chance_.between(0, period - 1)) : std::string()) + "\n";
        } else {
          out += "  DEVICE " + device + " ON REQUEST " + chance_.interval(0, longest_ / 2, 3) + "\n";
        }
      }
    }
    out += controller_ ? event("robot", "tick", true) : event("MC1", "motion request", false);
    out += place("SM1", processors);
    if (!lonely_) out += place("LS1", processors);
    if (!lonely_ && sensor_ == 3) out += place("SD1", processors);
    if (controller_) out += place("MC1", processors);
    for (const char* thread : {"CM1.1", "CM1.2", "SM1.1/CM1.1", "SM1.2/CM1.2", "SM1.2/CM1.1"}) {
      if (!blocks_ || executed_() % 3 != 0) continue;
      out += std::string("  PLACE ") + thread + " ON P" +
             std::to_string(executed_() % static_cast<std::uint64_t>(processors)) + " PRIORITY " +
             std::to_string(1 + executed_() % 3) + "\n";
    }
    for (const char* activity : {"extract", "think", "prepare", "obey", "filter", "recover"}) {
      if (activity[0] == 'e' && lonely_) continue;
      if (activity[0] == 'f' && (lonely_ || sensor_ != 3)) continue;
      if (activity[0] == 'o' && !controller_) continue;
      out += std::string("  TIME ") + activity + " : " + chance_.interval(0, 2, 3) + "\n";
    }
    for (const char* cost : {"SEND", "RECEIVE", "SET", "READ", "TEST"}) {
      if (chance_(3) == 0) out += std::string("  COST ") + cost + " " + chance_.interval(0, 1, 3) + "\n";
    }
    if (chance_(3) == 0) out += "  LATENCY WITHIN PROCESSOR " + chance_.interval(0, 1, 3) + "\n";
    if (chance_(2) == 0) out += "  LATENCY BETWEEN PROCESSORS " + chance_.interval(0, 2, 3) + "\n";
    return out + "END ENVIRONMENT\n";
  }

  Chance chance_;
  std::mt19937_64 required_;
  std::mt19937_64 executed_;
  int longest_;
  int deep_;
  Asks asks_;
  bool asks_events_;  // requests go to a sensor that sends by itself, too
  int sensor_ = 0;
  bool controller_ = true;
  bool lonely_ = false;
  bool sets_ = false;
  bool executes_ = false;
  bool blocks_ = false;
  Lines activities_, sends_, waits_, backbone_;
};

}  // namespace pal::test
