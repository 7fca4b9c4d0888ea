// Which modules talk to which.
#include "tests/support/woven_skill.hpp"

namespace pal::test {

namespace {

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return text;
}

}  // namespace

std::string WovenSkill::text() {
  draw();
  std::string bodies;
  for (Module& module : modules_) bodies += body(module);
  std::string out = declarations();
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

void WovenSkill::draw() {
  drives_ = chance_(3) == 0;
  const bool second_sensor = chance_(3) == 0;
  const bool second_machine = chance_(2) == 0;
  if (drives_) modules_.push_back({"Sensor Driver", "SD1"});
  modules_.push_back({"Logical Sensor", "LS1"});
  if (second_sensor) modules_.push_back({"Logical Sensor", "LS2"});
  modules_.push_back({"Machine Controller", "MC1"});
  if (second_machine) modules_.push_back({"Machine Controller", "MC2"});
  modules_.push_back({"Skill Module", "SM1"});
  messages_ = {"tick", "tock", "correction"};
  module("MC1").triggers.push_back({"tick from robot", chance_(3) != 0 ? "TXM( correction to robot )" : ""});
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

}  // namespace pal::test
