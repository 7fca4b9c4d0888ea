// The last events, for clients that connect late.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>

#include "server/event.hpp"

namespace pal::server {

/// One thread only.
class History {
 public:
  explicit History(std::size_t most = 10'000) : most_(most) {}

  void add(const Event& event) {
    events_.push_back(event);
    if (events_.size() > most_) events_.pop_front();
  }
  /// The first event that is still kept; 0: none.
  std::uint64_t first() const { return events_.empty() ? 0 : events_.front().number; }
  /// Calls `use` for each event with a number above `number`.
  void since(std::uint64_t number, const std::function<void(const Event&)>& use) const {
    for (const Event& event : events_)
      if (event.number > number) use(event);
  }

 private:
  std::size_t most_;
  std::deque<Event> events_;
};

}  // namespace pal::server
