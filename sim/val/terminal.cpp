#include "sim/val/terminal.hpp"

#include <utility>

namespace pal::sim::val {
namespace {

constexpr char control_c = 3, bell = 7, backspace = 8, control_u = 21, rubout = 127;
constexpr std::size_t longest_val_line = 128;

}  // namespace

Terminal::Terminal(runtime::drivers::Link& link, Machine& machine, MonitorOptions options)
    : link_(link),
      monitor_(
          machine, [this](std::string_view text) { write(text); }, options) {
  link_.connect(this);
}

Terminal::~Terminal() {
  link_.connect(nullptr);
}

void Terminal::on_bytes(runtime::drivers::Bytes bytes) {
  for (const char c : runtime::drivers::as_text(bytes)) {
    key(c);
    monitor_.typing(!line_.empty());
  }
}

void Terminal::on_break(std::string_view) {
  line_.clear();
}

void Terminal::key(char c) {
  const bool after_return = std::exchange(returned_, c == '\r');
  if (c == '\n' && after_return) return;
  if (c == '\r' || c == '\n') {
    write("\r\n");
    return monitor_.line(std::exchange(line_, {}));
  }
  if (c == backspace || c == rubout) {
    if (line_.empty()) return;
    line_.pop_back();
    return write("\b \b");
  }
  if (c == control_u) {
    line_.clear();
    return write("^U\r\n");
  }
  if (c == control_c) {
    line_.clear();
    write("^C\r\n");
    return monitor_.interrupt();
  }
  if (c < ' ' && c != '\t') return;  // also what is beyond 7 bits
  if (line_.size() == longest_val_line) return write(std::string(1, bell));
  line_ += c == '\t' ? ' ' : c;
  write(line_.substr(line_.size() - 1));
}

}  // namespace pal::sim::val
