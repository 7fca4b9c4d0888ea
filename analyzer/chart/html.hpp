// Runs as a page to move in: one file that needs no network, for a browser.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/chart/options.hpp"
#include "analyzer/chart/timeline.hpp"

namespace pal::analyzer::chart {

/// A part of why an interval is as long as it is, with the parts inside it, which follow each other without
/// gaps.
struct Part {
  Segment segment;
  std::vector<Part> inside;
};

/// One run, as it is shown for a requirement.
struct View {
  std::string name;     // "worst run"
  std::size_t run = 0;  // in Book::runs
  std::optional<Highlight> highlight;
  std::vector<Loss> losses;
  std::vector<Part> why;
  /// What is shown first; if not given, the highlighted interval, or all.
  std::optional<Window> window;
};

struct Subject {
  std::string skill;
  std::string environment;
  Caption caption;
  std::string brief;        // "8.4 ms of 12 ms": one line for a list
  std::vector<View> views;  // none: there is no run to show
};

struct Book {
  std::string title;
  std::vector<Timeline> runs;
  std::vector<Subject> subjects;
  std::size_t first = 0;  // the subject that is shown first
};

/// The page. The same book gives the same bytes; all texts are escaped.
std::string html(const Book& book);

}  // namespace pal::analyzer::chart
