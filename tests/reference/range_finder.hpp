// The range finder of section 5.3.3 of the thesis: frames of 76 ms with a gap of 2 ms.
#pragma once

#include <string>

namespace pal::test {

/// A sensor driver SD1 with the body given, and a robot that stops it: at any time, unless `stop` says when.
inline std::string range_finder(const std::string& body, const std::string& interpretation,
                                const std::string& requirements, const std::string& stop = "SPORADIC 1 ms") {
  return R"(
MESSAGE profile : REAL mm
MESSAGE stop : SIGNAL
DEVICE finder "range finder"
SKILL scan
  SENSOR DRIVER      SD1
  LOGICAL SENSOR     NONE
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "stopped"
  COMPLETION 1 ERROR  "any other error"
)" + requirements +
         R"(END SKILL
Machine Controller: MC1
Sensor Driver: SD1
  ACTIVITY interpret READS profile
BEGIN
)" + body +
         R"(
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( stop from MC1 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  DEVICE MC1    EVENT stop )" +
         stop + R"(
  DEVICE finder FRAMES EVERY 78 ms COLLECTING 76 ms
  TIME interpret : )" +
         interpretation + R"(
  PLACE SM1 ON P0 PRIORITY 1
  PLACE SD1 ON P1 PRIORITY 1
END ENVIRONMENT
)";
}

}  // namespace pal::test
