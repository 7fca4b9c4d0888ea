#include "programs/pal/session/memory.hpp"

#include <fstream>
#include <string>

namespace pal::program {

std::size_t peak_memory() {
  std::size_t kilobytes = 0;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) kilobytes = std::stoul(line.substr(6));
  }
  std::ofstream("/proc/self/clear_refs") << "5\n";  // resets the peak (proc(5))
  return kilobytes * 1024;
}

}  // namespace pal::program
