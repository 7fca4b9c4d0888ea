// Measures of a run, taken event by event, while it goes on or from its trace
// (docs/reference/execution-model.md, "What is measured").
//
// Each meter is given every event of one run, in order. `parent` is the actor from which the event's actor
// inherits at this event (Inheritance), or -1. Memory is taken at the beginning; more only where many
// messages await their responses at a time.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "pal/trace/trace.hpp"

namespace pal::trace {

/// One interval that a measure is about.
struct Occurrence {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
  std::int32_t actor = -1;      // the thread of the statement at which it ends
  std::int32_t statement = -1;  // that statement

  std::int64_t length_ns() const { return to_ns - from_ns; }
  friend bool operator==(const Occurrence&, const Occurrence&) = default;
};

/// Marks of rows of a trace's table: of its channels, of its statements.
using Marks = std::vector<bool>;

/// Intervals between successive effects of the statements of `at`.
class IntervalMeter {
 public:
  explicit IntervalMeter(Marks at) : at_(std::move(at)) {}
  std::optional<Occurrence> see(const Event& event);
  /// The next effect is the first one.
  void forget() { last_.reset(); }

 private:
  Marks at_;
  std::optional<std::int64_t> last_;
};

/// Responses to the messages that are put into `channels`, at the effects of the statements of `at`.
class ResponseMeter {
 public:
  ResponseMeter(const Trace& tables, Marks channels, Marks at);

  struct Reading {
    std::optional<Occurrence> answered;
    int missed = 0;                    // events that are lost, or passed over, by this event
    std::int64_t last_missed_ns = -1;  // when the youngest of these began; at its loss if it is lost
  };
  Reading see(const Event& event, std::int32_t parent);

  /// A message that awaits its response.
  struct Birth {
    std::int64_t number = 0;  // from 1 on; 0: none
    std::int64_t time_ns = 0;
  };
  /// The oldest after number `after` that counts; null: none.
  const Birth* awaiting(std::int64_t after) const;

  /// What is put from now on counts, and nothing before.
  void begin_phase() { counts_from_ = births_ + 1; }
  /// Nothing counts. What is put is carried, and answered, all the same.
  void end_phase() { counts_from_ = none_counts; }

 private:
  static constexpr std::int64_t none_counts = std::numeric_limits<std::int64_t>::max();
  void put(const Event& event);
  void take(const Event& event);
  void drop(const Event& event);
  Reading answer(const Event& event);
  bool is_awaiting(const Birth& birth) const;
  const Birth* first_after(std::int64_t after) const;
  bool is_device(std::int32_t actor) const { return device_[static_cast<std::size_t>(actor)]; }
  bool is_source(const Event& event) const {
    return event.subject >= 0 && channels_[static_cast<std::size_t>(event.subject)];
  }
  Birth answered_request(const Event& event);
  void forget_what_nobody_carries();
  Birth& on(const Event& event) { return on_message_[static_cast<std::size_t>(event.subject)]; }

  Marks channels_, at_;
  std::vector<std::int32_t> request_;  // by channel: of what it answers; -1: nothing
  Marks asks_;                         // by channel: whether its messages are answered
  std::vector<bool> device_;           // by actor
  std::vector<Birth> on_message_;      // by channel: carried by the last message in its slot
  std::vector<std::vector<Birth>>
      serving_;                  // by channel: carried by its requests that were taken, oldest first
  std::vector<Birth> carried_;   // by actor
  std::vector<Birth> awaiting_;  // the oldest first
  std::int64_t births_ = 0;
  std::int64_t counts_from_ = 1;  // the number of the first birth that does
};

}  // namespace pal::trace
