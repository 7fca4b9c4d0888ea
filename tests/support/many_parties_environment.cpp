#include "tests/support/many_parties.hpp"

#include <algorithm>
#include <utility>

namespace pal::test {

std::string ManyParties::at() {
  const auto& [module, statement] = said_[static_cast<std::size_t>(chance_(static_cast<int>(said_.size())))];
  return statement + " IN " + module;
}

std::string ManyParties::requirements() {
  std::string out;
  const auto add = [&](int number, const std::string& what) {
    out += "  REQUIREMENT r" + std::to_string(number) + " : " + what + "\n";
  };
  const std::string most = " AT MOST " + ms(2 + chance_(10));
  for (int n = 0; n < 5; ++n) {
    const Asked& device = devices_[static_cast<std::size_t>(chance_(2))];
    switch (chance_(10)) {
      case 0:
      case 1:
        add(n, "RESPONSE FROM " + put() + " TO " + at() + most);
        break;
      case 2:
        add(n, "AGE OF " + chance_.one_of({"c", "e", "f"}) + " AT " + at() + most);
        break;
      case 3:
        add(n, "REACTION OF " + chance_.one_of({"c", "e", "f"}) + " AT " + at() + most);
        break;
      case 4:
        add(n, "AGE OF " + device.message + " FROM " + device.device + " AT " + at() + most);
        break;
      case 5:
        add(n, "REACTION OF " + device.message + " FROM " + device.device + " AT " + at() + most);
        break;
      case 6:
        add(n, "INTERVAL OF " + at() + " BETWEEN " + ms(1 + chance_(4)) + " AND " + ms(5 + chance_(8)));
        break;
      case 7:
        add(n, "LOSS OF " + device.device + " AT MOST " + std::to_string(1 + chance_(2)) + " IN " +
                   std::to_string(3 + chance_(2)));
        break;
      case 8:
        add(n, loops_ || chance_(4) == 0 ? "DURATION TO COMPLETION 1" + most
                                         : "DURATION TO COMPLETION 0" + most);
        break;
      default:
        add(n, "BUSY PERIOD OF EACH PROCESSOR" + most);
    }
  }
  return out;
}

std::string ManyParties::environment() {
  const int processors = 1 + chance_(3);
  std::string out = "ENVIRONMENT cell\n";
  for (int p = 0; p < processors; ++p)
    out += "  PROCESSOR P" + std::to_string(p) + (chance_(5) == 0 ? " NONPREEMPTIVE\n" : "\n");
  for (const std::string& thread : places_)
    out += "  PLACE " + thread + " ON P" + std::to_string(chance_(processors)) + " PRIORITY " +
           std::to_string(1 + chance_(2)) + "\n";
  for (const Asked& each : devices_) out += "  DEVICE " + each.device + times_of(each) + "\n";
  out += "  TIME work : " + chance_.one_of({"1 ms", "0 ms", "2 ms", "1 TO 2 ms"}) +
         "\n  TIME rest : " + chance_.one_of({"1 ms", "3 ms", "0 TO 1 ms"}) + "\n";
  for (const char* cost : {"RECEIVE", "SEND", "TEST", "SET", "READ"}) {
    if (chance_(5) == 0) out += std::string("  COST ") + cost + chance_.one_of({" 1 ms\n", " 0 TO 1 ms\n"});
  }
  if (chance_(3) == 0)
    out += "  LATENCY BETWEEN PROCESSORS " + chance_.one_of({"1 ms", "2 ms", "0 TO 1 ms"}) + "\n";
  if (chance_(3) == 0)
    out += "  LATENCY WITHIN PROCESSOR " + chance_.one_of({"1 ms", "2 ms", "0 TO 1 ms"}) + "\n";
  return out + "END ENVIRONMENT\n";
}

}  // namespace pal::test
