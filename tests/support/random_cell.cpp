// The skill, and what is asked about it.
#include "tests/support/random_cell.hpp"

namespace pal::test {

std::string RandomCell::text() {
  sensor_ = chance_(5);  // 0 answers, 1 frames, 2 event, 3 a body that asks a device, 4 two kinds of request
  controller_ = chance_(4) != 0;
  lonely_ = chance_(6) == 0;  // no logical sensor
  const std::string limit = std::to_string(2 * longest_) + " ms\n";
  std::string out =
      "MESSAGE force : SIGNAL\nMESSAGE raw : SIGNAL\nMESSAGE extra : SIGNAL\nMESSAGE motion : SIGNAL\n"
      "MESSAGE correction : SIGNAL\nMESSAGE tick : SIGNAL\nCONDITION c\nCONDITION d\n"
      "DEVICE robot\n";
  if (sensor_ == 3) out += "DEVICE gauge\n";
  out += "SKILL random\n";
  if (!lonely_) out += "  SENSOR DRIVER SD1\n  LOGICAL SENSOR LS1\n";
  out +=
      "  MACHINE CONTROLLER MC1\n  SKILL METHOD SM1\n  CONTINGENCY 1 \"no\" METHOD CM1\n  COMPLETION 0 "
      "NORMAL\n  COMPLETION 1 ERROR\n"
      "  REQUIREMENT age-c : AGE OF c AT TXM( motion to MC1 ) IN SM1 AT MOST " +
      limit + "  REQUIREMENT age-d : AGE OF d AT think IN SM1 AT MOST " + limit;
  if (controller_) {
    out +=
        "  REQUIREMENT answer : RESPONSE FROM tick OF robot TO TXM( correction to robot ) AT MOST " + limit;
    out += "  REQUIREMENT through : RESPONSE FROM tick OF robot TO TXM( motion to MC1 ) AT MOST " + limit;
  } else {
    out +=
        "  REQUIREMENT answer : RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 ) AT MOST " + limit;
  }
  if (!lonely_ && sensor_ == 2)
    out += "  REQUIREMENT sensed : RESPONSE FROM raw OF SD1 TO TXM( force to SM1 ) AT MOST " + limit;
  if (asks_ == Asks::all) out += requirements();
  out += "END SKILL\n";
  const std::string modules = bodies();
  return out + modules + environment();
}

std::string RandomCell::requirements() {
  const std::string most = " AT MOST " + ms(2 * longest_);
  const std::string at = " AT TXM( motion to MC1 ) IN SM1" + most;
  const std::string robot = controller_ ? "robot" : "MC1";
  const std::string sensor = sensor_ == 3 ? "gauge" : "SD1";
  Lines all = {"REACTION OF c" + at,
               "REACTION OF d AT think IN SM1" + most,
               "INTERVAL OF TXM( motion to MC1 ) IN SM1" + most,
               "INTERVAL OF think IN SM1 AT LEAST 2 ms",
               "INTERVAL OF TXM( motion to MC1 ) IN SM1 BETWEEN 1 ms AND " + ms(longest_),
               "LOSS OF " + robot + " NONE",
               "LOSS OF " + robot + " AT MOST 1 IN 3",
               "DURATION TO COMPLETION 0" + most,
               "DURATION TO COMPLETION 1" + most,
               "BUSY PERIOD OF EACH PROCESSOR" + most,
               "LOAD OF EACH PROCESSOR AT MOST 60 %"};
  if (!lonely_) {
    all.push_back("REACTION OF raw FROM " + sensor + at);
    all.push_back("AGE OF raw FROM " + sensor + at);
    all.push_back("AGE OF raw FROM " + sensor + " AT SPC( c ) IN SM1" + most);
    all.push_back("INTERVAL OF WTM( raw from SD1 ) IN LS1" + most);
    all.push_back("LOSS OF " + sensor + " NONE");
    all.push_back("LOSS OF " + sensor + " AT MOST 1 IN 2");
    all.push_back("RESPONSE FROM force OF LS1 TO TXM( motion to MC1 )" + most);
    all.push_back("RESPONSE FROM force OF LS1 TO SPC( c ) IN SM1" + most);
    all.push_back("RESPONSE FROM request force OF SM1 TO TXM( force to SM1 )" + most);
    all.push_back("RESPONSE FROM raw OF SD1 TO TXM( force to SM1 )" + most);
  }
  all.push_back("RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 )" + most);
  if (controller_) {
    all.push_back("RESPONSE FROM motion OF SM1 TO TXM( correction to robot )" + most);
    all.push_back("RESPONSE FROM motion request OF MC1 TO obey IN MC1" + most);
  }
  std::string out;
  int number = 0;
  for (const std::string& each : all) {
    if (required_() % 4 == 0) out += "  REQUIREMENT more-" + std::to_string(++number) + " : " + each + "\n";
  }
  return out;
}

}  // namespace pal::test
