// The workcell and its times.
#include "tests/support/random_cell.hpp"

namespace pal::test {

std::string RandomCell::place(const std::string& thread, int processors) {
  return "  PLACE " + thread + " ON P" + std::to_string(chance_(processors)) + " PRIORITY " +
         std::to_string(chance_.between(1, 3)) + "\n";
}

std::string RandomCell::event(const std::string& device, const std::string& message, bool answer) {
  const int period = chance_.between(longest_ / 2 + 1, longest_);
  const bool odd = asks_ == Asks::all;
  const bool sporadic = chance_(8) == 0 || (odd && required_() % 5 == 0);
  std::string out =
      "  DEVICE " + device + " EVENT " + message + (sporadic ? " SPORADIC " : " EVERY ") + ms(period);
  int jitter = 0;
  if (period > 1 && odd && required_() % 6 == 0) {
    jitter = period - 1;
  } else if (chance_(4) == 0 && period > 1) {
    jitter = chance_.between(1, period - 1);
  }
  if (jitter > 0) out += " JITTER " + ms(jitter);
  if (!sporadic && chance_(3) == 0) out += " PHASE " + ms(chance_.between(0, period - 1));
  if (answer && chance_(3) == 0) out += " ANSWER correction WITHIN " + ms(period - jitter);
  return out + "\n";
}

std::string RandomCell::environment() {
  std::string out = "ENVIRONMENT cell\n";
  const int processors = chance_.between(1, 3);
  for (int p = 0; p < processors; ++p)
    out += "  PROCESSOR P" + std::to_string(p) + (chance_(4) == 0 ? " NONPREEMPTIVE\n" : "\n");
  if (!lonely_) {
    if (sensor_ == 2) {
      out += event("SD1", "raw", false);
    } else {
      const std::string device = sensor_ == 3 ? "gauge" : "SD1";
      if (sensor_ == 1 || chance_(3) == 0) {
        const int period = chance_.between(1, longest_);
        out += "  DEVICE " + device + " FRAMES EVERY " + ms(period) + " COLLECTING " +
               ms(chance_.between(1, period)) +
               (chance_(3) == 0 ? " PHASE " + ms(chance_.between(0, period - 1)) : std::string()) + "\n";
      } else {
        out += "  DEVICE " + device + " ON REQUEST " + chance_.interval(0, longest_ / 2, 3) + "\n";
      }
    }
  }
  out += controller_ ? event("robot", "tick", true) : event("MC1", "motion request", false);
  out += place("SM1", processors);
  if (!lonely_) out += place("LS1", processors);
  if (!lonely_ && sensor_ == 3) out += place("SD1", processors);
  if (controller_) out += place("MC1", processors);
  for (const char* thread : {"CM1.1", "CM1.2", "SM1.1/CM1.1", "SM1.2/CM1.2", "SM1.2/CM1.1"}) {
    if (!blocks_ || executed_() % 3 != 0) continue;
    out += std::string("  PLACE ") + thread + " ON P" +
           std::to_string(executed_() % static_cast<std::uint64_t>(processors)) + " PRIORITY " +
           std::to_string(1 + executed_() % 3) + "\n";
  }
  for (const char* activity : {"extract", "think", "prepare", "obey", "filter", "recover"}) {
    if (activity[0] == 'e' && lonely_) continue;
    if (activity[0] == 'f' && (lonely_ || sensor_ != 3)) continue;
    if (activity[0] == 'o' && !controller_) continue;
    out += std::string("  TIME ") + activity + " : " + chance_.interval(0, 2, 3) + "\n";
  }
  for (const char* cost : {"SEND", "RECEIVE", "SET", "READ", "TEST"}) {
    if (chance_(3) == 0) out += std::string("  COST ") + cost + " " + chance_.interval(0, 1, 3) + "\n";
  }
  if (chance_(3) == 0) out += "  LATENCY WITHIN PROCESSOR " + chance_.interval(0, 1, 3) + "\n";
  if (chance_(2) == 0) out += "  LATENCY BETWEEN PROCESSORS " + chance_.interval(0, 2, 3) + "\n";
  return out + "END ENVIRONMENT\n";
}

}  // namespace pal::test
