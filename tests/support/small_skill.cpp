#include "tests/support/small_skill.hpp"

#include <algorithm>

#include "tests/support/branch.hpp"

namespace pal::test {
namespace {

const std::string complete = "TXM( Completion Protocol 0 )\n";

std::string repeat(const std::string& round, const std::string& until = "forever") {
  return "REPEAT\n" + round + "UNTIL( " + until + " )\n";
}

std::string together(const std::vector<std::string>& parts) {
  std::string out;
  for (const std::string& each : parts) out += each;
  return out;
}

}  // namespace

SmallSkill::SmallSkill(std::uint64_t seed) : chance_(seed) {
  // Far from that of the seed before. The factor is a prime that does not divide their number.
  std::uint64_t order = seed % orders() * 100'003 % orders();
  const auto one_of = [&order](std::uint64_t count) {
    const std::uint64_t which = order % count;
    order /= count;
    return which;
  };
  method_ = of_method()[one_of(of_method().size())];
  controller_ = of_controller()[one_of(of_controller().size())];
  shape_ = static_cast<Shape>(one_of(4));
  reader_ = chance_(2) == 0;
  second_event_ = asked_by_controller() && chance_(8) == 0;
  frames_ = chance_(3) == 0;
}

std::uint64_t SmallSkill::orders() {
  return of_method().size() * of_controller().size() * 4;
}

std::vector<SmallSkill::Order> SmallSkill::orders_of(int things, int most) {
  std::vector<Order> all = {{}};
  for (std::size_t from = 0; most > 0; --most) {
    const std::size_t until = all.size();
    for (; from < until; ++from) {
      for (int thing = 0; thing < things; ++thing) {
        Order longer = all[from];
        if (std::find(longer.begin(), longer.end(), thing) != longer.end()) continue;
        longer.push_back(thing);
        all.push_back(std::move(longer));
      }
    }
  }
  return all;
}

const std::vector<SmallSkill::Order>& SmallSkill::of_method() {
  static const std::vector<Order> all = orders_of(8, 3);
  return all;
}

const std::vector<SmallSkill::Order>& SmallSkill::of_controller() {
  static const std::vector<Order> all = orders_of(6, 3);
  return all;
}

std::string SmallSkill::ask(const std::string& message, const std::string& server, bool may_give_up) {
  const std::string what = message + " from " + server;
  const std::string request = "TXM( request " + what + " )\nWTM( " + what + " )";
  if (!may_give_up || chance_(10) > 0) return request + "\n";
  return request + " WITHIN " + chance_.one_of({"2", "6", "15"}) +
         " ms\nDo Nothing\nELSE\nDo Nothing\nEND WTM\n";
}

std::string SmallSkill::last() {
  const std::string once_more = chance_(3) == 0 ? "RPC( c )\nwork\n" : "";
  return "last\n" + once_more + complete;
}

std::string SmallSkill::thing_of_method(int which) {
  const auto senses = [this] {
    sensor_ = true;
    return ask("s", "LS1", shape_ != Shape::method_asks);
  };
  switch (which) {
    case 0:
      return "RPC( c )\nwork\n";
    case 1:
      return "SPC( m )\n";
    case 2:
      return branch("over", complete);
    case 3:
      return branch("over", last());
    case 4:
      return branch("more", "work\n");
    case 5:
      return branch("more", "SPC( m )\n");
    case 6:
      return senses();
    default:
      return chance_(2) == 0 ? branch("over", senses() + last()) : branch("more", senses());
  }
}

std::string SmallSkill::sample() {
  device_ = true;
  return ask("sample", "probe", asked_by_controller());
}

std::string SmallSkill::thing_of_controller(int which) {
  switch (which) {
    case 0:
      return "act\n";
    case 1:
      return "SPC( c )\n";
    case 2:
      return branch("extra", "act\n");
    case 3:
      return branch("extra", "SPC( c )\n");
    case 4:
      return sample();
    default:
      return branch("extra", sample());
  }
}

std::string SmallSkill::method_round() {
  std::vector<std::string> parts;
  for (int each : method_) parts.push_back(thing_of_method(each));
  const bool asks = shape_ == Shape::method_asks;
  std::string talk = asks ? ask("k", "MC1", false) : "TXM( k to MC1 )\n";
  if (asks && chance_(6) == 0) talk += "work\n" + talk;
  if (asks && chance_(6) == 0) talk = branch("more", talk) + talk;
  parts.insert(parts.begin() + chance_(static_cast<int>(parts.size()) + 1), talk);
  return together(parts);
}

std::string SmallSkill::controller_round() {
  std::vector<std::string> parts;
  for (int each : controller_) parts.push_back(thing_of_controller(each));
  const bool asks = asked_by_controller();
  std::string talk = asks ? ask("k", "SM1", true) : "TXM( k to SM1 )\n";
  if (asks && chance_(6) == 0) talk = branch("asks", talk);
  // An answer comes last, mostly: then one round is over before the next is asked for.
  const auto after = static_cast<std::ptrdiff_t>(parts.size());
  const bool anywhere = asks || chance_(4) == 0;
  parts.insert(parts.begin() + (anywhere ? chance_(static_cast<int>(after) + 1) : after), talk);
  parts.insert(chance_(3) == 0 ? parts.begin() : parts.end() - (asks ? 0 : 1), "RPC( m )\nuse\n");
  // A thread that goes on by itself needs something that lasts in every round.
  if (!asks) parts.insert(parts.begin(), sample());
  return together(parts);
}

std::string SmallSkill::before_rounds() {
  std::string out;
  if (chance_(4) == 0) out += "work\n";
  if (chance_(5) == 0) out += branch("over", last());
  if (chance_(6) == 0) out += "SPC( m )\n";
  if (sensor_ && chance_(6) == 0) out += ask("s", "LS1", true);
  return out;
}

std::string SmallSkill::method() {
  const std::string done = method_round();
  const std::string first = before_rounds();
  std::string out =
      "Skill Module: SM1\n  ACTIVITY work\n  ACTIVITY last\n  ACTIVITY serve\nBEGIN\nWTM( Coordinator )\n";
  switch (shape_) {
    case Shape::controller_asks:
      out += first + repeat("WTM( request k from MC1 )\n" + done);
      break;
    case Shape::method_asks:
      out += first + repeat(done);
      break;
    case Shape::two_ask:
      out += first + repeat("WTM FIRST\n( request k from MC1 ):\n" + done +
                            "( request o from MC2 ):\nserve\nTXM( o to MC2 )\nEND WTM\n");
      break;
    case Shape::blocks:
      out += first + method_of_blocks("WTM( request k from MC1 )\n" + done);
      break;
  }
  return out + "END\n";
}

std::string SmallSkill::method_of_blocks(const std::string& round) {
  const bool leaves = chance_(2) == 0;
  std::string other = "WTM( request o from MC2 )\n";
  if (leaves) other += "SPC( over )\n";
  other = repeat(other + "serve\nTXM( o to MC2 )\n", leaves ? "over" : "forever");
  if (leaves && chance_(2) == 0) other += "last\n";
  if (leaves && chance_(4) == 0) other += "SPC( m )\n";
  std::string out = "CONCURRENT\nBEGIN\n" + repeat(round) + "END\nBEGIN\n" + other + "END\nEND CONCURRENT\n";
  if (leaves) out += (chance_(2) == 0 ? "work\n" : "") + complete;
  return out;
}

std::string SmallSkill::controllers() {
  std::string out = "Machine Controller: MC1\n  ACTIVITY act\n  ACTIVITY use\nBEGIN\n";
  if (chance_(5) == 0) out += "SPC( c )\n";
  const std::string round = controller_round();
  if (second_event_) {
    const std::string other =
        chance_.one_of({"act\n", "use\n", "SPC( c )\nuse\n", "RPC( m )\nuse\nSPC( c )\n"});
    out += repeat("WTM FIRST\n( t from d ):\n" + round + "( u from e ):\n" + other + "END WTM\n");
  } else {
    out += repeat((asked_by_controller() ? "WTM( t from d )\n" : "WTM( request k from SM1 )\n") + round);
  }
  out += "END\n";
  if (two_controllers()) {
    const std::string talk = ask("o", "SM1", true);
    const std::string done = chance_(2) == 0 ? "used\n" + talk : talk + "used\n";
    out += "Machine Controller: MC2\n  ACTIVITY used\nBEGIN\n" +
           repeat("WTM( v from f )\nRPC( c )\n" + done) + "END\n";
  }
  if (reader_)
    out += "Machine Controller: MR\n  ACTIVITY look\nBEGIN\n" +
           repeat("WTM( w from g )\nRPC( m )\nRPC( c )\nlook\n") + "END\n";
  return out;
}

std::string SmallSkill::sensor() {
  if (!sensor_) return "";
  const std::string answer = "TXM( s to SM1 )\n";
  return "Logical Sensor: LS1\n  ACTIVITY sense\nBEGIN\n" +
         repeat("WTM( request s from SM1 )\n" + (chance_(4) == 0 ? answer + "sense\n" : "sense\n" + answer)) +
         "END\n";
}

std::string SmallSkill::declarations() const {
  std::string out = "MESSAGE k : SIGNAL\n";
  const auto device = [&out](const std::string& message, const std::string& name) {
    out += "MESSAGE " + message + " : SIGNAL\nDEVICE " + name + "\n";
  };
  if (asked_by_controller()) device("t", "d");
  if (second_event_) device("u", "e");
  if (two_controllers()) device("v", "f");
  if (reader_) device("w", "g");
  if (device_) device("sample", "probe");
  if (two_controllers()) out += "MESSAGE o : SIGNAL\n";
  if (sensor_) out += "MESSAGE s : SIGNAL\n";
  for (const char* each : {"m", "c", "over", "more", "extra", "asks"})
    out += std::string("CONDITION ") + each + "\n";
  out += "SKILL small\n  SKILL METHOD SM1\n  MACHINE CONTROLLER MC1\n";
  if (two_controllers()) out += "  MACHINE CONTROLLER MC2\n";
  if (reader_) out += "  MACHINE CONTROLLER MR\n";
  if (sensor_) out += "  LOGICAL SENSOR LS1\n";
  return out + "  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n" + requirements() + "END SKILL\n";
}

std::string SmallSkill::requirements() const {
  std::vector<std::string> all = {"LOAD OF EACH PROCESSOR AT MOST 90 %"};
  const auto event = [&all](const std::string& message, const std::string& device, const std::string& at) {
    all.push_back("LOSS OF " + device + " AT MOST 7 IN 8");
    all.push_back("RESPONSE FROM " + message + " OF " + device + " TO " + at + " AT MOST 900 ms");
  };
  const auto known = [&all](const std::string& what, const std::string& at) {
    for (const std::string measure : {"AGE", "REACTION"})
      all.push_back(measure + " OF " + what + " AT " + at + " AT MOST 900 ms");
  };
  const std::string use = "use IN MC1";
  all.push_back("INTERVAL OF " + use + " AT MOST 900 ms");
  known("m", use);
  if (asked_by_controller()) {
    event("t", "d", use);
    known("t FROM d", use);
  }
  if (second_event_) {
    event("u", "e", use);
    known("u FROM e", use);
  }
  if (device_) known("sample FROM probe", use);
  if (device_ && frames_) all.push_back("LOSS OF probe AT MOST 7 IN 8");
  if (std::find(method_.begin(), method_.end(), 0) != method_.end()) {
    all.push_back("INTERVAL OF work IN SM1 AT MOST 900 ms");
    known("c", "work IN SM1");
    if (asked_by_controller()) known("t FROM d", "work IN SM1");
  }
  if (two_controllers()) {
    all.push_back("INTERVAL OF used IN MC2 AT MOST 900 ms");
    event("v", "f", "used IN MC2");
    known("c", "used IN MC2");
  }
  if (reader_) {
    known("m", "look IN MR");
    known("c", "look IN MR");
  }
  std::string out;
  for (std::size_t n = 0; n < all.size(); ++n)
    out += "  REQUIREMENT r" + std::to_string(n) + " : " + all[n] + "\n";
  return out;
}

std::string SmallSkill::environment() {
  const int processors = chance_.between(1, 3);
  std::string out = "ENVIRONMENT cell\n";
  for (int p = 1; p <= processors; ++p)
    out += "  PROCESSOR P" + std::to_string(p) + (chance_(7) == 0 ? " NONPREEMPTIVE\n" : "\n");
  const auto place = [&](const std::string& thread) {
    out += "  PLACE " + thread + " ON P" + std::to_string(chance_.between(1, processors));
    out += " PRIORITY " + std::to_string(chance_.between(1, 3)) + "\n";
  };
  const auto time = [&](const std::string& activity) {
    out += "  TIME " + activity + " : " + chance_.one_of({"0.5", "1", "2", "0 TO 1", "1 TO 2"}) + " ms\n";
  };
  const auto event = [&](const std::string& message, const std::string& device) {
    out += "  DEVICE " + device + " EVENT " + message + " EVERY " + chance_.one_of({"10", "20", "28", "50"}) +
           " ms";
    out += chance_(6) == 0 ? " JITTER 2 ms\n" : "\n";
  };
  place("SM1");
  if (shape_ == Shape::blocks) {
    place("SM1.1");
    place("SM1.2");
  }
  place("MC1");
  for (const char* each : {"work", "act", "use"}) time(each);
  out += "  TIME last : " + chance_.one_of({"5", "15", "0 TO 35", "40"}) + " ms\n  TIME serve : 1 ms\n";
  if (asked_by_controller()) event("t", "d");
  if (second_event_) event("u", "e");
  if (two_controllers()) {
    place("MC2");
    time("used");
    event("v", "f");
  }
  if (reader_) {
    place("MR");
    out += "  TIME look : 1 ms\n";
    event("w", "g");
  }
  if (sensor_) {
    place("LS1");
    time("sense");
  }
  const std::vector<std::string> times = asked_by_controller()
                                             ? std::vector<std::string>{"1", "5", "0 TO 3"}
                                             : std::vector<std::string>{"10", "20", "8 TO 12"};
  if (device_) out += "  DEVICE probe ";
  if (device_ && frames_)
    out += "FRAMES EVERY " + chance_.one_of({"7", "10", "20"}) + " ms COLLECTING 3 ms\n";
  if (device_ && !frames_) out += "ON REQUEST " + chance_.one_of(times) + " ms\n";
  if (chance_(8) == 0) out += "  LATENCY BETWEEN PROCESSORS 0 TO 2 ms\n";
  return out + "END ENVIRONMENT\n";
}

std::string SmallSkill::text() {
  std::string modules = method();
  modules += controllers();
  modules += sensor();
  return declarations() + modules + environment();
}

}  // namespace pal::test
