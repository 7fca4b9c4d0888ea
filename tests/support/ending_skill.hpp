// Random skills that end in the middle of what they do.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/branch.hpp"
#include "tests/support/chance.hpp"

namespace pal::test {

/// Controllers and a method. A controller goes on by itself, by events of its own device, or by requests of
/// the method. The method, in one piece or in blocks, answers the controllers, and asks them and a logical
/// sensor. Before its rounds, or in them, it may work for long and end the skill or leave a block. One
/// controller reads what they set. The same seed gives the same text.
class EndingSkill {
 public:
  explicit EndingSkill(std::uint64_t seed) : chance_(seed) {}

  std::string text() {
    plan();
    const std::string modules = texts();
    std::string out = "MESSAGE look : SIGNAL\nDEVICE eye\n";
    for (const Party& each : parties_) {
      if (each.driven) out += "MESSAGE t" + each.name + " : SIGNAL\nDEVICE d" + each.name + "\n";
      out += "CONDITION c" + each.name + (each.driven ? " FROM t" + each.name : "") + "\n";
      for (const char* letter : {"e", "b"}) out += std::string("CONDITION ") + letter + each.name + "\n";
      for (const Party* client : each.clients) out += "MESSAGE " + message(each, *client) + " : SIGNAL\n";
    }
    out += "SKILL ending\n  MACHINE CONTROLLER MR\n  SKILL METHOD SM1\n";
    for (const Party& each : parties_) {
      if (each.module == each.name && each.name != "SM1")
        out += (each.name.front() == 'L' ? "  LOGICAL SENSOR " : "  MACHINE CONTROLLER ") + each.name + "\n";
    }
    out += "  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n" + requirements() + "END SKILL\n";
    return out + modules + environment();
  }

 private:
  /// A module, or a block of the method.
  struct Party {
    std::string name;
    std::string module;
    std::string thread;
    bool driven = false;                     // by a device; neither this nor clients: it goes on by itself
    std::vector<const Party*> clients = {};  // that ask it
    std::vector<std::string> asks = {};      // "message from server"
    std::vector<std::string> reads = {};     // conditions, before it works
    /// Where it may do something for long: before its rounds, or as the first or last thing of one.
    enum class Long { nowhere, before, first, last } works = Long::nowhere;
    bool leaves = false;  // a block, by its UNTIL
  };

  Party& party(const std::string& name, const std::string& module, const std::string& thread) {
    Party& made = parties_.emplace_back(Party{name, module, thread});
    if (chance_(module == "SM1" ? 2 : 8) == 0)
      made.works = chance_.one_of<Party::Long>({Party::Long::before, Party::Long::first, Party::Long::last});
    return made;
  }

  void plan() {
    parties_.reserve(8);
    blocks_ = chance_(2) == 0 ? chance_.between(1, 2) : 0;
    std::vector<Party*> methods;
    if (blocks_ == 0) methods.push_back(&party("SM1", "SM1", "SM1"));
    for (int n = 1; n <= blocks_; ++n) {
      methods.push_back(&party("B" + std::to_string(n), "SM1", "SM1." + std::to_string(n)));
      methods.back()->leaves = chance_(2) == 0;
    }
    for (int n = chance_.between(1, 3); n > 0; --n) {
      const std::string name = "MC" + std::to_string(n);
      Party& each = party(name, name, name);
      if (chance_(3) == 0) {
        serve(each, *chance_.one_of(methods));
      } else {
        each.driven = chance_(2) == 0;
        if (chance_(5) > 0) serve(*chance_.one_of(methods), each);
      }
    }
    int sensors = 0;
    for (Party* each : methods) {
      const std::string name = "LS" + std::to_string(sensors + 1);
      const bool idle = each->clients.empty() && each->asks.empty();
      if (!idle && chance_(3) > 0) continue;
      serve(party(name, name, name), *each);
      ++sensors;
    }
    for (Party& each : parties_) each.driven = each.driven || (each.clients.empty() && each.asks.empty());
    for (Party& each : parties_) {
      if (chance_(2) == 0) each.reads.push_back("c" + chance_.one_of<Party>(parties_).name);
    }
  }

  static void serve(Party& server, Party& client) {
    server.clients.push_back(&client);
    client.asks.push_back(message(server, client) + " from " + server.module);
  }

  static std::string message(const Party& server, const Party& client) {
    return "m" + client.name + server.name;
  }

  std::string ask(const Party& in, const std::string& what) {
    const std::string request = "TXM( request " + what + " )\n";
    const std::string wait = "WTM( " + what + " )";
    const bool by_itself = !in.driven && in.clients.empty();
    if (chance_(12) == 0 && !by_itself) {
      return request + wait + " WITHIN " + chance_.one_of({"2", "6", "40"}) +
             " ms\nDo Nothing\nELSE\nDo Nothing\nEND WTM\n";
    }
    return chance_(12) == 0 && !by_itself ? branch("b" + in.name, request + wait + "\n")
                                          : request + wait + "\n";
  }

  static std::string work(const Party& of) {
    std::string out;
    for (const std::string& each : of.reads) out += "RPC( " + each + " )\n";
    return out + "work" + of.name + "\n";
  }

  std::string works_long(const Party& of) {
    std::string done = "long" + of.name + "\n";
    if (!of.asks.empty() && chance_(3) == 0) done += ask(of, chance_.one_of(of.asks));
    if (chance_(4) == 0) done += work(of);
    if (chance_(8) == 0)
      done += "SPC( b" + of.name + " )\nCASE\n( b" + of.name + " ): Do Nothing\nEND CASE\n";
    if (of.module == "SM1" && chance_(5) > 0)
      done += "TXM( Completion Protocol " + std::to_string(chance_(2)) + " )\n";
    return branch("e" + of.name, done);
  }

  /// What it does in a round, for whomever.
  std::string actions(const Party& of) {
    std::vector<std::string> all = {work(of), "SPC( c" + of.name + " )\n"};
    for (const std::string& each : of.asks) all.push_back(ask(of, each));
    chance_.shuffle(all);
    if (of.works == Party::Long::first) all.insert(all.begin(), works_long(of));
    if (of.works == Party::Long::last) all.push_back(works_long(of));
    std::string out;
    for (const std::string& each : all) out += each;
    return out;
  }

  std::string answered(const Party& of, const Party& client) {
    const std::string answer = "TXM( " + message(of, client) + " to " + client.module + " )\n";
    const std::string done = actions(of);
    return chance_(4) == 0 ? answer + done : done + answer;
  }

  std::string round(const Party& of) {
    if (of.driven) return "WTM( t" + of.name + " from d" + of.name + " )\n" + actions(of);
    if (of.clients.empty()) return actions(of);
    const auto request = [&](const Party& client) {
      return "( request " + message(of, client) + " from " + client.module + " )";
    };
    if (of.clients.size() == 1)
      return "WTM" + request(*of.clients.front()) + "\n" + answered(of, *of.clients.front());
    std::string arms = "WTM FIRST\n";
    for (const Party* client : of.clients) arms += request(*client) + ":\n" + answered(of, *client);
    return arms + "END WTM\n";
  }

  std::string life(const Party& of) {
    std::string out;
    if (chance_(4) == 0) out += work(of);
    if (!of.asks.empty() && chance_(3) == 0) out += ask(of, chance_.one_of(of.asks));
    if (of.works == Party::Long::before) out += works_long(of);
    out += "REPEAT\n" + round(of) + "UNTIL( " + (of.leaves ? "c" + of.name : "forever") + " )\n";
    if (of.leaves && chance_(2) == 0) out += "long" + of.name + "\n";
    if (of.leaves && !of.asks.empty() && chance_(3) == 0) out += ask(of, chance_.one_of(of.asks));
    if (of.leaves && chance_(4) == 0) out += work(of);
    return out;
  }

  static std::string activities(const Party& of) {
    return "  ACTIVITY work" + of.name + "\n  ACTIVITY long" + of.name + "\n";
  }

  std::string texts() {
    std::string method = "Skill Module: SM1\n";
    std::string body;
    std::string out;
    for (const Party& each : parties_) {
      if (each.module == "SM1") {
        method += activities(each);
        body += blocks_ == 0 ? life(each) : "BEGIN\n" + life(each) + "END\n";
        continue;
      }
      out += (each.name.front() == 'L' ? "Logical Sensor: " : "Machine Controller: ") + each.name + "\n" +
             activities(each) + "BEGIN\n" + life(each) + "END\n";
    }
    if (blocks_ > 0) {
      body = "CONCURRENT\n" + body + "END CONCURRENT\n";
      if (chance_(2) == 0) body += "longB1\n";
      body += "TXM( Completion Protocol 0 )\n";
    }
    out += "Machine Controller: MR\n  ACTIVITY use\nBEGIN\nREPEAT\nWTM( look from eye )\n";
    for (const Party& each : parties_) out += "RPC( c" + each.name + " )\n";
    return method + "BEGIN\nWTM( Coordinator )\n" + body + "END\n" + out + "use\nUNTIL( forever )\nEND\n";
  }

  std::string requirements() const {
    const std::string most = " AT MOST 900 ms";
    std::vector<std::string> all = {"LOAD OF EACH PROCESSOR AT MOST 90 %",
                                    "BUSY PERIOD OF EACH PROCESSOR AT MOST 900 ms",
                                    "RESPONSE FROM look OF eye TO use IN MR" + most};
    const auto aged = [&](const std::string& value, const std::string& at) {
      for (const std::string measure : {"AGE", "REACTION"})
        all.push_back(measure + " OF " + value + " AT " + at + most);
    };
    for (const Party& each : parties_) {
      const std::string work = "work" + each.name + " IN " + each.module;
      aged("c" + each.name, "use IN MR");
      for (const std::string& read : each.reads) aged(read, work);
      all.push_back("INTERVAL OF " + work + most);
      all.push_back("INTERVAL OF " + work + " AT LEAST 1 ms");
      for (const Party& from : parties_) {
        if (!from.driven) continue;
        all.push_back("RESPONSE FROM t" + from.name + " OF d" + from.name + " TO " + work + most);
        aged("t" + from.name + " FROM d" + from.name, work);
      }
      if (!each.driven) continue;
      aged("t" + each.name + " FROM d" + each.name, "use IN MR");
      all.push_back("LOSS OF d" + each.name + " AT MOST 7 IN 8");
    }
    std::string out;
    for (std::size_t n = 0; n < all.size(); ++n)
      out += "  REQUIREMENT r" + std::to_string(n) + " : " + all[n] + "\n";
    return out;
  }

  std::string environment() {
    const int processors = chance_.between(1, 4);
    std::string out = "ENVIRONMENT cell\n";
    for (int p = 1; p <= processors; ++p)
      out += "  PROCESSOR P" + std::to_string(p) + (chance_(6) == 0 ? " NONPREEMPTIVE\n" : "\n");
    const auto place = [&](const std::string& thread) {
      out += "  PLACE " + thread + " ON P" + std::to_string(chance_.between(1, processors)) + " PRIORITY " +
             std::to_string(chance_.between(1, 3)) + "\n";
    };
    const std::vector<std::string> periods = {"7", "10", "13", "20", "28", "50"};
    place("MR");
    if (blocks_ > 0) place("SM1");
    out += "  TIME use : 0.5 ms\n  DEVICE eye EVENT look EVERY " + chance_.one_of(periods) + " ms\n";
    for (const Party& each : parties_) {
      place(each.thread);
      out += "  TIME work" + each.name + " : " + chance_.one_of({"0.5", "1", "1 TO 2", "3", "1 TO 4"}) +
             " ms\n  TIME long" + each.name + " : " + chance_.one_of({"15", "35", "90", "0 TO 200"}) +
             " ms\n";
      if (each.driven)
        out +=
            "  DEVICE d" + each.name + " EVENT t" + each.name + " EVERY " + chance_.one_of(periods) + " ms\n";
    }
    if (chance_(5) == 0) out += "  LATENCY BETWEEN PROCESSORS " + chance_.interval(0, 3) + "\n";
    if (chance_(5) == 0) out += "  COST SEND 0.5 ms\n";
    return out + "END ENVIRONMENT\n";
  }

  Chance chance_;
  int blocks_ = 0;
  std::vector<Party> parties_;
};

}  // namespace pal::test
