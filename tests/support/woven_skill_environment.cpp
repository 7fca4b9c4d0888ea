// The workcell and its times.
#include "tests/support/woven_skill.hpp"

namespace pal::test {

std::string WovenSkill::environment() {
  std::string out = "ENVIRONMENT cell\n";
  out += processors(3);
  for (const Module& module : modules_) {
    out += place(module.name, 5);
    for (int i = 1; i <= 3; ++i)
      out += "  TIME w" + std::to_string(i) + module.name + " : " +
             chance_.interval(chance_(8) == 0 ? 0 : 1, chance_(6) == 0 ? 8 : 2) + "\n";
  }
  out += places_of_blocks(5);
  const std::string sensor = drives_ ? "sensor" : "SD1";
  if (chance_(4) == 0) {
    const int period = chance_.between(5, 15);
    out += "  DEVICE " + sensor + " FRAMES EVERY " + std::to_string(period) + " ms COLLECTING " +
           std::to_string(chance_.between(1, period)) + " ms\n";
  } else {
    out += "  DEVICE " + sensor + " ON REQUEST " +
           chance_.interval(chance_(8) == 0 ? 0 : 1, chance_(3) == 0 ? 12 : 4) + "\n";
  }
  const auto event = [&](const std::string& device, const std::string& message) {
    const int period = calm_             ? chance_.between(50, 250)
                       : chance_(3) == 0 ? chance_.between(8, 30)
                                         : chance_.between(25, 120);
    out += "  DEVICE " + device + " EVENT " + message + (chance_(6) == 0 ? " SPORADIC " : " EVERY ") +
           std::to_string(period) + " ms";
    if (chance_(3) == 0) out += " JITTER " + std::to_string(chance_.between(1, period - 1)) + " ms";
    out += "\n";
  };
  event("robot", "tick");
  event("hand", "tock");
  out += costs_and_latencies();
  return out + "END ENVIRONMENT\n";
}

}  // namespace pal::test
