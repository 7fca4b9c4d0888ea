// Shows the progress of a run on the terminal.
#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>

#include "sim/workcell.hpp"

namespace pal::workcell {

/// "    1.24 s   8.1 x   moving      force   3.2 N   tool   460.0  -200.0  -161.0 mm".
/// `factor`: simulated by real time.
std::string progress_line(const sim::Workcell& workcell, double factor);

/// On a terminal one line, rewritten ten times a second of real time; elsewhere a line a second of simulated
/// time.
class Progress {
 public:
  using Clock = std::function<std::chrono::steady_clock::time_point()>;
  static constexpr runtime::Time period =
      std::chrono::milliseconds(10);  // of simulated time, between two calls of show

  Progress(const sim::Workcell& workcell, std::ostream& out, bool terminal,
           Clock clock = std::chrono::steady_clock::now);

  /// Prints if it is time to.
  void show();
  /// The last line, which stays.
  void end();

 private:
  void print();

  const sim::Workcell& workcell_;
  std::ostream& out_;
  bool terminal_;
  Clock clock_;
  std::chrono::steady_clock::time_point begin_, printed_;
  runtime::Time next_ = std::chrono::seconds(1);
};

}  // namespace pal::workcell
