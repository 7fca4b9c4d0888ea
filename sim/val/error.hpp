// The form in which VAL shows an error: thrown where a command is read or carried out.
#pragma once

#include <string>
#include <utility>

namespace pal::sim::val {

/// Thrown within this library, caught by the monitor: shown as `*what* detail`. Full stops and asterisks
/// would be taken for a prompt and for an error's ends, so that shown() has neither.
class Error {
 public:
  explicit Error(std::string what, std::string detail = {})
      : what_(std::move(what)), detail_(std::move(detail)) {}

  std::string shown() const {
    std::string detail = detail_;
    for (char& c : detail) {
      if (c == '.') c = ',';
      if (c == '*') c = ' ';
    }
    return "*" + what_ + "*" + (detail.empty() ? "" : " " + detail);
  }

 private:
  std::string what_;
  std::string detail_;
};

}  // namespace pal::sim::val
