// Reading a change of a figure.
#include <algorithm>
#include <charconv>

#include "analyzer/whatif/figures.hpp"
#include "pal/support/duration_text.hpp"
#include "pal/support/nearest.hpp"

namespace pal::analyzer::whatif {
namespace {

const std::string activity_mark = "ACTIVITY ";
const std::string processor_mark = "PROCESSOR ";

std::optional<Duration> length(const std::string& number, const std::string& unit) {
  const auto parsed = parse_duration(number, unit);
  const auto* value = std::get_if<Duration>(&parsed);
  return value == nullptr ? std::nullopt : std::optional(*value);
}

std::string trimmed(const std::string& text) {
  const auto from = text.find_first_not_of(' ');
  return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(' ') - from + 1);
}

/// A number and what stands behind it: "5 ms", "1e-3 s", "5".
struct Amount {
  std::string number;
  std::string unit;
};

Amount amount(const std::string& text) {
  const auto last_digit = text.find_last_of("0123456789");
  if (last_digit == std::string::npos) return {"", trimmed(text)};
  return {trimmed(text.substr(0, last_digit + 1)), trimmed(text.substr(last_digit + 1))};
}

/// "5..7 ms", "5 TO 7 ms", "5 ms TO 0.1 s", "5 ms".
std::optional<Interval> interval(const std::string& text) {
  auto between = std::string::npos;
  for (const char* word : {"..", "TO", "to"}) {
    if (between == std::string::npos) between = text.find(word);
  }
  const bool one = between == std::string::npos;
  const Amount first = amount(text.substr(0, between));
  const Amount last = one ? first : amount(text.substr(between + 2));
  const auto best = length(first.number, first.unit.empty() ? last.unit : first.unit);
  const auto worst = length(last.number, last.unit);
  if (!best || !worst || *best > *worst || best->count() < 0) return std::nullopt;
  return Interval{*best, *worst};
}

/// What is meant instead of `name`, or what there is; empty: there is nothing.
std::string instead_of(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t most = 30;
  if (known.empty()) return {};
  std::string list;
  for (std::size_t i = 0; i < std::min(known.size(), most); ++i)
    list += (i == 0 ? "; there is '" : ", '") + known[i] + "'";
  if (known.size() > most) list += " and " + std::to_string(known.size() - most) + " more";
  const auto close = nearest(name, known);
  return list + (close ? "; did you mean '" + *close + "'?" : "");
}

std::string set_device(pan::Environment& environment, const std::string& device, const std::string& what,
                       const std::string& value) {
  const auto time = interval(value);
  if (!time || time->best != time->worst) return "'" + value + "' is no length of time";
  for (pan::DeviceTiming& timing : environment.devices) {
    if (timing.device != device) continue;
    auto* event = std::get_if<pan::EventDevice>(&timing.behaviour);
    auto* frames = std::get_if<pan::FrameDevice>(&timing.behaviour);
    if (event != nullptr && what == "period") return event->period = time->best, "";
    if (event != nullptr && what == "jitter") return event->jitter = time->best, "";
    if (event != nullptr && what == "phase") return event->phase = time->best, "";
    if (frames != nullptr && what == "period") return frames->period = time->best, "";
    if (frames != nullptr && what == "collecting") return frames->collecting = time->best, "";
    if (frames != nullptr && what == "phase") return frames->phase = time->best, "";
    return "device " + device + " has no " + what;
  }
  std::vector<std::string> known;
  for (const pan::DeviceTiming& timing : environment.devices) known.push_back(timing.device);
  return "there is no device " + device + " in environment " + environment.name + instead_of(device, known);
}

pan::Placement* placement_of(pan::Environment& environment, const std::string& thread) {
  for (pan::Placement& placement : environment.placements) {
    if (placement.thread == thread) return &placement;
  }
  // A block that is not placed runs where its module does; from now on it has a place of its own.
  const auto dot = thread.find('.');
  const pan::Placement* module =
      dot == std::string::npos ? nullptr : placement_of(environment, thread.substr(0, dot));
  if (module == nullptr) return nullptr;
  pan::Placement block = *module;
  block.thread = thread;
  return &environment.placements.emplace_back(std::move(block));
}

std::string set_placement(pan::Environment& environment, const std::string& thread, const std::string& what,
                          const std::string& value) {
  pan::Placement* found = placement_of(environment, thread);
  if (found == nullptr) {
    std::vector<std::string> known;
    for (const pan::Placement& placement : environment.placements) known.push_back(placement.thread);
    return "environment " + environment.name + " places no " + thread + instead_of(thread, known);
  }
  if (what == "processor") return found->processor = value, "";
  int priority = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), priority);
  if (error != std::errc() || end != value.data() + value.size()) return "'" + value + "' is no priority";
  return found->priority = priority, "";
}

std::string add_processor(pan::Environment& environment, const std::string& name) {
  const auto same = [&](const pan::Processor& each) { return each.name == name; };
  if (std::any_of(environment.processors.begin(), environment.processors.end(), same))
    return "environment " + environment.name + " has a processor " + name + " already";
  if (name.empty() || environment.processors.empty()) return "a processor needs a name: write PROCESSOR P4";
  pan::Processor more = environment.processors.back();
  more.name = name;
  environment.processors.push_back(std::move(more));
  return "";
}

}  // namespace

std::string change(pan::Environment& environment, const std::string& text) {
  const auto equals = text.find('=');
  const std::string all = trimmed(text);
  if (equals == std::string::npos && all.starts_with(processor_mark))
    return add_processor(environment, trimmed(all.substr(processor_mark.size())));
  if (equals == std::string::npos) return "'" + text + "' is no change: write NAME = VALUE";
  const std::string name = trimmed(text.substr(0, equals));
  const std::string value = trimmed(text.substr(equals + 1));
  if (const auto dot = name.rfind('.'); dot != std::string::npos) {
    const std::string what = name.substr(dot + 1);
    if (what == "priority" || what == "processor")
      return set_placement(environment, name.substr(0, dot), what, value);
    if (what == "period" || what == "jitter" || what == "phase" || what == "collecting")
      return set_device(environment, name.substr(0, dot), what, value);
  }
  const auto time = interval(value);
  bool known = false;
  if (Interval* figure = find_figure(environment, name)) {
    known = true;
    if (time) *figure = *time;
  }
  // One that is called as a cost is has the word before its name.
  const bool marked = name.starts_with(activity_mark) && is_common_figure(name.substr(activity_mark.size()));
  const std::string activity = marked                   ? name.substr(activity_mark.size())
                               : is_common_figure(name) ? ""
                                                        : name;
  for (pan::ActivityTime& each : environment.activities) {
    if (each.activity != activity) continue;
    known = true;
    if (time) each.time = *time;
  }
  if (!known)
    return "environment " + environment.name + " gives no figure for '" + name + "'" +
           instead_of(name, figure_names(environment));
  return time ? "" : "'" + value + "' is not a time: write 5 ms, or 5 TO 7 ms with the shorter one first";
}

}  // namespace pal::analyzer::whatif
