// Any bytes as a file of PAL: lexer, parser, checks, deadlock, messages, printing, drawing.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/whole_check.hpp"

namespace {

// What the text may use: enough names for it to get through the first checks.
const char* const modules = R"(MESSAGE force : REAL N
MESSAGE motion : dz : REAL mm
CONDITION near FROM force
DEVICE clock
Sensor Driver: SD1
Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request force from SM1 )
    TXM( request force from SD1 )
    WTM( force from SD1 )
    TXM( force to SM1 )
  UNTIL( forever )
END
)";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pal::MemoryFileSystem files;
  files.add("a.pal", std::string(data, data + size));
  files.add("modules.pal", modules);
  pal::fuzz::check_whole(files, "a.pal");
  return 0;
}
