// Whether the requirements of a skill hold while it runs, as far as a run can tell.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <variant>
#include <vector>

#include "pal/runtime/wiring.hpp"
#include "pal/trace/inheritance.hpp"
#include "pal/trace/meter.hpp"

namespace pal::runtime {

/// A requirement that does not hold.
struct Exceeded {
  std::size_t requirement = 0;
  Time measured{};  // Time::max(): an event was lost, or passed over
  std::int32_t actor = -1;
  std::int32_t statement = -1;
  bool noted = false;  // that it is late was seen before, when it was overdue
};

class RequirementWatch {
 public:
  /// Both outlive the watch. `tables`: those of the run's trace.
  RequirementWatch(const Wiring& wiring, const trace::Trace& tables);

  bool any() const { return !watched_.empty(); }

  /// The requirements that the event shows to have failed, valid until the next call.
  const std::vector<Exceeded>& see(const trace::Event& event);

  /// The longest time that was seen of this requirement; the shortest, of one that has a limit only from
  /// below. Nothing: none was seen, or the measure is none that a run shows.
  const std::optional<Time>& worst(std::size_t requirement) const { return worst_[requirement]; }

  /// The earliest instant at which something that still awaits its response is late; Time::max(): none.
  Time due() const;
  /// The requirements that are late at `now` and were not reported as late.
  const std::vector<Exceeded>& overdue(Time now);

 private:
  struct Response {
    trace::ResponseMeter meter;
    std::int64_t noted = 0;  // the number of the last birth that was seen to be late
    std::int64_t noted_ns = -1;
  };
  struct Duration {};
  struct Watched {
    std::size_t requirement = 0;
    std::variant<Response, trace::AgeMeter, trace::SampleMeter, trace::IntervalMeter, Duration> meter;
  };
  void check(const Watched& watched, const std::optional<trace::Occurrence>& seen);
  void check(const Watched& watched, Response& response, const trace::Event& event, std::int32_t parent);
  const RequirementSpec& spec(const Watched& watched) const {
    return wiring_.requirements[watched.requirement];
  }

  const Wiring& wiring_;
  trace::Inheritance inheritance_;
  std::vector<Watched> watched_;
  std::vector<Exceeded> exceeded_;
  std::vector<std::optional<Time>> worst_;  // by requirement
};

}  // namespace pal::runtime
