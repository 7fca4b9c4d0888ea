// A pseudo-terminal that changes no byte. Private to pal_links.
#pragma once

#include <string>

namespace pal::runtime::drivers {

/// Descriptors, which the caller closes. The far side stays open here, so that a program that comes and goes
/// there does no harm.
struct PseudoTerminal {
  int near_side = -1;
  int far_side = -1;
  std::string path;  // of the far side
};

/// Throws std::system_error.
PseudoTerminal open_pseudo_terminal();

}  // namespace pal::runtime::drivers
