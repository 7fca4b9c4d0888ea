// What a chart should point out. It comes from the maker of the trace: an analysis' verdict, or a
// measurement.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pal::analyzer::chart {

/// [from_ns, to_ns] of the trace's time; to_ns > from_ns.
struct Window {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;

  friend bool operator==(const Window&, const Window&) = default;
};

/// The interval that a requirement is about. `label` says what it is ("age of pc-force"); the chart adds the
/// figure. `limit_ns` is the greatest length allowed, drawn as a deadline; -1: none.
struct Highlight {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  std::string label;
  bool fails = false;
  std::int64_t limit_ns = -1;
  /// It begins with a change in the world that a sample has just missed.
  bool missed = false;
};

/// One part of why the highlighted interval is as long as it is. `actor`: the thread or device that spends
/// this time.
struct Segment {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  std::string text;
  std::string actor;
  std::string place;  // of the statement: "touch.pal:34"; empty: none
  /// How deep the part lies inside others: it belongs to the nearest part before it that is one less deep.
  /// Parts of depth 0 follow each other without gaps, and have letters.
  int depth = 0;
};

/// A further instant by which something has to have happened.
struct Deadline {
  std::int64_t at_ns = 0;
  std::string label;
};

/// A frame, an answer or an event of a device that no thread took: crossed out.
struct Loss {
  std::string lane;  // the device
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;  // from_ns: it takes no time
  std::string text;        // "lost: no request for it was open when it began"
};

/// What stands above the chart, in words. Empty texts are left out.
struct Caption {
  std::string requirement;  // its name: "fresh-force"
  std::string measure;      // "age of pc-force at TXM( motion to MC1 ) in SM1"
  std::string verdict;      // "holds", "fails", "undecided"
  std::string figures;  // "worst case 35 ms (exact: the run below attains it), limit 10 ms, 25 ms too much"
  std::string proved;   // "at most 35 ms": beside what was measured
  std::string limit;    // "10 ms"
};

struct ChartOptions {
  Caption caption;
  std::optional<Highlight> highlight;
  std::vector<Segment> explanation;
  std::vector<Deadline> deadlines;
  std::vector<Loss> losses;
  /// The part of the run that is drawn; if not given, the highlighted interval with some of what is around
  /// it, or all.
  std::optional<Window> window;
  /// Whether short actions are drawn once more, enlarged, under the chart, where it helps.
  bool detail = true;
  /// Whether each bar has an id: "bar-LANE-NUMBER", both from 0 as in the timeline. Where a bar is drawn more
  /// than once, "-2" and so on follow.
  bool ids = false;
  /// Whether the picture fits a column of a page with two.
  bool narrow = false;
};

}  // namespace pal::analyzer::chart
