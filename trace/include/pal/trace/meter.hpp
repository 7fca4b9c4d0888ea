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
#include <utility>
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

/// The effect of a statement of `marks`.
inline bool has_effect_at(const Event& event, const Marks& marks) {
  return event.kind == Kind::done && event.statement >= 0 && marks[static_cast<std::size_t>(event.statement)];
}

/// Intervals between successive effects of the statements of `at`.
class IntervalMeter {
 public:
  explicit IntervalMeter(Marks at) : at_(std::move(at)) {}
  std::optional<Occurrence> see(const Event& event) {
    if (!has_effect_at(event, at_)) return std::nullopt;
    const auto before = std::exchange(last_, event.time_ns);
    if (!before) return std::nullopt;
    return Occurrence{*before, event.time_ns, event.actor, event.statement};
  }
  /// The next effect is the first one.
  void forget() { last_.reset(); }

 private:
  Marks at_;
  std::optional<std::int64_t> last_;
};

/// Responses to the messages that are put into `channels`, at the effects of the statements of `at`.
class ResponseMeter {
 public:
  /// A message that awaits its response.
  struct Birth {
    std::int64_t number = 0;  // from 1 on; 0: none
    std::int64_t time_ns = 0;
  };

  ResponseMeter(const Trace& tables, Marks channels, Marks at);

  struct Reading {
    std::optional<Occurrence> answered;
    int missed = 0;                    // events that are lost, or passed over, by this event
    std::int64_t last_missed_ns = -1;  // when the youngest of these began; at its loss if it is lost
  };
  Reading see(const Event& event, std::int32_t parent) {
    if (parent >= 0) actor(event).carried = actors_[static_cast<std::size_t>(parent)].carried;
    switch (event.kind) {
      case Kind::put:
        put(event);
        return {};
      case Kind::take:
        take(event);
        return {};
      case Kind::done:
        return has_effect_at(event, at_) ? answer(event) : Reading{};
      default:
        return see_loss(event);
    }
  }
  // The same for a message that is put or taken, by an actor that inherits nothing at this event.
  [[gnu::always_inline]] void put(const Event& event) {
    const Actor& by = actor(event);
    Birth carried = by.device ? answered_request(event) : by.carried;
    if (channel(event).is_source) {
      carried = {++births_, event.time_ns};
      if (awaiting_.size() == awaiting_.capacity()) forget_what_nobody_carries();
      awaiting_.push_back(carried);
    }
    channel(event).on_message = carried;
  }
  /// An event that was answered is carried no further: the thread keeps the one that it has.
  [[gnu::always_inline]] void take(const Event& event) {
    Actor& by = actor(event);
    const Channel& taken = channel(event);
    if (by.device) {
      if (taken.asks) serving_[static_cast<std::size_t>(event.subject)].push_back(taken.on_message);
    } else if (is_awaiting(taken.on_message)) {
      by.carried = taken.on_message;
    }
  }
  /// The usual answer, to the message that awaits it for longest and counts; the same holds of its actor.
  /// True: it is `cause`, and awaits nothing any more. False: nothing was done.
  [[gnu::always_inline]] bool answer_oldest(const Event& event, Birth& cause) {
    cause = actor(event).carried;
    if (awaiting_.empty() || awaiting_.front().number != cause.number || cause.number < counts_from_ ||
        !has_effect_at(event, at_))
      return false;
    forget_oldest();
    return true;
  }
  /// Whether the event puts a message that counts.
  bool counts(const Event& event) const { return is_source(event) && counts_from_ != none_counts; }

  /// The oldest after number `after` that counts; null: none.
  const Birth* awaiting(std::int64_t after) const;

  /// What is put from now on counts, and nothing before.
  void begin_phase() { counts_from_ = births_ + 1; }
  /// Nothing counts. What is put is carried, and answered, all the same.
  void end_phase() { counts_from_ = none_counts; }

 private:
  static constexpr std::int64_t none_counts = std::numeric_limits<std::int64_t>::max();
  Reading see_loss(const Event& event);
  void drop(const Event& event);
  Reading answer(const Event& event) {
    const Birth& cause = actor(event).carried;
    if (cause.number == 0 || awaiting_.empty() || cause.number < awaiting_.front().number) return {};
    if (awaiting_.front().number != cause.number || cause.number < counts_from_) return answer_later(event);
    Reading reading;
    reading.answered = Occurrence{cause.time_ns, event.time_ns, event.actor, event.statement};
    forget_oldest();
    return reading;
  }
  void forget_oldest() {
    if (awaiting_.size() == 1) {
      awaiting_.pop_back();
    } else {
      awaiting_.erase(awaiting_.begin());
    }
  }
  Reading answer_later(const Event& event);
  bool is_awaiting(const Birth& birth) const {
    if (birth.number == 0 || awaiting_.empty() || birth.number < awaiting_.front().number) return false;
    return awaiting_.front().number == birth.number || is_awaiting_later(birth);
  }
  bool is_awaiting_later(const Birth& birth) const;
  const Birth* first_after(std::int64_t after) const;
  bool is_source(const Event& event) const { return event.subject >= 0 && channel(event).is_source; }
  Birth answered_request(const Event& event);
  void forget_what_nobody_carries();

  struct Channel {
    Birth on_message;           // carried by the last message in its slot
    std::int32_t request = -1;  // of what it answers; -1: nothing
    bool is_source = false;
    bool asks = false;  // its messages are answered
  };
  struct Actor {
    Birth carried;
    bool device = false;
  };
  Channel& channel(const Event& event) { return channels_[static_cast<std::size_t>(event.subject)]; }
  const Channel& channel(const Event& event) const {
    return channels_[static_cast<std::size_t>(event.subject)];
  }
  Actor& actor(const Event& event) { return actors_[static_cast<std::size_t>(event.actor)]; }

  Marks at_;
  std::vector<Channel> channels_;
  std::vector<Actor> actors_;
  std::vector<std::vector<Birth>>
      serving_;                  // by channel: carried by its requests that were taken, oldest first
  std::vector<Birth> awaiting_;  // the oldest first
  std::int64_t births_ = 0;
  std::int64_t counts_from_ = 1;  // the number of the first birth that does
};

}  // namespace pal::trace
