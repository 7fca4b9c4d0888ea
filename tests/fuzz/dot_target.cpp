// Any bytes as a module drawn in DOT, in a file of its own and as the method of a skill.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/whole_check.hpp"

namespace {

const char* const skill = R"(USES "SM1.dot"
MESSAGE force : REAL N
MESSAGE motion : dz : REAL mm
MESSAGE tick : SIGNAL
CONDITION near FROM force
CONDITION far
DEVICE clock
Logical Sensor: LS1
Machine Controller: MC1
SKILL drawn
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
END SKILL
)";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pal::MemoryFileSystem files;
  files.add("SM1.dot", std::string(data, data + size));
  files.add("skill.pal", skill);
  pal::fuzz::check_whole(files, "skill.pal");
  return 0;
}
