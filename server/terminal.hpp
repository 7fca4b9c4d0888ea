// The pseudo-terminal or serial port by which `workcell serve` takes the lines of the thesis.
#pragma once

#include <string>

namespace pal::server {

struct OpenTerminal {
  int descriptor = -1;
  std::string path;  // of the far end
};

/// A new pseudo-terminal that changes no bytes. Throws std::system_error.
OpenTerminal open_pseudo_terminal();

/// A serial port: 8 bits, no parity, 1 stop bit, no flow control. Throws std::system_error; also for a speed
/// that serial ports do not have.
OpenTerminal open_serial(const std::string& path, unsigned baud);

}  // namespace pal::server
