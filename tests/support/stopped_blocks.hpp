// Random skills whose blocks are stopped while others wait for what they have asked for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// A skill method of CONCURRENTs within one another and behind one another, also as the first thing that it
/// does. Their blocks wait for the answers of two controllers, with limits and without. Any of the blocks may
/// have sent the request. Some never end, and some are over at once. The same seed gives the same text.
class StoppedBlocks {
 public:
  explicit StoppedBlocks(std::uint64_t seed) : chance_(seed) {}

  std::string text() {
    device_ = chance_(3) == 0;
    const std::string first = controller("MC1", "X", "c");
    const std::string second = controller("MC2", "Y", "e");
    const bool loops = chance_(2) == 0;
    const std::string method = this->method(loops);
    std::string out =
        "MESSAGE X : SIGNAL\nMESSAGE Y : SIGNAL\nMESSAGE a : SIGNAL\nCONDITION c\nCONDITION e\n";
    if (device_) out += "DEVICE d\n";
    out += "SKILL stopped\n  MACHINE CONTROLLER MC1, MC2\n  SKILL METHOD SM1\n";
    if (!loops) out += "  COMPLETION 0 NORMAL\n";
    out += "  COMPLETION 1 ERROR\n" + requirements(loops) + "END SKILL\n" + first + second + method;
    return out + environment(first, second, method);
  }

 private:
  static std::string loop(const std::string& body) { return "REPEAT\n" + body + "UNTIL( forever )\n"; }
  static std::string concurrent(const std::vector<std::string>& blocks) {
    std::string out = "CONCURRENT\n";
    for (const std::string& block : blocks) out += "BEGIN\n" + block + "END\n";
    return out + "END CONCURRENT\n";
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  std::string controller(const std::string& name, const std::string& message, const std::string& sets) {
    const std::string takes = "WTM( request " + message + " from SM1 )\n";
    const std::string sends = "TXM( " + message + " to SM1 )\n";
    const std::string set = "SPC( " + sets + " = TRUE )\n";
    std::string before = chance_.one_of({"", "", "work\n"});
    if (device_ && name == "MC1") before += "TXM( request a from d )\nWTM( a from d )\n";
    std::string body;
    switch (chance_(5)) {
      case 0:
        body = takes + before + sends + sends + chance_.one_of({"", "work\n"}) + set;
        break;
      case 1:
        body = concurrent({loop(takes + before + sends), chance_.one_of({"Do Nothing\n", "work\n"})}) + set +
               loop(takes + sends);
        break;
      default:
        body = loop(takes + before + sends + chance_.one_of({"", "work\n"}) + set);
    }
    return "Machine Controller: " + name + "\n  ACTIVITY work\nBEGIN\n" + body + "END\n";
  }

  std::string method(bool loops) {
    std::string body = concurrently({"X", "Y"}, 0);
    if (chance_(2) == 0) body += concurrently({"X", "Y"}, 1);
    if (chance_(3) == 0)
      body = "TXM( request " + chance_.one_of({"X from MC1", "Y from MC2"}) + " )\n" + body;
    for (const std::string each : {"X from MC1", "Y from MC2"}) {
      if (!has(body, "TXM( request " + each)) body = "TXM( request " + each + " )\n" + body;
      if (!has(body, "( " + each + " ):") && !has(body, "WTM( " + each))
        body += "WTM( " + each + " ) WITHIN 0 ms\nDo Nothing\nELSE\nDo Nothing\nEND WTM\n";
    }
    if (chance_(2) == 0) body += "CASE\n( c ): Do Nothing\n( NOT c ): pause\nEND CASE\n";
    body += "tick\n";
    body = loops ? loop(body) : body + "TXM( Completion Protocol 0 )\n";
    std::string activities;
    for (const char* each : {"tick", "pause"}) {
      if (has(body, each)) activities += std::string("  ACTIVITY ") + each + "\n";
    }
    return "Skill Module: SM1\n" + activities + "BEGIN\nWTM( Coordinator )\n" + body + "END\n";
  }

  std::string wait() {
    const std::string from = chance_.one_of({"X from MC1", "Y from MC2"});
    const std::string limit = std::to_string(chance_(5)) + " ms";
    switch (chance_(4)) {
      case 0:
        return "WTM( " + from + " )\n";
      case 1:
        return "WTM FIRST WITHIN " + limit +
               "\n( X from MC1 ): " + chance_.one_of({"Do Nothing\n", "tick\n"}) +
               "( Y from MC2 ): " + chance_.one_of({"Do Nothing\n", "pause\n"}) +
               "ELSE\nDo Nothing\nEND WTM\n";
      default:
        return "WTM( " + from + " ) WITHIN " + limit + "\n" + chance_.one_of({"Do Nothing\n", "tick\n"}) +
               "ELSE\n" +
               chance_.one_of({"Do Nothing\n", "tick\n", "CASE\n( c ): tick\n( NOT c ): pause\nEND CASE\n"}) +
               "END WTM\n";
    }
  }

  /// May ask for `asks`, which no block beside it does.
  std::string statement(const std::vector<std::string>& asks) {
    const int which = chance_(8);
    if (which < 3 && !asks.empty()) {
      const std::string message = chance_.one_of(asks);
      return "TXM( request " + message + " from " + (message == "X" ? "MC1" : "MC2") + " )\n";
    }
    return which < 6 ? wait() : chance_.one_of({"tick\n", "pause\n"});
  }

  std::string statements(const std::vector<std::string>& asks) {
    std::string out;
    for (int left = 1 + chance_(3); left > 0; --left) out += statement(asks);
    return out;
  }

  std::string block(const std::vector<std::string>& asks, int depth) {
    switch (chance_(5)) {
      case 0:
        return chance_.one_of({"Do Nothing\n", "pause\n", "tick\n"});
      case 1:
        return loop(statements(asks) +
                    chance_.one_of({"WTM( X from MC1 )\n", "WTM( Y from MC2 )\n", "tick\n"}));
      case 2:
        if (depth < 2) return concurrently(asks, depth + 1) + chance_.one_of({"", "tick\n"});
        [[fallthrough]];
      default:
        return statements(asks);
    }
  }

  std::string concurrently(const std::vector<std::string>& asks, int depth) {
    std::vector<std::vector<std::string>> parts(static_cast<std::size_t>(1 + chance_(3)));
    for (const std::string& each : asks)
      parts[static_cast<std::size_t>(chance_(static_cast<int>(parts.size())))].push_back(each);
    std::vector<std::string> blocks;
    for (const std::vector<std::string>& part : parts) blocks.push_back(block(part, depth));
    return concurrent(blocks);
  }

  std::string requirements(bool loops) {
    std::vector<std::string> all = {"INTERVAL OF tick IN SM1 BETWEEN 2 ms AND 8 ms",
                                    "AGE OF c AT tick IN SM1 AT MOST 6 ms",
                                    "RESPONSE FROM X OF MC1 TO tick IN SM1 AT MOST 5 ms",
                                    "RESPONSE FROM request X OF SM1 TO TXM( X to SM1 ) IN MC1 AT MOST 3 ms",
                                    "BUSY PERIOD OF P0 AT MOST 7 ms",
                                    "REACTION OF c AT tick IN SM1 AT MOST 9 ms"};
    if (!loops) all.insert(all.end(), 3, "DURATION TO COMPLETION 0 AT MOST 8 ms");
    if (device_) all.insert(all.end(), 2, "LOSS OF d AT MOST 1 IN 2");
    std::string out;
    for (int n = 0; n < 3; ++n)
      out += "  REQUIREMENT r" + std::to_string(n) + " : " + chance_.one_of(all) + "\n";
    return out;
  }

  std::string environment(const std::string& first, const std::string& second, const std::string& method) {
    const int processors = 1 + chance_(3);
    std::string out = "ENVIRONMENT cell\n";
    for (int p = 0; p < processors; ++p)
      out += "  PROCESSOR P" + std::to_string(p) + (chance_(5) == 0 ? " NONPREEMPTIVE\n" : "\n");
    const auto place = [&](const std::string& thread) {
      out += "  PLACE " + thread + " ON P" + std::to_string(chance_(processors)) + " PRIORITY " +
             std::to_string(1 + chance_(2)) + "\n";
    };
    for (const auto& [name, body] : {std::pair{"MC1", first}, {"MC2", second}, {"SM1", method}}) {
      place(name);
      int blocks = -1;
      for (auto at = body.find("BEGIN\n"); at != std::string::npos; at = body.find("BEGIN\n", at + 1))
        ++blocks;
      for (int b = 1; b <= blocks; ++b) {
        if (chance_(2) == 0) place(std::string(name) + "." + std::to_string(b));
      }
    }
    if (device_) out += "  DEVICE d ON REQUEST " + chance_.one_of({"0 ms", "2 ms", "1 TO 2 ms"}) + "\n";
    out += "  TIME work : " + chance_.one_of({"0 ms", "1 ms", "3 ms", "7 ms"}) +
           "\n  TIME tick : 1 ms\n  TIME pause : " + chance_.one_of({"2 ms", "3 ms", "1 TO 2 ms"}) + "\n";
    for (const char* cost : {"RECEIVE", "SEND", "TEST"}) {
      if (chance_(5) == 0) out += std::string("  COST ") + cost + " 1 ms\n";
    }
    if (chance_(4) == 0)
      out += "  LATENCY BETWEEN PROCESSORS " + chance_.one_of({"1 ms", "2 ms", "0 TO 1 ms"}) + "\n";
    if (chance_(4) == 0) out += "  LATENCY WITHIN PROCESSOR " + chance_.one_of({"1 ms", "2 ms"}) + "\n";
    return out + "END ENVIRONMENT\n";
  }

  Chance chance_;
  bool device_ = false;
};

}  // namespace pal::test
