// The time axis of a chart: from time to place, and the marks of the axis. Linear, or several stretches of
// time in one scale with folds between them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/chart/options.hpp"
#include "analyzer/chart/text_width.hpp"

namespace pal::analyzer::chart {

class TimeScale {
 public:
  struct Piece {
    Window time;
    Length x0 = 0;
    Length x1 = 0;
    bool folded = false;  // time left out: drawn as a break
  };

  /// The windows in order of time, disjoint, all in one scale between x0 and x1; a fold of `fold` between
  /// two.
  TimeScale(const std::vector<Window>& windows, Length x0, Length x1, Length fold);

  /// Where an instant is; instants outside are at the nearer end.
  Length x(std::int64_t ns) const;

  /// The windows and the folds between them, left to right.
  const std::vector<Piece>& pieces() const { return pieces_; }
  std::int64_t from_ns() const { return pieces_.front().time.from_ns; }
  std::int64_t to_ns() const { return pieces_.back().time.to_ns; }
  Length x0() const { return pieces_.front().x0; }
  Length x1() const { return pieces_.back().x1; }

  bool shows(std::int64_t ns) const;                             // in a window, not in a fold
  bool touches(std::int64_t from_ns, std::int64_t to_ns) const;  // some of it is in a window

  /// The widest part of [left, right] that is not folded; x1 <= x0 if there is none.
  struct Stretch {
    Length x0 = 0;
    Length x1 = 0;
  };
  Stretch widest(Length left, Length right) const;

  /// The width of a length of time where nothing is folded.
  Length width(std::int64_t ns) const;

 private:
  std::vector<Piece> pieces_;
  std::int64_t total_ns_ = 0;
  Length total_width_ = 0;
};

/// Round instants for the axis, counted from `zero_ns`; the step is 1, 2 or 5 times a power of ten. A stretch
/// that no step falls into has its roundest instant.
struct Tick {
  std::int64_t at_ns = 0;
  std::string label;
};
struct Ticks {
  std::vector<Tick> major;
  std::vector<std::int64_t> minor;
  std::string unit;
};
Ticks ticks(const TimeScale& scale, std::int64_t zero_ns);

}  // namespace pal::analyzer::chart
