// How many of a device's events, answers or frames are lost (docs/reference/execution-model.md, "What is
// measured").
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pal/trace/meter.hpp"

namespace pal::trace {

/// The greatest number of lost ones among any `in` in a row.
class LossMeter {
 public:
  enum class Of {
    events,   // that it sends by itself
    answers,  // to requests, one at a time
    frames,   // each answers all requests that were there as it began
  };
  /// `period`: of frames. A device that does not say when it is busy shows by it how many frames nobody asked
  /// for: they are told with the next one that is answered.
  LossMeter(const Trace& tables, std::int32_t device, Of of, int in, std::int64_t period_ns);

  /// The most that are lost in a row that the event completes, or adds a lost one to; nothing: it says
  /// nothing about it.
  std::optional<int> see(const Event& event);
  /// Nothing comes after the events that were seen.
  std::optional<int> finish();

  /// It counts the whole run, unless it is told so.
  void begin_phase();
  /// Rows of losses are over. The most of those that it ends.
  std::optional<int> end_phase();

 private:
  using Most = std::optional<int>;
  void device(const Event& event, Most& most);
  void sent(const Event& event, Most& most);
  void close(Most& most);
  void settle(Most& most);
  void occurrence(bool lost, Most& most);
  void lose(std::int64_t number, Most& most);
  bool is_lost(std::int64_t number) const { return lost_[static_cast<std::size_t>(number) % lost_.size()]; }

  std::int32_t device_;
  Of of_;
  std::int64_t in_;
  std::int64_t period_;
  std::vector<std::int32_t> request_;  // by channel: of what it answers; -1: nothing
  std::vector<bool> own_;              // by channel: the device sends on it
  std::vector<int> asked_;             // by channel: requests that it has taken and not answered
  std::vector<std::int64_t> number_;   // by channel: of the message in its slot; -1: it does not count
  std::vector<bool> lost_;             // the last ones, in a ring
  std::int64_t count_ = 0;
  std::int64_t first_ = 0;  // that counts
  bool counts_ = true;
  // Frames.
  bool marks_ = false;         // it says when it is busy
  bool begun_ = false;         // a frame of which nobody is known that asked for it
  bool answered_ = false;      // a frame has answered
  std::int64_t open_at_ = -1;  // the frame whose answers come at this instant; -1: none
  bool any_put_ = false;       // of them
  std::int64_t last_at_ = -1;  // of the frame before
};

}  // namespace pal::trace
