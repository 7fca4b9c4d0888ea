// The clock of a station, and its future events: bytes that arrive, conversions that end, time-outs.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "pal/runtime/device.hpp"

namespace pal::runtime::drivers {

/// Actions in the order of their instants; actions of one instant run in the order in which they were asked
/// for. Instants count from the station's start and go on from one skill to the next. One thread only.
class Timeline {
 public:
  /// Names one action. A token is never used again, so that cancelling twice, or too late, does no harm.
  struct Token {
    std::uint32_t slot = 0;
    std::uint32_t generation = 0;  // 0: no action
  };
  static constexpr Time never = Time::max();

  Time now() const { return now_; }

  /// Calls `action` at instant `when`. Throws std::logic_error if that is over.
  Token at(Time when, std::function<void()> action);
  Token after(Time delay, std::function<void()> action) { return at(now_ + delay, std::move(action)); }
  /// The action will not be called. If it has been, nothing happens.
  void cancel(Token token);

  /// When the next action is due; `never` if there is none.
  Time next();

  /// Goes on to `when`, action by action; those that an action adds up to `when` run as well. An exception of
  /// an action leaves the clock at its instant and the other actions in place.
  void advance_to(Time when);

 private:
  struct Entry {
    Time time{};
    std::uint64_t order = 0;
    Token token;
  };
  struct Slot {
    std::function<void()> action;
    std::uint32_t generation = 1;
  };
  static bool later(const Entry& a, const Entry& b);
  bool cancelled(const Entry& entry) const;
  std::function<void()> release(Token token);
  void pop();

  Time now_{};
  std::uint64_t order_ = 0;
  std::vector<Entry> heap_;
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
};

}  // namespace pal::runtime::drivers
