#include "tests/support/lone_skill.hpp"

#include <vector>

#include "tests/support/branch.hpp"

namespace pal::test {
namespace {

const std::string complete = "TXM( Completion Protocol 0 )\n";

}  // namespace

LoneSkill::LoneSkill(std::uint64_t seed)
    : chance_(seed),
      blocks_(chance_(3) == 0 ? 2 : 0),
      clocks_(chance_.between(1, 2)),
      reader_(chance_(2) == 0) {}

std::string LoneSkill::ask(int which) {
  asked_.insert(which);
  const std::string n = std::to_string(which);
  const std::string what = "s" + n + " from LS" + n;
  const std::string request = "TXM( request " + what + " )\nWTM( " + what + " )";
  if (chance_(40) > 0) return request + "\n";
  return request + " WITHIN " + chance_.one_of({"2", "6", "15"}) + " ms\nDo Nothing\nELSE\n" + thing() +
         "END WTM\n";
}

std::string LoneSkill::thing() {
  switch (chance_(8)) {
    case 0:
      return "work\n";
    case 1:
    case 2:
      return "RPC( c" + std::to_string(chance_.between(1, clocks_)) + " )\nuse\n";
    case 3:
      return "use\n";
    case 4:
      return "SPC( m )\n";
    case 5:
      return branch("more", thing());
    default:
      return ask(chance_(10) == 0 ? own_ : own_ + chance_.between(1, 2));
  }
}

std::string LoneSkill::things(int least, int most) {
  std::string out;
  for (int n = chance_.between(least, most); n > 0; --n) out += thing();
  return out;
}

std::string LoneSkill::ending() {
  return branch("over", (chance_(3) == 0 ? "last\n" : "") + things(0, 3) + complete);
}

std::string LoneSkill::round() {
  std::string out = ask(own_);
  out.insert(chance_(2) == 0 ? 0 : out.size(), things(0, 2));
  if (chance_(8) == 0) out += ending();
  out += "RPC( c1 )\nuse\n" + things(0, 1);
  return chance_(3) > 0 ? out + ending() : out;
}

std::string LoneSkill::life(const std::string& condition) {
  const bool leaves = chance_(blocks_ == 0 ? 6 : 3) == 0;
  std::string out = things(0, 2);
  if (chance_(6) == 0) out += ending();
  std::string done = round();
  if (leaves) done += "SPC( " + condition + " )\n";
  out += "REPEAT\n" + done + "UNTIL( " + (leaves ? condition : "forever") + " )\n";
  return leaves ? out + (chance_(2) == 0 ? "last\n" : "") + things(0, 3) : out;
}

std::string LoneSkill::method() {
  std::string out =
      "Skill Module: SM1\n  ACTIVITY work\n  ACTIVITY use\n  ACTIVITY last\nBEGIN\nWTM( Coordinator )\n";
  if (blocks_ == 0) return out + life("left") + complete + "END\n";
  out += things(0, 1) + "CONCURRENT\n";
  for (int n = 1; n <= blocks_; ++n) {
    own_ = 3 * n + 1;
    out += "BEGIN\n" + life("left" + std::to_string(n)) + "END\n";
  }
  return out + "END CONCURRENT\n" + things(0, 2) + complete + "END\n";
}

std::string LoneSkill::controllers() const {
  std::string out;
  for (int n : asked_) out += "Logical Sensor: LS" + std::to_string(n) + "\n";
  for (int c = 1; c <= clocks_; ++c) {
    const std::string n = std::to_string(c);
    out += "Machine Controller: MC" + n + "\nBEGIN\nREPEAT\nWTM( t" + n + " from clock" + n + " )\nSPC( c" +
           n + " )\nUNTIL( forever )\nEND\n";
  }
  if (reader_)
    out +=
        "Machine Controller: MR\n  ACTIVITY look\nBEGIN\nREPEAT\nWTM( w from eye )\nRPC( m )\nlook\nUNTIL( "
        "forever )\nEND\n";
  return out;
}

std::string LoneSkill::requirements(const std::string& method) const {
  std::vector<std::string> all = {"LOAD OF EACH PROCESSOR AT MOST 90 %",
                                  "DURATION TO COMPLETION 0 AT MOST 900 ms"};
  const auto known = [&all](const std::string& what, const std::string& at) {
    for (const std::string measure : {"AGE", "REACTION"})
      all.push_back(measure + " OF " + what + " AT " + at + " AT MOST 900 ms");
  };
  for (const std::string activity : {"use", "work", "last"}) {
    if (method.find("\n" + activity + "\n") == std::string::npos) continue;
    const std::string at = activity + " IN SM1";
    all.push_back("INTERVAL OF " + at + " AT MOST 900 ms");
    all.push_back("INTERVAL OF " + at + " AT LEAST 1 ms");
    for (int n = 1; n <= clocks_; ++n) known("c" + std::to_string(n), at);
    known("t1 FROM clock1", at);
    for (int n : asked_) known("s" + std::to_string(n) + " FROM LS" + std::to_string(n), at);
  }
  if (reader_) known("m", "look IN MR");
  for (int n : asked_) all.push_back("LOSS OF LS" + std::to_string(n) + " AT MOST 7 IN 8");
  all.push_back("LOSS OF clock1 AT MOST 7 IN 8");
  std::string out;
  for (std::size_t n = 0; n < all.size(); ++n)
    out += "  REQUIREMENT r" + std::to_string(n) + " : " + all[n] + "\n";
  return out;
}

std::string LoneSkill::environment() {
  const int processors = chance_.between(1, 3);
  std::string out = "ENVIRONMENT cell\n";
  for (int p = 1; p <= processors; ++p)
    out += "  PROCESSOR P" + std::to_string(p) + (chance_(7) == 0 ? " NONPREEMPTIVE\n" : "\n");
  const auto place = [&](const std::string& thread) {
    out += "  PLACE " + thread + " ON P" + std::to_string(chance_.between(1, processors)) + " PRIORITY " +
           std::to_string(chance_.between(1, 3)) + "\n";
  };
  const auto event = [&](const std::string& message, const std::string& device) {
    out += "  DEVICE " + device + " EVENT " + message + " EVERY " + chance_.one_of({"5", "10", "28", "50"}) +
           " ms" + (chance_(6) == 0 ? " JITTER 2 ms\n" : "\n");
  };
  place("SM1");
  for (int n = 1; n <= blocks_; ++n) place("SM1." + std::to_string(n));
  for (int c = 1; c <= clocks_; ++c) {
    const std::string n = std::to_string(c);
    place("MC" + n);
    event("t" + n, "clock" + n);
  }
  if (reader_) {
    place("MR");
    event("w", "eye");
    out += "  TIME look : 1 ms\n";
  }
  for (int n : asked_) {
    out += "  DEVICE LS" + std::to_string(n);
    out += chance_(4) == 0 ? " FRAMES EVERY " + chance_.one_of({"7", "10", "20"}) + " ms COLLECTING 3 ms\n"
                           : " ON REQUEST " + chance_.one_of({"1", "10", "13", "2 TO 8"}) + " ms\n";
  }
  for (const char* each : {"work", "use"})
    out += std::string("  TIME ") + each + " : " + chance_.one_of({"0.5", "1", "2", "0 TO 1"}) + " ms\n";
  out += "  TIME last : " + chance_.one_of({"5", "15", "0 TO 35", "40"}) + " ms\n";
  if (chance_(8) == 0) out += "  LATENCY BETWEEN PROCESSORS 0 TO 2 ms\n";
  return out + "END ENVIRONMENT\n";
}

std::string LoneSkill::text() {
  std::string out;
  const auto device = [&out](const std::string& message, const std::string& name) {
    out += "MESSAGE " + message + " : SIGNAL\nDEVICE " + name + "\n";
  };
  const std::string does = method();
  for (int n = 1; n <= clocks_; ++n) device("t" + std::to_string(n), "clock" + std::to_string(n));
  if (reader_) device("w", "eye");
  for (int n : asked_) out += "MESSAGE s" + std::to_string(n) + " : SIGNAL\n";
  for (const char* each : {"m", "over", "more", "left", "left1", "left2", "c1", "c2"})
    out += std::string("CONDITION ") + each + "\n";
  out += "SKILL lone\n  SKILL METHOD SM1\n";
  for (int n = 1; n <= clocks_; ++n) out += "  MACHINE CONTROLLER MC" + std::to_string(n) + "\n";
  if (reader_) out += "  MACHINE CONTROLLER MR\n";
  for (int n : asked_) out += "  LOGICAL SENSOR LS" + std::to_string(n) + "\n";
  out += "  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n" + requirements(does) + "END SKILL\n";
  return out + does + controllers() + environment();
}

}  // namespace pal::test
