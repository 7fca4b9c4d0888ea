// When ALTER's requests come, by the clock of the profiles.
#pragma once

#include <algorithm>
#include <chrono>

#include "runtime/drivers/alter/protocol.hpp"

namespace pal::skills {

/// Activities have no clock. A profile that is new at a request, and was not there at the one before, became
/// known between the two. Each such profile narrows down when requests come. The range finder's 78 ms and
/// ALTER's 28 ms drift past each other by 2 ms, so that a few seconds tell the instant to 2 ms.
class CycleClock {
 public:
  void start() { *this = {}; }

  /// A request has come.
  void tick() { ++cycle_; }
  /// A profile is new at this request; `known`: the instant at which it can have been known first, ms.
  void saw(double known) {
    const double latest = known - period * static_cast<double>(cycle_) + period;
    if (first_) latest_ = latest, earliest_ = latest - period;
    first_ = false;
    latest_ = std::min(latest_, latest);
    earliest_ = std::max(earliest_, latest - period);
    if (earliest_ > latest_)
      earliest_ = latest_ = (earliest_ + latest_) / 2;  // the times of sensing vary by more than that
  }
  int cycle() const { return cycle_; }
  /// When request `cycle` came, ms.
  double instant(int cycle) const { return (earliest_ + latest_) / 2 + period * static_cast<double>(cycle); }

 private:
  static constexpr double period =
      std::chrono::duration<double, std::milli>(runtime::drivers::alter::period).count();  // ms
  int cycle_ = 0;
  bool first_ = true;
  double earliest_ = 0, latest_ = 0;  // of request 0
};

}  // namespace pal::skills
