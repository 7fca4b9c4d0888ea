// Which modules talk to which.
#include "tests/support/odd_skill.hpp"

namespace pal::test {

OddSkill::OddSkill(std::uint64_t seed, bool calm) : DrawnSkill(seed), calm_(calm) {
  for (int& each : odd_) each = chance_(calm ? 15 : 3);
}

std::string OddSkill::text() {
  draw();
  std::string bodies;
  for (Module& module : modules_) bodies += body(module);
  if (contingency_) bodies += contingency();
  std::string out = declarations() + "DEVICE sensor\nSKILL odd\n";
  out += "  SENSOR DRIVER SD1\n  LOGICAL SENSOR LS1\n  MACHINE CONTROLLER MC1" +
         std::string(second_ ? ", MC2" : "") + "\n  SKILL METHOD SM1\n";
  if (contingency_) out += "  CONTINGENCY 1 \"no\" METHOD CM1\n";
  out += "  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n";
  out += requirements() + "END SKILL\n";
  return out + bodies + environment();
}

void OddSkill::draw() {
  second_ = chance_(2) == 0;
  contingency_ = odd(Odd::executes, 1);
  modules_.push_back({"Sensor Driver", "SD1"});
  modules_.push_back({"Logical Sensor", "LS1"});
  modules_.push_back({"Machine Controller", "MC1"});
  if (second_) modules_.push_back({"Machine Controller", "MC2"});
  modules_.push_back({"Skill Module", "SM1"});
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

void OddSkill::calm_links() {
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

}  // namespace pal::test
