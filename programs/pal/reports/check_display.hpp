// What a check knows while its proofs are at work, on a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "programs/pal/session/proof.hpp"

namespace pal::program {

/// Lines and columns of the terminal that is the standard output; 24 and 80 if it does not say.
struct TerminalSize {
  std::size_t lines = 24;
  std::size_t columns = 80;
};
TerminalSize terminal_size();

/// Writes the verdicts as they come, with a bar: first by what bounds know. It writes over what it wrote
/// before, and clears all when it ends, so that the report stands in its place.
class CheckDisplay {
 public:
  /// Nothing is shown of proofs that end within `patience`.
  CheckDisplay(std::ostream& out, TerminalSize size,
               std::chrono::milliseconds patience = std::chrono::milliseconds(300));
  CheckDisplay(const CheckDisplay&) = delete;
  CheckDisplay& operator=(const CheckDisplay&) = delete;
  ~CheckDisplay();

  void show(const analyzer::Problem& problem, const analyzer::Analysis& known);

 private:
  void clear();

  std::ostream& out_;
  TerminalSize size_;
  std::chrono::steady_clock::time_point begin_;
  std::vector<std::string> shown_;
};

}  // namespace pal::program
