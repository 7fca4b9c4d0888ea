// What a requirement allows, and how a value compares with it.
#pragma once

#include <cstdint>

#include "pal/support/time.hpp"

namespace pal::analyzer {

/// A value that is measured, proved or allowed.
struct Figure {
  /// A time in nanoseconds; a share of the time, in nanoseconds of work in a second; a number of losses.
  enum class Unit { time, share, count };
  Unit unit = Unit::time;
  std::int64_t value = 0;
};

/// A figure beyond which no value may be.
struct Limit {
  enum class Sense { at_most, at_least };
  Sense sense = Sense::at_most;
  Figure figure;

  bool broken_by(std::int64_t value) const { return worse(value, figure.value); }
  bool broken_by(Duration value) const { return broken_by(value.count()); }

  /// Whether `value` is nearer to breaking such a limit than another, or breaks it by more.
  bool worse(std::int64_t value, std::int64_t than) const {
    return sense == Sense::at_least ? value < than : value > than;
  }
  bool worse(Duration value, Duration than) const { return worse(value.count(), than.count()); }

  /// By how much a value keeps within the limit; negative: by how much it breaks it.
  std::int64_t margin(std::int64_t value) const {
    return sense == Sense::at_least ? value - figure.value : figure.value - value;
  }

  /// "at least", "at most".
  const char* text() const { return sense == Sense::at_least ? "at least" : "at most"; }
};

}  // namespace pal::analyzer
