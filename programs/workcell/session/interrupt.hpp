// Ctrl-C as a request to stop.
#pragma once

#include "pal/runtime/run_control.hpp"

namespace pal::workcell {

/// While it lives, SIGINT, SIGTERM, SIGHUP and SIGQUIT ask `control` to stop; a second one ends the process
/// as usual. One at a time.
class Interrupt {
 public:
  explicit Interrupt(runtime::RunControl& control);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
};

}  // namespace pal::workcell
