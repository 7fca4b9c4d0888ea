#include "pal/check/resources.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "pal/check/report.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

Resource::Group group_of(pan::ModuleKind kind) {
  switch (kind) {
    case pan::ModuleKind::sensor_driver:
      return Resource::Group::sensor_driver;
    case pan::ModuleKind::logical_sensor:
      return Resource::Group::logical_sensor;
    case pan::ModuleKind::machine_controller:
      return Resource::Group::robotic_machine;
    case pan::ModuleKind::skill_module:
    case pan::ModuleKind::contingency_module:
      return Resource::Group::skill_module;
  }
  return Resource::Group::skill_module;
}

class Collector {
 public:
  explicit Collector(const pan::Network& network) : network_(network) {}

  std::vector<Resource> collect() {
    const auto& skill = network_.skill;
    add(Resource::Group::generic_skill, Resource::Kind::listed, skill.name, skill.name, skill.where);
    for (std::size_t i = 0; i < network_.modules.size(); ++i) module(pan::ModuleId(i));
    for (const auto& channel : network_.channels) device(channel);
    for (const auto& module : network_.modules) activities(module);
    std::stable_sort(result_.begin(), result_.end(),
                     [](const Resource& a, const Resource& b) { return a.group < b.group; });
    return std::move(result_);
  }

 private:
  void add(Resource::Group group, Resource::Kind kind, const std::string& name, const std::string& module,
           SourceSpan where) {
    if (seen_.insert({group, kind, name, kind == Resource::Kind::time ? module : ""}).second)
      result_.push_back({group, kind, name, module, where});
  }

  void module(pan::ModuleId id) {
    const auto& module = network_.modules[id.index()];
    if (module.executed_by.valid()) return;  // runs in its caller's place
    if (group_of(module.kind) != Resource::Group::skill_module) {
      add(group_of(module.kind), Resource::Kind::listed, module.name, module.name, module.where);
    }
    if (module.body.empty() && !sends(id)) return;  // takes what comes; how it behaves does not matter
    const auto kind = module.body.empty() ? Resource::Kind::device : Resource::Kind::processor;
    add(group_of(module.kind), kind, module.name, module.name, module.where);
  }

  bool sends(const pan::Party& party) const {
    return std::any_of(network_.channels.begin(), network_.channels.end(),
                       [&](const pan::Channel& channel) { return channel.sender == party; });
  }

  /// A device belongs to the module that drives it.
  void device(const pan::Channel& channel) {
    for (const auto& [party, other] :
         {std::pair(channel.sender, channel.receiver), std::pair(channel.receiver, channel.sender)}) {
      const auto* device = std::get_if<pan::DeviceId>(&party);
      const auto* driver = std::get_if<pan::ModuleId>(&other);
      if (device == nullptr || driver == nullptr || !sends(party)) continue;
      const auto& module = network_.modules[driver->index()];
      const auto& found = network_.devices[device->index()];
      add(group_of(module.kind), Resource::Kind::device, found.name, module.name, found.where);
    }
  }

  void activities(const pan::Module& module) {
    for (const auto& node : module.body.nodes) {
      const auto* perform = std::get_if<pan::Perform>(&node.content);
      if (perform == nullptr) continue;
      const auto& activity = network_.activities[perform->activity.index()];
      if (activity.time) continue;
      add(Resource::Group::activity, Resource::Kind::time, activity.name, module.name, activity.where);
    }
  }

  const pan::Network& network_;
  std::vector<Resource> result_;
  std::set<std::tuple<Resource::Group, Resource::Kind, std::string, std::string>> seen_;
};

/// The environment's list of the group; empty: it has none.
pan::Resources::List list_of(const pan::Environment& environment, Resource::Group group) {
  switch (group) {
    case Resource::Group::sensor_driver:
      return environment.resources.sensor_drivers;
    case Resource::Group::logical_sensor:
      return environment.resources.logical_sensors;
    case Resource::Group::robotic_machine:
      return environment.resources.machine_controllers;
    case Resource::Group::generic_skill:
      return environment.resources.skills;
    case Resource::Group::skill_module:
    case Resource::Group::activity:
      return std::nullopt;
  }
  return std::nullopt;
}

bool has(const pan::Environment& environment, const Resource& resource) {
  const auto any = [](const auto& range, const auto& fits) {
    return std::any_of(range.begin(), range.end(), fits);
  };
  switch (resource.kind) {
    case Resource::Kind::processor:
      return any(environment.placements, [&](const pan::Placement& p) { return p.thread == resource.name; });
    case Resource::Kind::device:
      return any(environment.devices, [&](const pan::DeviceTiming& d) { return d.device == resource.name; });
    case Resource::Kind::time:
      return any(environment.activities, [&](const pan::ActivityTime& t) {
        return t.activity == resource.name && (t.module.empty() || t.module == resource.module);
      });
    case Resource::Kind::listed: {
      const auto list = list_of(environment, resource.group);
      return !list || any(*list, [&](const std::string& name) { return name == resource.name; });
    }
  }
  return false;
}

}  // namespace

std::vector<Resource> needed_resources(const pan::Network& network) {
  return Collector(network).collect();
}

std::vector<Resource> needed_resources(const std::vector<pan::Network>& skills) {
  std::vector<Resource> result;
  std::set<std::tuple<Resource::Group, Resource::Kind, std::string, std::string>> seen;
  for (const auto& skill : skills) {
    for (auto& resource : needed_resources(skill)) {
      if (seen.emplace(resource.group, resource.kind, resource.name, resource.module).second)
        result.push_back(std::move(resource));
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Resource& a, const Resource& b) { return a.group < b.group; });
  return result;
}

std::vector<Resource> missing_resources(const std::vector<Resource>& needed,
                                        const pan::Environment& environment) {
  std::vector<Resource> result;
  std::copy_if(needed.begin(), needed.end(), std::back_inserter(result),
               [&](const Resource& resource) { return !has(environment, resource); });
  return result;
}

std::string group_text(Resource::Group group) {
  switch (group) {
    case Resource::Group::sensor_driver:
      return "sensor drivers";
    case Resource::Group::logical_sensor:
      return "logical sensors";
    case Resource::Group::robotic_machine:
      return "robotic machines";
    case Resource::Group::generic_skill:
      return "generic skills";
    case Resource::Group::skill_module:
      return "skill modules";
    case Resource::Group::activity:
      return "activities";
  }
  return {};
}

std::string kind_text(Resource::Kind kind) {
  switch (kind) {
    case Resource::Kind::processor:
      return "a processor (PLACE)";
    case Resource::Kind::device:
      return "a behaviour (DEVICE)";
    case Resource::Kind::time:
      return "a time (TIME)";
    case Resource::Kind::listed:
      return "to be listed";
  }
  return {};
}

void check_listed(const pan::Network& network, const pan::Environment& environment,
                  Diagnostics& diagnostics) {
  auto needed = needed_resources(network);
  std::erase_if(needed, [](const Resource& resource) { return resource.kind != Resource::Kind::listed; });
  const auto missing = missing_resources(needed, environment);
  if (missing.empty()) return;
  auto& finding = diagnostics.report(Finding::resources_not_listed, environment.where, environment.name,
                                     network.skill.name);
  for (const auto& resource : missing) {
    finding.note(resource.where, Remark::resource, group_text(resource.group), resource.name);
  }
}

}  // namespace pal::check
