// The workcell and its times.
#include "tests/support/odd_skill.hpp"

namespace pal::test {

std::string OddSkill::environment() {
  std::string out = "ENVIRONMENT cell\n";
  out += processors(4);
  for (const Module& module : modules_) {
    out += place(module.name, 4);
    for (int i = 1; i <= 3; ++i)
      out += "  TIME w" + std::to_string(i) + module.name + " : " +
             chance_.interval(chance_(4) == 0 ? 0 : 1, 2) + "\n";
  }
  for (const Module& module : modules_)
    out += "  TIME p" + module.name + " : " + chance_.interval(chance_(4) == 0 ? 1 : 10, 50) + "\n";
  if (contingency_) {
    for (int i = 1; i <= 3; ++i)
      out += "  TIME w" + std::to_string(i) + "CM1 : " + chance_.interval(0, 2) + "\n";
  }
  out += places_of_blocks(4);
  if (chance_(3) == 0) {
    const int period = chance_.between(4, 12);
    out += "  DEVICE sensor FRAMES EVERY " + std::to_string(period) + " ms COLLECTING " +
           std::to_string(chance_.between(1, period)) + " ms\n";
  } else {
    out += "  DEVICE sensor ON REQUEST " + chance_.interval(chance_(4) == 0 ? 0 : 1, 4) + "\n";
  }
  const auto event = [&](const std::string& device, const std::string& message) {
    const int period = chance_(3) == 0 && !calm_ ? chance_.between(15, 40) : chance_.between(40, 150);
    out += "  DEVICE " + device + " EVENT " + message + (chance_(5) == 0 ? " SPORADIC " : " EVERY ") +
           std::to_string(period) + " ms";
    if (chance_(3) == 0) out += " JITTER " + std::to_string(chance_.between(1, period - 1)) + " ms";
    if (chance_(4) == 0 && out.rfind(" SPORADIC ") < out.rfind(" DEVICE "))
      out += " PHASE " + std::to_string(chance_.between(0, period - 1)) + " ms";
    out += "\n";
  };
  event("robot", "tick");
  event("hand", "tock");
  out += costs_and_latencies();
  return out + "END ENVIRONMENT\n";
}

}  // namespace pal::test
