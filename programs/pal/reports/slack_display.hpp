// Slacks on a terminal, each as soon as it is found, with a progress bar.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <set>
#include <string>

#include "analyzer/whatif/slack.hpp"
#include "programs/pal/reports/whatif_answer.hpp"

namespace pal::program {

/// Writes the heading at once, and each row when its slack is settled. `answer` and `out` must live as long.
class SlackDisplay {
 public:
  SlackDisplay(const pan::Network& skill, const pan::Environment& environment, WhatIfAnswer& answer,
               std::ostream& out);

  /// To be passed to slacks(); calls this display.
  analyzer::whatif::SlackObserver observer();

  /// Writes the rows of `answer.slacks` that were not settled, and marks the answer as shown.
  void finish();

 private:
  void show(const analyzer::whatif::Slack& slack);
  void draw_bar(std::size_t settled, std::size_t all);
  void erase_bar();

  WhatIfAnswer& answer_;
  std::ostream& out_;
  SlackTable table_;
  std::set<std::string> shown_;  // figures
  bool bar_ = false;             // it stands on the last line
};

}  // namespace pal::program
