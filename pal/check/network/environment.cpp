#include "pal/check/network/environment.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pal/check/report.hpp"
#include "pal/support/duration_text.hpp"
#include "pal/support/finding.hpp"
#include "pal/support/nearest.hpp"

namespace pal::check {

namespace {

Interval& place_of(pan::Environment& environment, syntax::CostItem::Kind kind) {
  switch (kind) {
    case syntax::CostItem::Kind::send:
      return environment.costs.send;
    case syntax::CostItem::Kind::receive:
      return environment.costs.receive;
    case syntax::CostItem::Kind::set:
      return environment.costs.set;
    case syntax::CostItem::Kind::read:
      return environment.costs.read;
    case syntax::CostItem::Kind::test:
      return environment.costs.test;
    case syntax::CostItem::Kind::latency_within:
      return environment.latency.within_processor;
    case syntax::CostItem::Kind::latency_between:
      return environment.latency.between_processors;
  }
  return environment.costs.send;
}

pan::Resources::List resource_names(const std::optional<syntax::NameSlot>& slot) {
  if (!slot) return std::nullopt;
  std::vector<std::string> names;
  for (const auto& name : slot->names) names.push_back(name.text);
  return names;
}

/// Reports keys that come a second time.
template <class Key>
class Once {
 public:
  Once(std::string what, Diagnostics& diagnostics) : what_(std::move(what)), diagnostics_(diagnostics) {}

  void check(const Key& key, const std::string& shown, SourceSpan where) {
    const auto [first, fresh] = seen_.emplace(key, where);
    if (fresh) return;
    auto& finding = diagnostics_.report(Finding::item_given_twice, where, what_ + shown);
    finding.note(first->second, Remark::also_given);
  }

 private:
  std::string what_;
  Diagnostics& diagnostics_;
  std::map<Key, SourceSpan> seen_;
};

class BehaviourCheck {
 public:
  BehaviourCheck(SourceSpan where, Diagnostics& diagnostics) : where_(where), diagnostics_(diagnostics) {}

  void operator()(const pan::EventDevice& device) const {
    period(device.period);
    phase(device.phase, device.period);
    if (device.answer_within && *device.answer_within == Duration{}) {
      diagnostics_.report(Finding::answer_within_no_time, where_);
    }
    const Duration apart = device.period - device.jitter;
    if (device.answer_within > apart && apart > Duration{}) {
      diagnostics_.report(Finding::answer_after_next_event, where_, to_text(*device.answer_within),
                          to_text(apart));
    }
    if (device.sporadic && device.phase) {
      diagnostics_.report(Finding::sporadic_with_phase, where_);
    }
  }
  void operator()(const pan::RequestDevice&) const {}
  void operator()(const pan::FrameDevice& device) const {
    period(device.period);
    phase(device.phase, device.period);
    if (device.collecting == Duration{} && device.period > Duration{}) {
      diagnostics_.report(Finding::collected_in_no_time, where_);
    }
    if (device.collecting > device.period && device.period > Duration{}) {
      diagnostics_.report(Finding::collects_too_long, where_, to_text(device.collecting),
                          to_text(device.period));
    }
  }

 private:
  void period(Duration value) const {
    if (value > Duration{}) return;
    diagnostics_.report(Finding::period_zero, where_);
  }
  void phase(const std::optional<Duration>& value, Duration period) const {
    if (!value || period <= Duration{} || *value < period) return;
    diagnostics_.report(Finding::phase_not_below_period, where_, to_text(*value), to_text(period));
  }

  SourceSpan where_;
  Diagnostics& diagnostics_;
};

void check_placements(const pan::Environment& environment, Diagnostics& diagnostics) {
  std::vector<std::string> processors;
  for (const auto& processor : environment.processors) processors.push_back(processor.name);
  const std::set<std::string> known(processors.begin(), processors.end());
  if (known.empty()) return;  // said once, of the environment
  for (const auto& placement : environment.placements) {
    if (known.contains(placement.processor) || placement.processor.empty()) continue;
    const auto meant =
        may_guess(diagnostics, processors.size()) ? nearest(placement.processor, processors) : std::nullopt;
    diagnostics.report(Finding::unknown_processor, placement.where, placement.processor).suggest(meant);
  }
}

void check_twice(const syntax::EnvironmentUnit& written, Diagnostics& diagnostics) {
  Once<std::string> processors("processor ", diagnostics);
  for (const auto& p : written.processors) processors.check(p.name, quoted(p.name), p.where);
  Once<std::string> devices("device ", diagnostics);
  for (const auto& d : written.devices) devices.check(d.device, quoted(d.device), d.where);
  Once<std::string> places("the place of ", diagnostics);
  for (const auto& p : written.placements) places.check(p.thread, quoted(p.thread), p.where);
  Once<std::pair<std::string, std::string>> times("the time of ", diagnostics);
  for (const auto& t : written.activities) times.check({t.activity, t.module}, quoted(t.activity), t.where);
  Once<syntax::CostItem::Kind> costs("this cost", diagnostics);
  for (const auto& c : written.costs) costs.check(c.kind, "", c.where);
}

}  // namespace

void check_figures(const pan::Environment& environment, Diagnostics& diagnostics) {
  check_placements(environment, diagnostics);
  for (const auto& device : environment.devices) {
    std::visit(BehaviourCheck(device.where, diagnostics), device.behaviour);
  }
  if (environment.processors.empty()) {
    diagnostics.report(Finding::environment_without_processor, environment.where, environment.name);
  }
}

pan::Environment build_environment(const syntax::EnvironmentUnit& written, Diagnostics& diagnostics) {
  pan::Environment result;
  result.name = written.name.text;
  result.descriptions = written.descriptions;
  result.processors = written.processors;
  result.devices = written.devices;
  result.placements = written.placements;
  result.activities = written.activities;
  result.where = written.where;
  result.resources = {
      resource_names(written.resources.sensor_drivers), resource_names(written.resources.logical_sensors),
      resource_names(written.resources.machine_controllers), resource_names(written.resources.skills)};
  for (const auto& cost : written.costs) place_of(result, cost.kind) = cost.time;
  check_twice(written, diagnostics);
  check_figures(result, diagnostics);
  return result;
}

}  // namespace pal::check
