// What a command may touch: streams and files are passed in, so that every command can be tested from
// strings.
#pragma once

#include <iosfwd>

#include "pal/support/file_system.hpp"

namespace pal::driver {

struct Console {
  std::ostream& out;
  std::ostream& err;
  const FileSystem& files;
};

}  // namespace pal::driver
