// Whether the requirements of a skill hold while it runs.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "pal/runtime/margins.hpp"
#include "pal/runtime/wiring.hpp"
#include "pal/trace/age_meter.hpp"
#include "pal/trace/inheritance.hpp"
#include "pal/trace/loss_meter.hpp"
#include "pal/trace/meter.hpp"
#include "pal/trace/usage_meter.hpp"
#include "runtime/watch/event_routes.hpp"

namespace pal::runtime {

/// A requirement that does not hold.
struct Exceeded {
  std::size_t requirement = 0;
  Time measured{};  // in the unit of its limit. Time::max(): an event was lost, or passed over
  std::int32_t actor = -1;
  std::int32_t statement = -1;
  bool noted = false;  // that it is late was seen before, when it was overdue
};

class RequirementWatch {
 public:
  /// All outlive the watch. `tables`: those of the run's trace. `margins` gets what is measured; null: nobody
  /// reads it.
  RequirementWatch(const Wiring& wiring, const trace::Trace& tables, Margins* margins = nullptr);

  bool any() const { return !watched_.empty(); }
  /// Which events see() must be shown. The others may be left out.
  const EventRoutes& routes() const { return routes_; }

  /// The requirements that the event shows to have failed, valid until the next call. `meters`: those that it
  /// concerns, by the routes.
  const std::vector<Exceeded>& see(const trace::Event& event, std::span<const std::uint32_t> meters);

  /// A thread comes to the first statement of a loop that a phase names, or has gone on behind it, or was
  /// stopped in it. What fails by that, valid until the next call.
  const std::vector<Exceeded>& enter(int loop, int thread, Time now);
  const std::vector<Exceeded>& leave(int loop, int thread);

  /// The longest time that was seen of this requirement; the shortest, of one that has a limit only from
  /// below; of a load the share of the run so far. Nothing: none was seen.
  const std::optional<Time>& worst(std::size_t requirement) const { return worst_[requirement]; }

  /// The runtime has ended the skill: what goes on until then counts. It breaks nothing any more.
  void end(Time now);

  /// The earliest instant at which something that still goes on is too long; Time::max(): none.
  Time due();
  /// No later than due() after the events since due() was called.
  Time soonest() const { return soonest_; }
  /// The requirements that are late at `now` and were not reported as late.
  const std::vector<Exceeded>& overdue(Time now);

 private:
  struct Response {
    trace::ResponseMeter meter;
    std::int64_t noted = 0;  // the number of the last birth that was seen to be late
    std::int64_t noted_ns = -1;
  };
  struct Duration {};
  struct Busy {
    std::vector<trace::UsageMeter> meters;  // of each processor
    std::vector<std::int64_t> noted_ns;     // the beginning of its last period that was seen to be too long
  };
  struct Load {
    std::vector<trace::UsageMeter> meters;
    bool over = false;  // it was noted, and is over its limit still
  };
  using Meter =
      std::variant<Response, trace::AgeMeter, trace::SampleMeter, trace::IntervalMeter, Duration,
                   trace::ConditionReactionMeter, trace::SampleReactionMeter, trace::LossMeter, Busy, Load>;
  struct Phase {
    trace::Marks after;
    std::vector<int> during;
    int inside = 0;   // of `during`: how many loops threads are in
    int leaver = -1;  // the thread that has left the last of them and not come to a statement yet; -1: none
  };
  struct Watched {
    std::size_t requirement = 0;
    const RequirementSpec* spec = nullptr;
    bool shortest;  // its worst value is the shortest one
    Meter meter;
    std::optional<Phase> phase;
    bool counts = true;
    std::int64_t begun_ns = 0;
  };
  struct See;

  Watched watched(std::size_t requirement, const trace::Trace& tables) const;
  void route(std::size_t index, const trace::Trace& tables);
  trace::Kept kept() const;
  [[gnu::always_inline]] bool see_usual(Watched& watched, const trace::Event& event);
  void look(Watched& watched, const trace::Event& event, std::int32_t parent);
  void begin_phase(Watched& watched, std::int64_t now_ns);
  void end_phase(Watched& watched);
  void settle_phases(int but_of);
  void check(const Watched& watched, const std::optional<trace::Occurrence>& seen, bool noted = false) {
    if (seen) check(watched, *seen, noted);
  }
  void check(const Watched& watched, const trace::Occurrence& seen, bool noted);
  void check_number(const Watched& watched, const std::optional<int>& lost);
  void check_load(const Watched& watched, Load& load, std::int64_t now_ns);
  void measured(const Watched& watched, Time value) {
    std::optional<Time>& worst = worst_[watched.requirement];
    if (!worst || (watched.shortest ? value < *worst : value > *worst)) worst = value;
    tell(watched, value);
  }
  void tell(const Watched& watched, Time latest) {
    if (margins_ != nullptr) margins_->set(watched.requirement, *worst_[watched.requirement], latest);
  }
  void may_be_due(const Watched& watched, std::int64_t since_ns) {
    if (spec(watched).most != Time::max())
      soonest_ = std::min(soonest_, Time(since_ns) + spec(watched).most + Time(1));
  }
  static const RequirementSpec& spec(const Watched& watched) { return *watched.spec; }

  const Wiring& wiring_;
  Margins* margins_;
  bool blocks_ = false;  // some thread is a block of another
  trace::Inheritance inheritance_;
  std::vector<Watched> watched_;
  EventRoutes routes_;
  int leaving_ = 0;  // phases with a leaver
  Time soonest_ = Time::max();
  std::int64_t once_ns_ = 0;     // what all statements take, each once
  std::int64_t slowest_ns_ = 0;  // the longest time that is declared of a device
  std::vector<Exceeded> exceeded_;
  std::vector<std::optional<Time>> worst_;  // by requirement
};

}  // namespace pal::runtime
