// Files of the project that tests read.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace pal::test {

/// The text of the file with this path from the project's root. Throws if there is none.
inline std::string project_file(const std::string& path) {
  std::ifstream file(std::string(PAL_SOURCE_DIR) + "/" + path);
  if (!file) throw std::runtime_error("no file " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace pal::test
