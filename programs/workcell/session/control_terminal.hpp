// A run that is paused, stepped and stopped by lines of text.
#pragma once

#include <atomic>
#include <iosfwd>
#include <string>
#include <thread>

#include "pal/runtime/run_control.hpp"
#include "pal/runtime/wiring.hpp"

namespace pal::workcell {

/// Reads commands from a file descriptor in a thread of its own, for as long as it lives, and says where the
/// run is held. The run is held from its beginning on. When the input ends it goes on, without breakpoints.
class ControlTerminal {
 public:
  /// All outlive the terminal.
  ControlTerminal(runtime::RunControl& control, const runtime::Wiring& wiring, int input, std::ostream& out);
  ~ControlTerminal();
  ControlTerminal(const ControlTerminal&) = delete;
  ControlTerminal& operator=(const ControlTerminal&) = delete;

 private:
  void serve();
  void obey(const std::string& line);
  void break_at(const std::string& place);
  void say_where();

  runtime::RunControl& control_;
  const runtime::Wiring& wiring_;
  int input_;
  std::ostream& out_;
  bool waiting_ = true;  // for the run to be held
  std::atomic<bool> over_ = false;
  std::thread reader_;
};

}  // namespace pal::workcell
