// The program pal, run without a process.
#pragma once

#include <unistd.h>

#include <sstream>
#include <string>
#include <vector>

#include "pal/driver/command_line.hpp"

namespace pal::test {

struct Answer {
  driver::ExitStatus status;
  std::string out, err;
};

inline Answer pal(const std::vector<std::string>& arguments, const FileSystem& files = DiskFileSystem()) {
  std::ostringstream out, err;
  const driver::ExitStatus status = driver::run(arguments, {out, err, files});
  return {status, out.str(), err.str()};
}

inline std::string skill(const std::string& file) {
  return std::string(PAL_SOURCE_DIR) + "/skills_pal/" + file;
}

/// A name for a temporary file or folder that no test running beside this one has.
inline std::string own_name(const std::string& name) {
  return name + "-" + std::to_string(::getpid());
}

}  // namespace pal::test
