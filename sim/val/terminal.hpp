// The terminal port of the controller: characters in, echo and answers out.
#pragma once

#include <string>

#include "runtime/drivers/link.hpp"
#include "sim/val/monitor.hpp"

namespace pal::sim::val {

/// One end of a link, at which a VAL controller is. Each character is echoed as it comes. Return (or a line
/// feed) ends a line. Backspace and Rubout delete a character, Control-U the line. Control-C ends what DO is
/// carrying out.
class Terminal final : public runtime::drivers::LinkUser {
 public:
  /// Takes the link; link and machine outlive the terminal.
  Terminal(runtime::drivers::Link& link, Machine& machine, MonitorOptions options = {});
  ~Terminal() override;

  Monitor& monitor() { return monitor_; }
  void on_bytes(runtime::drivers::Bytes bytes) override;
  void on_break(std::string_view reason) override;

 private:
  void key(char c);
  void write(std::string_view text) { link_.write(runtime::drivers::as_bytes(text)); }

  runtime::drivers::Link& link_;
  Monitor monitor_;
  std::string line_;       // what has been typed of it
  bool returned_ = false;  // the last character was a Return: a line feed after it means nothing
};

}  // namespace pal::sim::val
