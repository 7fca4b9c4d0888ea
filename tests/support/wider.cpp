#include "tests/support/wider.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace pal::test {
namespace {

constexpr Duration millisecond = std::chrono::milliseconds(1);

std::int64_t chance(std::mt19937_64& engine, std::int64_t n) {
  return static_cast<std::int64_t>(engine() % static_cast<std::uint64_t>(n));
}

using Named = std::vector<std::pair<std::string, Interval*>>;

Named intervals(pan::Environment& environment) {
  Named all;
  for (pan::ActivityTime& each : environment.activities) all.emplace_back(each.activity, &each.time);
  for (pan::DeviceTiming& each : environment.devices) {
    if (auto* answers = std::get_if<pan::RequestDevice>(&each.behaviour))
      all.emplace_back("answer of " + each.device, &answers->answer);
  }
  all.emplace_back("send", &environment.costs.send);
  all.emplace_back("receive", &environment.costs.receive);
  all.emplace_back("set", &environment.costs.set);
  all.emplace_back("read", &environment.costs.read);
  all.emplace_back("test", &environment.costs.test);
  all.emplace_back("latency within", &environment.latency.within_processor);
  all.emplace_back("latency between", &environment.latency.between_processors);
  return all;
}

std::vector<Duration*> limits(pan::Network& network) {
  std::vector<Duration*> all;
  for (pan::Module& module : network.modules) {
    for (pan::Node& node : module.body.nodes) {
      auto* wait = std::get_if<pan::Wait>(&node.content);
      if (wait != nullptr && wait->within) all.push_back(&*wait->within);
    }
  }
  return all;
}

std::vector<pan::Set*> sets(pan::Network& network) {
  std::vector<pan::Set*> all;
  for (pan::Module& module : network.modules) {
    for (pan::Node& node : module.body.nodes) {
      auto* set = std::get_if<pan::Set>(&node.content);
      if (set != nullptr && set->value) all.push_back(set);
    }
  }
  return all;
}

std::string text(Duration time) {
  return std::to_string(time.count() / millisecond.count());
}

std::string widen(Interval& interval, std::mt19937_64& engine) {
  const Duration less = std::min(interval.best, millisecond * chance(engine, 3));
  interval.best -= less;
  interval.worst += millisecond * (chance(engine, 3) + (less == Duration{} ? 1 : 0));
  return text(interval.best) + " to " + text(interval.worst);
}

std::string widen(pan::DeviceTiming& timing, std::mt19937_64& engine) {
  auto* event = std::get_if<pan::EventDevice>(&timing.behaviour);
  auto* frames = std::get_if<pan::FrameDevice>(&timing.behaviour);
  if (frames != nullptr && frames->phase) {
    frames->phase.reset();
    return timing.device + " without phase";
  }
  if (event == nullptr) return {};
  switch (chance(engine, 4)) {
    case 0:
      if (!event->phase) return {};
      event->phase.reset();
      return timing.device + " without phase";
    case 1:
      if (event->sporadic) return {};
      event->sporadic = true;
      event->phase.reset();
      return timing.device + " sporadic";
    case 2:
      if (!event->sporadic || event->period - event->jitter <= 2 * millisecond) return {};
      event->period -= millisecond;
      return timing.device + " closer";
    default:
      if (event->period - event->jitter <= 2 * millisecond) return {};
      event->jitter += millisecond;
      return timing.device + " late";
  }
}

std::vector<Duration*> times(pan::Network& network, pan::Environment& environment) {
  std::vector<Duration*> all = limits(network);
  for (pan::Requirement& requirement : network.requirements) {
    if (auto* passes = std::get_if<pan::Passes>(&requirement.measure)) {
      if (passes->least) all.push_back(&*passes->least);
      if (passes->most) all.push_back(&*passes->most);
    }
    if (!std::holds_alternative<pan::Load>(requirement.measure)) all.push_back(&requirement.limit);
  }
  for (const auto& [name, interval] : intervals(environment)) {
    all.push_back(&interval->best);
    all.push_back(&interval->worst);
  }
  for (pan::DeviceTiming& timing : environment.devices) {
    if (auto* event = std::get_if<pan::EventDevice>(&timing.behaviour)) {
      all.insert(all.end(), {&event->period, &event->jitter});
      if (event->phase) all.push_back(&*event->phase);
      if (event->answer_within) all.push_back(&*event->answer_within);
    } else if (auto* frames = std::get_if<pan::FrameDevice>(&timing.behaviour)) {
      all.insert(all.end(), {&frames->period, &frames->collecting});
      if (frames->phase) all.push_back(&*frames->phase);
    }
  }
  return all;
}

std::string other_rhythm(pan::DeviceTiming& timing, std::mt19937_64& engine) {
  if (chance(engine, 3) != 0) return {};
  const Duration period = millisecond * (std::int64_t{1} << chance(engine, 4));
  const bool other = chance(engine, 2) == 0;
  if (auto* frames = std::get_if<pan::FrameDevice>(&timing.behaviour)) {
    if (other) frames->period = period;
    frames->collecting = chance(engine, 2) == 0 ? std::min(millisecond, frames->period) : frames->period;
    frames->phase = Duration{};
    return timing.device + " every " + text(frames->period) + " collecting " + text(frames->collecting) +
           ", ";
  }
  auto* event = std::get_if<pan::EventDevice>(&timing.behaviour);
  if (event == nullptr) return {};
  if (other && !event->answer_within) {
    event->period = period;
    event->jitter = {};
  }
  if (event->sporadic) return timing.device + " from every " + text(event->period) + ", ";
  event->phase = Duration{};
  return timing.device + " every " + text(event->period) + " from 0, ";
}

}  // namespace

std::string other_times(pan::Network& network, pan::Environment& environment, std::mt19937_64& engine) {
  std::string done;
  const Duration few[] = {{}, {}, {}, millisecond, 2 * millisecond, 5 * millisecond};
  for (const auto& [name, interval] : intervals(environment)) {
    if (chance(engine, 3) != 0) continue;
    const Duration fixed = chance(engine, 2) == 0 ? interval->worst : few[chance(engine, std::ssize(few))];
    *interval = {fixed, fixed};
    done += name + " " + text(fixed) + ", ";
  }
  for (Duration* limit : limits(network)) {
    if (chance(engine, 4) != 0) continue;
    *limit = few[chance(engine, std::ssize(few))];
    done += "limit " + text(*limit) + ", ";
  }
  for (pan::DeviceTiming& timing : environment.devices) done += other_rhythm(timing, engine);
  return done;
}

std::string widen(pan::Network& network, pan::Environment& environment, std::mt19937_64& engine) {
  std::string done;
  const Named all = intervals(environment);
  const std::vector<pan::Set*> fixed = sets(network);
  for (std::int64_t times = 1 + chance(engine, 4); times > 0; --times) {
    std::string what;
    switch (chance(engine, 4)) {
      case 0:
        if (environment.devices.empty()) break;
        what = widen(environment.devices[engine() % environment.devices.size()], engine);
        break;
      case 1:
        if (fixed.empty()) break;
        fixed[engine() % fixed.size()]->value.reset();
        what = "any value";
        break;
      default: {
        const auto& [name, interval] = all[engine() % all.size()];
        what = name + " " + widen(*interval, engine);
      }
    }
    if (!what.empty()) done += what + ", ";
  }
  return done;
}

void scale(pan::Network& network, pan::Environment& environment, int by) {
  for (Duration* time : times(network, environment)) *time *= by;
}

Duration grain(pan::Network network, pan::Environment environment) {
  std::int64_t common = 0;
  for (const Duration* time : times(network, environment)) common = std::gcd(common, time->count());
  return Duration(std::max<std::int64_t>(common, 1));
}

}  // namespace pal::test
