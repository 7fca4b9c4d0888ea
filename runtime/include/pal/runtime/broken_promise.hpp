// A promise of the environment, or a requirement, that was broken in a run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pal/runtime/device.hpp"

namespace pal::runtime {

struct BrokenPromise {
  std::string promise;  // "force-torque answers 6 ms after a request at the latest"
  std::string by;       // a device, or a thread, at which it was seen; may be empty
  /// What `measured` is: a time; of a loss the number of lost messages; of a load nanoseconds of work in a
  /// second.
  enum class Unit : std::uint8_t { time, messages, share };
  Unit unit = Unit::time;
  Time measured{};  // the longest; of a least time the shortest; Time::max(): something was never answered;
                    // 0: no time
  Time first{};     // when it was broken for the first time, and noted
  std::size_t times = 1;
  std::vector<std::string> endangers;  // the requirements whose proof relies on it; of a requirement itself
};

/// "force-torque answers 6 ms after a request at the latest: measured 400 ms; endangers fresh-force"
std::string in_words(const BrokenPromise& broken);

/// "6 ms", "3", "41.7 %".
std::string in_words(Time measured, BrokenPromise::Unit unit);

/// "6 ms", "0.25 us", "1 ns": exact.
std::string in_words(Time time);

}  // namespace pal::runtime
