#include "analyzer/whatif/figures.hpp"

#include <algorithm>
#include <set>

#include "pal/pan/times.hpp"

namespace pal::analyzer::whatif {
namespace {

struct Named {
  const char* name;
  Interval* time;
};

std::vector<Named> common(pan::Environment& environment) {
  pan::Costs& costs = environment.costs;
  return {{"SEND", &costs.send},
          {"RECEIVE", &costs.receive},
          {"SET", &costs.set},
          {"READ", &costs.read},
          {"TEST", &costs.test},
          {"LATENCY WITHIN PROCESSOR", &environment.latency.within_processor},
          {"LATENCY BETWEEN PROCESSORS", &environment.latency.between_processors}};
}

/// As it stands in the environment; an activity may be called as a cost is.
std::string name_of(const pan::ActivityTime& time) {
  if (!time.module.empty()) return time.activity + " OF " + time.module;
  return is_common_figure(time.activity) ? "ACTIVITY " + time.activity : time.activity;
}

/// Whether some activity of the network takes its time from this line.
bool is_used(const pan::Network& network, const pan::Environment& environment,
             const pan::ActivityTime& time) {
  return std::any_of(
      network.activities.begin(), network.activities.end(), [&](const pan::Activity& activity) {
        const std::string& module = network.modules[activity.module.index()].name;
        if (activity.name != time.activity) return false;
        if (!time.module.empty()) return time.module == module;
        return std::none_of(
            environment.activities.begin(), environment.activities.end(),
            [&](const auto& other) { return other.activity == time.activity && other.module == module; });
      });
}

bool is_party(const pan::Network& network, const std::string& name) {
  const auto is = [&](const auto& party) { return party.name == name; };
  return std::any_of(network.devices.begin(), network.devices.end(), is) ||
         std::any_of(network.modules.begin(), network.modules.end(), is);
}

}  // namespace

bool is_common_figure(const std::string& name) {
  pan::Environment any;
  const auto all = common(any);
  return std::any_of(all.begin(), all.end(), [&](const Named& each) { return name == each.name; });
}

std::vector<Figure> figures(const pan::Network& network, const pan::Environment& given) {
  const pan::Environment environment = pan::with_times_of(network, given);
  std::vector<Figure> all;
  for (const pan::ActivityTime& time : environment.activities) {
    if (is_used(network, environment, time)) all.push_back({name_of(time), time.time});
  }
  pan::Environment copy = environment;
  for (const Named& each : common(copy)) all.push_back({each.name, *each.time});
  for (const pan::DeviceTiming& device : environment.devices) {
    const auto* request = std::get_if<pan::RequestDevice>(&device.behaviour);
    if (request != nullptr && is_party(network, device.device))
      all.push_back({"answer of " + device.device, request->answer});
  }
  return all;
}

std::vector<std::string> figure_names(const pan::Environment& environment) {
  std::vector<std::string> all;
  for (const pan::ActivityTime& time : environment.activities) all.push_back(name_of(time));
  pan::Environment copy = environment;
  for (const Named& each : common(copy)) all.emplace_back(each.name);
  for (const pan::DeviceTiming& device : environment.devices) {
    if (std::holds_alternative<pan::RequestDevice>(device.behaviour))
      all.push_back("answer of " + device.device);
    const bool sends = std::holds_alternative<pan::EventDevice>(device.behaviour) ||
                       std::holds_alternative<pan::FrameDevice>(device.behaviour);
    if (sends) all.push_back(device.device + ".period");
  }
  return all;
}

Interval* find_figure(pan::Environment& environment, const std::string& name) {
  for (const Named& each : common(environment)) {
    if (name == each.name) return each.time;
  }
  for (pan::ActivityTime& time : environment.activities) {
    if (name == name_of(time)) return &time.time;
  }
  for (pan::DeviceTiming& device : environment.devices) {
    auto* request = std::get_if<pan::RequestDevice>(&device.behaviour);
    if (request != nullptr && name == "answer of " + device.device) return &request->answer;
  }
  return nullptr;
}

}  // namespace pal::analyzer::whatif
