// Random skills whose method asks servers for something, round after round, and ends.
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// The text of a skill with its environment:
/// - two to four servers, some of which ask a camera, and some of which work after they have answered;
/// - perhaps a thread that ticks beside them;
/// - a method that asks some servers in each round, and waits for the answers in any order; a request may be
///   answered in a later round, or withdrawn.
///
/// All times are whole milliseconds. The same seed gives the same text.
class AskingSkill {
 public:
  explicit AskingSkill(std::uint64_t seed) : chance_(seed), servers_(chance_.between(2, 4)) {}

  std::string text() {
    for (int s = 0; s < servers_; ++s) camera_.push_back(chance_(2) == 0);
    const bool ticks = chance_(3) == 0;
    std::string out = ticks ? "DEVICE clock\nMESSAGE time : SIGNAL\n" : "";
    for (int s = 0; s < servers_; ++s) out += server(s);
    if (ticks)
      out +=
          "Sensor Driver: Ticker\n  ACTIVITY tick\nBEGIN\n  REPEAT\n    WTM( time from clock )\n    tick\n"
          "  UNTIL( forever )\nEND\n";
    out += method() + skill(ticks);
    return out + environment(ticks);
  }

 private:
  static std::string named(const std::string& name, int number) { return name + std::to_string(number); }

  std::string server(int s) {
    const std::string pose = named("pose-", s);
    const std::string image = named("image-", s);
    const std::string camera = named("camera-", s);
    std::string out = "MESSAGE " + pose + " : SIGNAL\n";
    if (camera_at(s)) out += "DEVICE " + camera + "\nMESSAGE " + image + " : n : INTEGER\n";
    out += "Machine Controller: " + named("Finder", s) + "\n  ACTIVITY " + named("before-", s) +
           "\n  ACTIVITY " + named("after-", s) + "\nBEGIN\n  REPEAT\n    WTM( request " + pose +
           " from Inspect )\n";
    if (camera_at(s))
      out += "    TXM( request " + image + " from " + camera + " )\n    WTM( " + image + " from " + camera +
             " )\n";
    if (!camera_at(s) || chance_(3) != 0) out += "    " + named("before-", s) + "\n";
    out += "    TXM( " + pose + " to Inspect )\n";
    if (chance_(3) == 0) out += "    " + named("after-", s) + "\n";
    return out + "  UNTIL( forever )\nEND\n";
  }

  std::string ask(int s) const {
    return "  TXM( request " + named("pose-", s) + " from " + named("Finder", s) + " )\n";
  }

  std::string take(int s) {
    const std::string wait = "  WTM( " + named("pose-", s) + " from " + named("Finder", s) + " )";
    if (chance_(8) != 0) return wait + "\n";
    return wait + " WITHIN " + std::to_string(chance_.between(1, 12)) + " ms\n    Do Nothing\n  ELSE\n    " +
           (chance_(2) == 0 ? "pause" : "Do Nothing") + "\n  END WTM\n";
  }

  std::string method() {
    std::string out =
        "Skill Module: Inspect\n  ACTIVITY evaluate\n  ACTIVITY pause\nBEGIN\n  WTM( Coordinator )\n";
    std::vector<int> open;
    std::set<int> used;
    for (int rounds = chance_.between(1, 3); rounds > 0; --rounds) {
      std::vector<int> asked;
      for (int s = 0; s < servers_; ++s) {
        const bool is_open = std::find(open.begin(), open.end(), s) != open.end();
        const bool never_asked = rounds == 1 && !used.contains(s);
        if (!is_open && (chance_(4) != 0 || never_asked)) asked.push_back(s);
      }
      chance_.shuffle(asked);
      for (const int s : asked) {
        used.insert(s);
        out += ask(s);
        if (chance_(5) == 0) out += "  pause\n";
      }
      open.insert(open.end(), asked.begin(), asked.end());
      chance_.shuffle(open);
      std::vector<int> left;
      for (const int s : open) {
        if (rounds > 1 && chance_(6) == 0) {
          left.push_back(s);
        } else {
          out += take(s);
        }
      }
      open = left;
      out += "  evaluate\n";
    }
    return out + "  TXM( Completion Protocol 0 )\nEND\n";
  }

  std::string skill(bool ticks) {
    std::string out = "SKILL asking\n";
    if (ticks) out += "  SENSOR DRIVER Ticker\n";
    out += "  MACHINE CONTROLLER Finder0";
    for (int s = 1; s < servers_; ++s) out += ", " + named("Finder", s);
    out +=
        "\n  SKILL METHOD Inspect\n  COMPLETION 0 NORMAL \"done\"\n  COMPLETION 1 ERROR \"any other error\"\n"
        "  REQUIREMENT whole : DURATION TO COMPLETION 0 AT MOST 1 s\n";
    for (int s = 0; s < servers_; ++s) {
      if (camera_at(s))
        out += "  REQUIREMENT " + named("fresh-", s) + " : AGE OF " + named("image-", s) + " FROM " +
               named("camera-", s) + " AT evaluate IN Inspect AT MOST 100 ms\n";
      out += "  REQUIREMENT " + named("served-", s) + " : RESPONSE FROM request " + named("pose-", s) +
             " OF Inspect TO TXM( " + named("pose-", s) + " to Inspect ) AT MOST 100 ms\n";
    }
    if (ticks) out += "  REQUIREMENT ticked : RESPONSE FROM time OF clock TO tick AT MOST 100 ms\n";
    return out + "END SKILL\n";
  }

  std::string place(const std::string& module) {
    return "  PLACE " + module + " ON P" + std::to_string(chance_(2)) + " PRIORITY " +
           std::to_string(chance_.between(1, 5)) + "\n";
  }

  std::string environment(bool ticks) {
    std::string out = "ENVIRONMENT cell\n";
    for (int p = 0; p < 2; ++p)
      out += "  PROCESSOR P" + std::to_string(p) + (chance_(4) == 0 ? " NONPREEMPTIVE\n" : "\n");
    out += place("Inspect");
    for (int s = 0; s < servers_; ++s) {
      if (camera_at(s))
        out += "  DEVICE " + named("camera-", s) + " ON REQUEST " + chance_.interval(1, 9) + "\n";
      out += place(named("Finder", s));
      out += "  TIME " + named("before-", s) + " : " + chance_.interval(1, 5) + "\n";
      out += "  TIME " + named("after-", s) + " : " + chance_.interval(1, 3) + "\n";
    }
    if (ticks) {
      out += "  DEVICE clock EVENT time EVERY " + std::to_string(chance_.between(6, 20)) + " ms\n";
      out += place("Ticker") + "  TIME tick : " + chance_.interval(1, 3) + "\n";
    }
    out +=
        "  TIME evaluate : " + chance_.interval(1, 2) + "\n  TIME pause : " + chance_.interval(1, 3) + "\n";
    if (chance_(3) == 0) out += "  COST SEND 1 ms\n  COST RECEIVE 1 ms\n";
    if (chance_(3) == 0)
      out += "  LATENCY BETWEEN PROCESSORS 0 TO " + std::to_string(chance_.between(1, 2)) + " ms\n";
    return out + "END ENVIRONMENT\n";
  }

  bool camera_at(int s) const { return camera_[static_cast<std::size_t>(s)]; }

  Chance chance_;
  int servers_;
  std::vector<bool> camera_;
};

}  // namespace pal::test
