#include "tests/support/nested_skill.hpp"

#include <algorithm>
#include <utility>

namespace pal::test {

std::string NestedSkill::text() {
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

std::string NestedSkill::upper(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return text;
}

NestedSkill::Module& NestedSkill::module(const std::string& name) {
  for (Module& each : modules_) {
    if (each.name == name) return each;
  }
  return modules_.front();
}

void NestedSkill::serves(const std::string& server, const std::string& client, const std::string& message) {
  messages_.push_back(message);
  module(server).items.push_back({Item::Kind::take, message, client, true});
  module(client).items.push_back({Item::Kind::call, message, server, false});
}

void NestedSkill::sends(const std::string& from, const std::string& to, const std::string& message) {
  messages_.push_back(message);
  module(from).items.push_back({Item::Kind::send, message, to, false});
  module(to).items.push_back({Item::Kind::take, message, from, false});
}

void NestedSkill::takes(const std::string& name, const std::string& message, const std::string& device) {
  module(name).items.push_back({Item::Kind::take, message, device, false});
}

void NestedSkill::draw() {
  modules_ = {{"Sensor Driver", "SD1", {}}, {"Logical Sensor", "LS1", {}}, {"Machine Controller", "MC1", {}}};
  if (chance_(2) == 0) modules_.push_back({"Logical Sensor", "LS2", {}});
  const bool second = chance_(2) == 0;
  if (second) modules_.push_back({"Machine Controller", "MC2", {}});
  modules_.push_back({"Skill Module", "SM1", {}});
  messages_ = {"tick", "tock", "tack", "value"};
  takes("MC1", "tick", "robot");
  takes(second ? "MC2" : "MC1", "tock", "hand");
  tack_ = chance_(2) == 0;
  value_ = chance_(2) == 0;
  if (tack_) {
    takes("SD1", "tack", "foot");
    sends("SD1", "LS1", "raw");
  } else {
    serves("SD1", "LS1", "raw");
  }
  if (value_) module("SD1").items.push_back({Item::Kind::call, "value", "sensor", false});
  const auto link = [this](const std::string& one, const std::string& message) {
    switch (chance_(4)) {
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
  if (chance_(2) == 0) {
    sends("LS1", "SM1", "force");
  } else {
    link("LS1", "force");
  }
  link("MC1", "motion");
  if (chance_(2) == 0) link("MC1", "go");
  if (modules_[3].name == "LS2") link("LS2", "slide");
  if (second) link("MC2", "grip");
}

std::string NestedSkill::say(const Module& in, const std::string& statement, const std::string& indent) {
  said_.emplace_back(in.name, statement);
  return indent + statement + "\n";
}

std::string NestedSkill::work(const Module& in, const std::string& indent) {
  return say(in, "w" + std::to_string(chance_.between(1, 3)) + in.name, indent);
}

std::string NestedSkill::any_module() {
  return modules_[static_cast<std::size_t>(chance_(static_cast<int>(modules_.size())))].name;
}

std::string NestedSkill::small(const Module& in, const std::string& indent) {
  switch (chance_(8)) {
    case 0:
      return say(in, "SPC( c" + in.name + " )", indent);
    case 1:
      return indent + "SPC( c" + in.name + (chance_(2) == 0 ? " = TRUE )\n" : " = FALSE )\n");
    case 2:
    case 3:
      return say(in, "RPC( c" + any_module() + " )", indent);
    default:
      return work(in, indent);
  }
}

std::string NestedSkill::smalls(const Module& in, int most, const std::string& indent) {
  std::string out;
  for (int i = chance_.between(0, most); i > 0; --i) out += small(in, indent);
  return out;
}

std::string NestedSkill::choice(const Module& in, const std::string& yes, const std::string& no,
                                const std::string& indent) {
  const std::string c = "c" + (chance_(3) == 0 ? any_module() : in.name);
  return indent + "CASE\n" + indent + "  ( " + c + " ):\n" + yes + indent + "  ( NOT " + c + " ):\n" + no +
         indent + "END CASE\n";
}

std::string NestedSkill::wait(const Module& in, const std::string& message, const std::string& then,
                              const std::string& indent) {
  if (!odd(Odd::limits, 3)) return say(in, "WTM( " + message + " )", indent) + then;
  said_.emplace_back(in.name, "WTM( " + message + " )");
  const std::string limit = std::to_string(chance_(4) == 0 ? 0 : chance_.between(1, 30));
  return indent + "WTM( " + message + " ) WITHIN " + limit + " ms\n" +
         (then.empty() ? indent + "  Do Nothing\n" : then) + indent + "ELSE\n" + small(in, indent + "  ") +
         indent + "END WTM\n";
}

}  // namespace pal::test
