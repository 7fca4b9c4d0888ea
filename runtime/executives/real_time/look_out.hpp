// Whether it pays to poll before one sleeps.
#pragma once

#include <algorithm>
#include <cstdint>

namespace pal::runtime {

/// For a thread that the system may interrupt for other work. While it polls it may take the CPU from the
/// very thread that it waits for, and it uses up its share. So after each time in vain it sleeps at once for
/// some waits: for more of them, the more often it was in vain. It forgets one of these times after many in
/// which polling did pay.
class LookOut {
 public:
  /// Before a wait: whether to poll.
  bool pays() {
    if (sleeps_ == 0) return true;
    --sleeps_;
    return false;
  }
  /// It has polled; whether what it waited for has come.
  void polled(bool in_time) {
    if (in_time) {
      if (in_vain_ > 0 && ++in_time_ == in_time_for_one) --in_vain_, in_time_ = 0;
      return;
    }
    in_time_ = 0;
    sleeps_ = first_sleeps << in_vain_;
    in_vain_ = std::min(in_vain_ + 1, most_in_vain);
  }

 private:
  static constexpr std::uint32_t first_sleeps = 16, most_in_vain = 8, in_time_for_one = 64;
  std::uint32_t sleeps_ = 0;   // waits without polling that are still to come
  std::uint32_t in_vain_ = 0;  // how often it has not paid
  std::uint32_t in_time_ = 0;  // how often it has, since then
};

}  // namespace pal::runtime
