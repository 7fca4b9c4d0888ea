// Skills by chance whose modules take, ask and send in blocks within blocks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace pal::test {

/// Four to six modules with one loop each, on one to three processors. What a module takes besides what
/// begins its rounds, what it asks for and what it sends stands anywhere in its round, or before: in blocks
/// within blocks, which end, go round until a condition holds, or are cancelled in the middle, in branches,
/// with limits, and in several places at once. The method completes with several codes, in the middle of its
/// rounds and of its blocks. The same seed gives the same text.
class NestedSkill {
 public:
  explicit NestedSkill(std::uint64_t seed) : engine_(seed) {
    for (int& each : odd_) each = chance(8);
  }

  std::string text() {
    draw();
    std::string bodies;
    for (const Module& module : modules_) bodies += body(module);
    std::string out;
    for (const std::string& message : messages_) out += "MESSAGE " + message + " : SIGNAL\n";
    for (const Module& module : modules_) out += "CONDITION c" + module.name + "\n";
    out += "DEVICE robot\nDEVICE hand\nDEVICE foot\nDEVICE sensor\nSKILL nested\n";
    for (const char* kind : {"Sensor Driver", "Logical Sensor", "Machine Controller"}) {
      std::string names;
      for (const Module& module : modules_) {
        if (module.kind == kind) names += (names.empty() ? "" : ", ") + module.name;
      }
      out += "  " + upper(kind) + " " + names + "\n";
    }
    out += "  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n  COMPLETION 2 NORMAL\n";
    return out + requirements() + "END SKILL\n" + bodies + environment();
  }

 private:
  /// Something that a module must say somewhere.
  struct Item {
    enum class Kind { take, call, send };
    Kind kind = Kind::send;
    std::string message;
    std::string party;
    bool answered = false;  // take: of a request
  };
  using Items = std::vector<Item>;
  struct Module {
    std::string kind;
    std::string name;
    Items items;
  };
  enum class Odd { blocks, limits, loops, twice, branches, endings, before, middle, gives_up, commands };

  int chance(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + chance(high - low + 1); }
  /// Of what is odd only some is in one skill, so that something is bounded.
  bool odd(Odd what, int one_in) { return odd_[static_cast<std::size_t>(what)] == 0 && chance(one_in) == 0; }
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
    module(server).items.push_back({Item::Kind::take, message, client, true});
    module(client).items.push_back({Item::Kind::call, message, server, false});
  }
  void sends(const std::string& from, const std::string& to, const std::string& message) {
    messages_.push_back(message);
    module(from).items.push_back({Item::Kind::send, message, to, false});
    module(to).items.push_back({Item::Kind::take, message, from, false});
  }
  void takes(const std::string& name, const std::string& message, const std::string& device) {
    module(name).items.push_back({Item::Kind::take, message, device, false});
  }

  void draw() {
    modules_ = {
        {"Sensor Driver", "SD1", {}}, {"Logical Sensor", "LS1", {}}, {"Machine Controller", "MC1", {}}};
    if (chance(2) == 0) modules_.push_back({"Logical Sensor", "LS2", {}});
    const bool second = chance(2) == 0;
    if (second) modules_.push_back({"Machine Controller", "MC2", {}});
    modules_.push_back({"Skill Module", "SM1", {}});
    messages_ = {"tick", "tock", "tack", "value"};
    takes("MC1", "tick", "robot");
    takes(second ? "MC2" : "MC1", "tock", "hand");
    tack_ = chance(2) == 0;
    value_ = chance(2) == 0;
    if (tack_) {
      takes("SD1", "tack", "foot");
      sends("SD1", "LS1", "raw");
    } else {
      serves("SD1", "LS1", "raw");
    }
    if (value_) module("SD1").items.push_back({Item::Kind::call, "value", "sensor", false});
    const auto link = [this](const std::string& one, const std::string& message) {
      switch (chance(4)) {
        case 0:
          return serves("SM1", one, message);
        case 1:
          return serves(one, "SM1", message);
        case 2:
          return sends(one, "SM1", message);
        default:
          return sends("SM1", one, message);
      }
    };
    if (chance(2) == 0) {
      sends("LS1", "SM1", "force");
    } else {
      link("LS1", "force");
    }
    link("MC1", "motion");
    if (chance(2) == 0) link("MC1", "go");
    if (modules_[3].name == "LS2") link("LS2", "slide");
    if (second) link("MC2", "grip");
  }

  std::string say(const Module& in, const std::string& statement, const std::string& indent) {
    said_.emplace_back(in.name, statement);
    return indent + statement + "\n";
  }
  std::string work(const Module& in, const std::string& indent) {
    return say(in, "w" + std::to_string(between(1, 3)) + in.name, indent);
  }
  std::string any_module() {
    return modules_[static_cast<std::size_t>(chance(static_cast<int>(modules_.size())))].name;
  }
  /// Takes no message, and sends none.
  std::string small(const Module& in, const std::string& indent) {
    switch (chance(8)) {
      case 0:
        return say(in, "SPC( c" + in.name + " )", indent);
      case 1:
        return indent + "SPC( c" + in.name + (chance(2) == 0 ? " = TRUE )\n" : " = FALSE )\n");
      case 2:
      case 3:
        return say(in, "RPC( c" + any_module() + " )", indent);
      default:
        return work(in, indent);
    }
  }
  std::string smalls(const Module& in, int most, const std::string& indent) {
    std::string out;
    for (int i = between(0, most); i > 0; --i) out += small(in, indent);
    return out;
  }
  std::string choice(const Module& in, const std::string& yes, const std::string& no,
                     const std::string& indent) {
    const std::string c = "c" + (chance(3) == 0 ? any_module() : in.name);
    return indent + "CASE\n" + indent + "  ( " + c + " ):\n" + yes + indent + "  ( NOT " + c + " ):\n" + no +
           indent + "END CASE\n";
  }
  std::string wait(const Module& in, const std::string& message, const std::string& then,
                   const std::string& indent) {
    if (!odd(Odd::limits, 3)) return say(in, "WTM( " + message + " )", indent) + then;
    said_.emplace_back(in.name, "WTM( " + message + " )");
    const std::string limit = std::to_string(chance(4) == 0 ? 0 : between(1, 30));
    return indent + "WTM( " + message + " ) WITHIN " + limit + " ms\n" +
           (then.empty() ? indent + "  Do Nothing\n" : then) + indent + "ELSE\n" + small(in, indent + "  ") +
           indent + "END WTM\n";
  }

  /// An item, once.
  std::string once(const Module& in, const Item& item, const std::string& indent) {
    const std::string with = " " + item.party + " )";
    switch (item.kind) {
      case Item::Kind::take: {
        const std::string reply =
            item.answered ? say(in, "TXM( " + item.message + " to" + with, indent) : smalls(in, 1, indent);
        return wait(in, (item.answered ? "request " : "") + item.message + " from " + item.party,
                    smalls(in, 1, indent) + reply, indent);
      }
      case Item::Kind::call:
        return say(in, "TXM( request " + item.message + " from" + with, indent) + smalls(in, 1, indent) +
               wait(in, item.message + " from " + item.party, "", indent);
      case Item::Kind::send:
        break;
    }
    return say(in, "TXM( " + item.message + " to" + with, indent);
  }

  /// Once, or again and again. `last`: nothing comes after it in its block.
  std::string leaf(const Module& in, const Item& item, bool last, const std::string& indent) {
    if (item.kind == Item::Kind::send || !odd(Odd::loops, 2)) return once(in, item, indent);
    const std::string inside = once(in, item, indent + "  ") + smalls(in, 1, indent + "  ");
    if (last && chance(3) != 0) return indent + "REPEAT\n" + inside + indent + "UNTIL( forever )\n";
    return indent + "REPEAT\n" + inside + indent + "  SPC( c" + in.name + " )\n" + indent + "UNTIL( c" +
           in.name + " )\n";
  }

  std::string complete(const Module& in, const std::string& indent) {
    if (in.name != "SM1" || !odd(Odd::endings, 2)) return "";
    const std::string deep = indent + "    ";
    return choice(in, deep + "TXM( Completion Protocol " + (chance(2) == 0 ? "0" : "2") + " )\n",
                  deep + "Do Nothing\n", indent);
  }

  /// All items, in some order and form.
  std::string tree(const Module& in, Items items, int depth, bool last, const std::string& indent) {
    const std::string more = indent + "  ";
    std::shuffle(items.begin(), items.end(), engine_);
    if (depth > 0 && odd(Odd::blocks, 2)) {
      const int count = between(2, 3);
      std::vector<Items> parts(static_cast<std::size_t>(count));
      for (const Item& item : items) parts[static_cast<std::size_t>(chance(count))].push_back(item);
      std::string out = indent + "CONCURRENT\n";
      for (const Items& part : parts) {
        std::string block = part.empty() ? small(in, more) : tree(in, part, depth - 1, true, more);
        if (chance(6) == 0) block += complete(in, more);
        out += indent + "BEGIN\n" + block + indent + "END\n";
      }
      return out + indent + "END CONCURRENT\n" + smalls(in, 1, indent);
    }
    if (depth > 0 && odd(Odd::branches, 3)) {
      Items parts[2];
      for (const Item& item : items) {
        parts[chance(2)].push_back(item);
        if (chance(2) == 0) parts[chance(2)].push_back(item);
      }
      const std::string deep = indent + "    ";
      return choice(in, tree(in, parts[0], depth - 1, false, deep) + small(in, deep),
                    tree(in, parts[1], depth - 1, false, deep) + small(in, deep), indent);
    }
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const bool ends = last && i + 1 == items.size();
      out += depth > 0 && chance(4) == 0 ? tree(in, {items[i]}, depth - 1, ends, indent)
                                         : leaf(in, items[i], ends, indent);
      if (!ends) out += smalls(in, 1, indent);
      if (odd(Odd::twice, 5)) out += once(in, items[i], indent);
    }
    return out;
  }

  static std::string wait_of(const Item& take) {
    return "WTM( " + std::string(take.answered ? "request " : "") + take.message + " from " + take.party +
           " )";
  }

  /// Rounds that begin with `main`, if that is something, and say all items; of the method perhaps one only.
  std::string loop(const Module& in, const Item* main, Items items, const std::string& indent) {
    const std::string more = indent + "  ";
    std::string begins;
    std::string reply;
    if (main != nullptr && odd(Odd::gives_up, 1)) {
      // A round of its own is what it does when nothing comes.
      said_.emplace_back(in.name, wait_of(*main));
      const std::string answer =
          main->answered ? say(in, "TXM( " + main->message + " to " + main->party + " )", more + "  ") : "";
      const std::string obeys = tree(in, items, 1, false, more + "  ");
      return indent + "REPEAT\n" + more + wait_of(*main) + " WITHIN " + std::to_string(between(5, 60)) +
             " ms\n" + answer + obeys + work(in, more + "  ") + more + "ELSE\n" +
             (chance(2) == 0 ? say(in, "SPC( c" + in.name + " )", more + "  ") : "") +
             small(in, more + "  ") + more + "END WTM\n" + indent + "UNTIL( forever )\n";
    }
    if (main != nullptr) {
      begins = say(in, wait_of(*main), more);
      if (main->answered) reply = say(in, "TXM( " + main->message + " to " + main->party + " )", more);
    } else if (chance(2) == 0 && !items.empty() && items.front().kind == Item::Kind::call) {
      begins = once(in, items.front(), more);
      items.erase(items.begin());
    } else {
      begins = say(in, "p" + in.name, more);
    }
    std::string inside = tree(in, items, 3, false, more) + smalls(in, 2, more);
    inside += complete(in, more);
    if (chance(2) == 0) inside = say(in, "RPC( c" + any_module() + " )", more) + inside;
    if (chance(3) == 0) inside += say(in, "RPC( c" + any_module() + " )", more) + work(in, more);
    if (chance(2) == 0) {
      const std::string set = say(in, "SPC( c" + in.name + " )", more);
      inside = chance(2) == 0 ? set + inside : inside + set;
    }
    inside = chance(3) == 0 ? begins + reply + inside : begins + inside + reply;
    if (in.name == "SM1" && odd(Odd::endings, 2)) return inside;
    if (!odd(Odd::endings, 3)) return indent + "REPEAT\n" + inside + indent + "UNTIL( forever )\n";
    return indent + "REPEAT\n" + inside + more + "SPC( c" + in.name + " )\n" + indent + "UNTIL( c" + in.name +
           " )\n";
  }

  /// What begins the rounds of a module is taken before them, too.
  std::string before(const Module& in, const Item& take) {
    const std::string answer =
        take.answered ? "    TXM( " + take.message + " to " + take.party + " )\n" : work(in, "    ");
    if (chance(2) == 0) {
      said_.emplace_back(in.name, wait_of(take));
      return "  " + wait_of(take) + " WITHIN " + std::to_string(between(0, 60)) + " ms\n" + answer +
             "  ELSE\n" + small(in, "    ") + "  END WTM\n";
    }
    return "  CONCURRENT\n  BEGIN\n    REPEAT\n" + say(in, wait_of(take), "    ") + answer +
           "    UNTIL( forever )\n  END\n  BEGIN\n" + say(in, "p" + in.name, "    ") +
           "  END\n  END CONCURRENT\n";
  }

  std::string body(const Module& in) {
    std::string out = in.kind + ": " + in.name + "\n";
    for (int i = 1; i <= 3; ++i) out += "  ACTIVITY w" + std::to_string(i) + in.name + "\n";
    out += "  ACTIVITY p" + in.name + "\nBEGIN\n";
    if (in.name == "SM1") out += "  WTM( Coordinator )\n";
    Items takes;
    Items items;
    for (const Item& item : in.items) (item.kind == Item::Kind::take ? takes : items).push_back(item);
    if (odd(Odd::before, 2)) {
      out += items.empty() || chance(2) == 0 ? small(in, "  ") : tree(in, {items.back()}, 2, false, "  ");
    }
    if (odd(Odd::commands, 1)) {
      // What it sends it sends once.
      const auto sends = [](const Item& item) { return item.kind == Item::Kind::send; };
      const auto first = std::stable_partition(items.begin(), items.end(), std::not_fn(sends));
      for (auto item = first; item != items.end(); ++item)
        out += (chance(2) == 0 ? say(in, "p" + in.name, "  ") : "") + once(in, *item, "  ");
      items.erase(first, items.end());
    }
    std::shuffle(takes.begin(), takes.end(), engine_);
    if (!takes.empty() && odd(Odd::before, 2)) out += before(in, takes.front());
    if (odd(Odd::middle, 2)) {
      // All but one are taken in the middle of its rounds.
      while (takes.size() > 1) {
        items.push_back(takes.back());
        takes.pop_back();
      }
    }
    if (takes.size() < 2) {
      out += loop(in, takes.empty() ? nullptr : &takes.front(), items, "  ");
    } else {
      std::vector<Items> parts(takes.size());
      for (const Item& item : items)
        parts[static_cast<std::size_t>(chance(static_cast<int>(takes.size())))].push_back(item);
      out += "  CONCURRENT\n";
      for (std::size_t i = 0; i < takes.size(); ++i) {
        out += "  BEGIN\n" + loop(in, &takes[i], parts[i], "    ") + "  END\n";
        blocks_.push_back(in.name + "." + std::to_string(i + 1));
      }
      out += "  END CONCURRENT\n";
    }
    if (in.name == "SM1") out += "  TXM( Completion Protocol 0 )\n";
    return out + "END\n";
  }

  std::string at() {
    const auto& [in, statement] = said_[static_cast<std::size_t>(chance(static_cast<int>(said_.size())))];
    return statement + " IN " + in;
  }

  std::string requirements() {
    std::string out;
    int number = 0;
    const auto add = [&](const std::string& measure) {
      out += "  REQUIREMENT r" + std::to_string(number++) + " : " + measure + "\n";
    };
    const std::string most = " AT MOST 1 s";
    for (int i = 0; i < 4; ++i) {
      add("RESPONSE FROM tick OF robot TO " + at() + most);
      add("RESPONSE FROM tock OF hand TO " + at() + most);
      if (tack_) add("RESPONSE FROM tack OF foot TO " + at() + most);
      add("AGE OF c" + any_module() + " AT " + at() + most);
      add("AGE OF c" + any_module() + " AT " + at() + most);
      add("REACTION OF c" + any_module() + " AT " + at() + most);
      if (value_) add("AGE OF value FROM sensor AT " + at() + most);
      if (value_) add("REACTION OF value FROM sensor AT " + at() + most);
      if (tack_) add("REACTION OF tack FROM foot AT " + at() + most);
      add("AGE OF tick FROM robot AT " + at() + most);
      add("INTERVAL OF " + at() + most);
      add("INTERVAL OF " + at() + most);
      add("INTERVAL OF " + at() + " AT LEAST 1 ms");
    }
    for (const auto& [in, statement] : said_) {
      if (chance(4) == 0) {
        // What a thread has read, at each of its statements.
        add("AGE OF c" + any_module() + " AT " + statement + " IN " + in + most);
      }
      if (statement.rfind("TXM( ", 0) != 0 || chance(2) == 0) continue;
      const bool asks = statement.rfind("TXM( request", 0) == 0;
      add("RESPONSE FROM " + statement.substr(5, statement.find(asks ? " from " : " to ") - 5) + " OF " + in +
          " TO " + at() + most);
    }
    if (value_) add("LOSS OF sensor AT MOST 1 IN 3");
    add("LOSS OF robot NONE");
    if (tack_) add("LOSS OF foot NONE");
    for (const char* code : {"0", "1", "2"}) add("DURATION TO COMPLETION " + std::string(code) + most);
    add("LOAD OF EACH PROCESSOR AT MOST 90 %");
    add("BUSY PERIOD OF EACH PROCESSOR" + most);
    return out;
  }

  std::string interval(int low, int high) {
    const int best = between(low, high);
    const int worst = chance(2) != 0 ? best : between(best, high);
    return best == worst ? std::to_string(best) + " ms"
                         : std::to_string(best) + " TO " + std::to_string(worst) + " ms";
  }

  std::string environment() {
    std::string out = "ENVIRONMENT cell\n";
    const int processors = between(1, 3);
    for (int p = 1; p <= processors; ++p)
      out += "  PROCESSOR P" + std::to_string(p) + (chance(4) == 0 ? " NONPREEMPTIVE\n" : "\n");
    for (const Module& module : modules_) {
      out += "  PLACE " + module.name + " ON P" + std::to_string(between(1, processors)) + " PRIORITY " +
             std::to_string(between(1, 4)) + "\n";
      for (int i = 1; i <= 3; ++i)
        out +=
            "  TIME w" + std::to_string(i) + module.name + " : " + interval(chance(4) == 0 ? 0 : 1, 2) + "\n";
      out += "  TIME p" + module.name + " : " + interval(10, 50) + "\n";
    }
    for (const std::string& block : blocks_) {
      if (chance(2) == 0)
        out += "  PLACE " + block + " ON P" + std::to_string(between(1, processors)) + " PRIORITY " +
               std::to_string(between(1, 4)) + "\n";
    }
    if (chance(3) == 0) {
      const int period = between(4, 12);
      out += "  DEVICE sensor FRAMES EVERY " + std::to_string(period) + " ms COLLECTING " +
             std::to_string(between(1, period)) + " ms\n";
    } else {
      out += "  DEVICE sensor ON REQUEST " + interval(chance(4) == 0 ? 0 : 1, 4) + "\n";
    }
    const auto event = [&](const std::string& device, const std::string& message) {
      const int period = chance(3) == 0 ? between(15, 40) : between(40, 150);
      out += "  DEVICE " + device + " EVENT " + message + (chance(5) == 0 ? " SPORADIC " : " EVERY ") +
             std::to_string(period) + " ms";
      if (chance(3) == 0) out += " JITTER " + std::to_string(between(1, period - 1)) + " ms";
      out += "\n";
    };
    event("robot", "tick");
    event("hand", "tock");
    event("foot", "tack");
    for (const char* cost : {"SEND", "RECEIVE", "SET", "READ", "TEST"}) {
      if (chance(3) == 0)
        out += "  COST " + std::string(cost) + (chance(2) == 0 ? " 0.5 ms\n" : " 0 TO 1 ms\n");
    }
    if (chance(3) == 0) out += "  LATENCY WITHIN PROCESSOR " + interval(0, 1) + "\n";
    if (chance(3) == 0) out += "  LATENCY BETWEEN PROCESSORS " + interval(0, 3) + "\n";
    return out + "END ENVIRONMENT\n";
  }

  std::mt19937_64 engine_;
  bool tack_ = false;   // there is a device that sends it
  bool value_ = false;  // there is one that is asked for it
  int odd_[10] = {};    // by Odd; 0: it is
  std::vector<Module> modules_;
  std::vector<std::string> messages_;
  std::vector<std::string> blocks_;
  std::vector<std::pair<std::string, std::string>> said_;  // module and statement
};

}  // namespace pal::test
