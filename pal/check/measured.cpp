#include "pal/check/measured.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "pal/pan/times.hpp"
#include "pal/support/duration_text.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

std::string interval_text(const Interval& of) {
  return of.best == of.worst ? to_text(of.worst) : to_text(of.best) + " TO " + to_text(of.worst);
}

/// Least and greatest time that something takes; no greatest: it may take for ever.
struct Range {
  Duration least{};
  std::optional<Duration> greatest;
};

/// From one message to the next.
Range apart(const pan::EventDevice& device) {
  Range range{device.period - device.jitter, device.period + device.jitter};
  if (device.sporadic) range.greatest.reset();
  return range;
}

/// With the times of all the skills. Nothing says whose was measured, so of several times the longest counts.
pan::Environment with_times_of(const std::vector<pan::Network>& skills, const pan::Environment& environment) {
  pan::Environment all = environment;
  for (const pan::Network& skill : skills) {
    const pan::Environment one = pan::with_times_of(skill, environment);
    for (std::size_t i = environment.activities.size(); i < one.activities.size(); ++i) {
      const pan::ActivityTime& time = one.activities[i];
      const auto same =
          std::find_if(all.activities.begin(), all.activities.end(), [&](const pan::ActivityTime& other) {
            return other.activity == time.activity && other.module == time.module;
          });
      if (same == all.activities.end()) {
        all.activities.push_back(time);
      } else if (time.time.worst > same->time.worst) {
        *same = time;
      }
    }
  }
  return all;
}

class Comparison {
 public:
  Comparison(const pan::Environment& declared, const pan::Environment& measured, Diagnostics& diagnostics)
      : declared_(declared), measured_(measured), diagnostics_(diagnostics) {}

  void compare() const {
    for (const pan::ActivityTime& time : measured_.activities) activity(time);
    cost("SEND", declared_.costs.send, measured_.costs.send);
    cost("RECEIVE", declared_.costs.receive, measured_.costs.receive);
    cost("SET", declared_.costs.set, measured_.costs.set);
    cost("READ", declared_.costs.read, measured_.costs.read);
    cost("TEST", declared_.costs.test, measured_.costs.test);
    for (const pan::DeviceTiming& timing : measured_.devices) device(timing);
  }

 private:
  void not_declared(SourceSpan where, const std::string& what) const {
    diagnostics_.report(Finding::measured_not_declared, where, what, declared_.name);
  }

  /// The time of the activity in that module, or of the activity wherever it stands.
  const pan::ActivityTime* declared_time(const pan::ActivityTime& of) const {
    const pan::ActivityTime* anywhere = nullptr;
    for (const pan::ActivityTime& time : declared_.activities) {
      if (time.activity != of.activity) continue;
      if (time.module == of.module) return &time;
      if (time.module.empty()) anywhere = &time;
    }
    return anywhere;
  }

  void activity(const pan::ActivityTime& time) const {
    const std::string name = time.activity + (time.module.empty() ? "" : " OF " + time.module);
    const pan::ActivityTime* declared = declared_time(time);
    if (declared == nullptr) return not_declared(time.where, name);
    if (time.time.worst <= declared->time.worst) return;
    const Interval wanted{declared->time.best, time.time.worst};
    diagnostics_
        .report(Finding::activity_measured_longer, declared->where, name, to_text(time.time.worst),
                declared_.name, to_text(declared->time.worst), interval_text(wanted))
        .note(time.where, Remark::measured_here);
  }

  void cost(const char* name, const Interval& declared, const Interval& measured) const {
    if (measured.worst <= declared.worst) return;
    diagnostics_
        .report(Finding::cost_measured_longer, declared_.where, name, to_text(measured.worst), declared_.name,
                to_text(declared.worst), interval_text({declared.best, measured.worst}))
        .note(measured_.where, Remark::measured_here);
  }

  void device(const pan::DeviceTiming& timing) const {
    const auto declared =
        std::find_if(declared_.devices.begin(), declared_.devices.end(),
                     [&](const pan::DeviceTiming& each) { return each.device == timing.device; });
    if (declared == declared_.devices.end()) return not_declared(timing.where, "device " + timing.device);
    const auto* events = std::get_if<pan::EventDevice>(&declared->behaviour);
    const auto* frames = std::get_if<pan::FrameDevice>(&declared->behaviour);
    const auto* answers = std::get_if<pan::RequestDevice>(&declared->behaviour);
    if (const auto* seen = std::get_if<pan::EventDevice>(&timing.behaviour)) {
      if (events == nullptr || events->message != seen->message)
        return not_declared(timing.where, "device " + timing.device);
      const Range range = apart(*seen);
      return within(*declared, timing, "sent " + seen->message + " again after", range.least, *range.greatest,
                    apart(*events));
    }
    const auto* seen = std::get_if<pan::RequestDevice>(&timing.behaviour);
    if (seen == nullptr || events != nullptr) return not_declared(timing.where, "device " + timing.device);
    // A request just after a frame has begun waits for the next one.
    const Range range = answers != nullptr ? Range{answers->answer.best, answers->answer.worst}
                                           : Range{frames->collecting, frames->period + frames->collecting};
    within(*declared, timing, "answered after", seen->answer.best, seen->answer.worst, range);
  }

  void within(const pan::DeviceTiming& declared, const pan::DeviceTiming& measured, const std::string& did,
              Duration least, Duration greatest, const Range& range) const {
    const bool late = range.greatest && greatest > *range.greatest;
    if (!late && least >= range.least) return;
    diagnostics_
        .report(Finding::measured_outside_promise, declared.where, declared.device, did,
                to_text(late ? greatest : least), declared_.name,
                late ? "at most " + to_text(*range.greatest) : "at least " + to_text(range.least))
        .note(measured.where, Remark::measured_here);
  }

  const pan::Environment& declared_;
  const pan::Environment& measured_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_measured(const std::vector<pan::Network>& skills, const std::vector<pan::Environment>& declared,
                    const std::vector<pan::Environment>& measured, Diagnostics& diagnostics) {
  for (const pan::Environment& each : measured) {
    const auto same =
        std::find_if(declared.begin(), declared.end(),
                     [&](const pan::Environment& environment) { return environment.name == each.name; });
    if (same != declared.end()) {
      const pan::Environment whole = with_times_of(skills, *same);
      Comparison(whole, each, diagnostics).compare();
    } else {
      diagnostics.report(Finding::measured_elsewhere, each.where, each.name);
    }
  }
}

}  // namespace pal::check
