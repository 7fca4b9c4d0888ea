// The world of a problem: devices, and modules without a body, as the environment describes them.
#include <algorithm>
#include <set>

#include "analyzer/problem/problem_builder.hpp"
#include "pal/support/finding.hpp"
#include "pal/support/nearest.hpp"

namespace pal::analyzer {

using namespace pan;

void ProblemBuilder::devices() {
  std::vector<World> world;
  for (const pan::Device& device : network_.devices) world.push_back({device.name, device.where, false});
  for (const Module& module : network_.modules) {
    if (module.body.empty()) world.push_back({module.name, module.where, true});
  }
  std::set<std::string> described;
  for (const DeviceTiming& timing : environment_.devices) {
    if (!described.insert(timing.device).second) {
      diagnostics_.report(Finding::item_given_twice, timing.where, "device " + timing.device);
    }
  }
  sent_.resize(world.size());
  for (const ChannelId c : problem_.channels.ids()) {
    const DeviceId sender = problem_.channels[c].sender_device;
    if (sender.valid()) sent_[sender].push_back(c);
  }
  for (std::size_t d = 0; d < world.size(); ++d) device(world[d], DeviceId(d));
}

void ProblemBuilder::device(const World& thing, DeviceId index) {
  Device made;
  made.name = thing.name;
  std::set<ChannelId> sent(sent_[index].begin(), sent_[index].end());
  const auto described = timings_.find(thing.name);
  const DeviceTiming* timing = described == timings_.end() ? nullptr : described->second;
  if (timing == nullptr) {
    if (!sent.empty()) {
      auto& finding = diagnostics_.report(
          either<Finding::module_without_behaviour, Finding::device_without_behaviour>(thing.module),
          thing.where, thing.name, environment_.name);
      const auto is_of_another = [&](const DeviceTiming& each) {
        const auto is_it = [&](const auto& known) { return known.name == each.device; };
        return std::none_of(network_.devices.begin(), network_.devices.end(), is_it) &&
               std::none_of(network_.modules.begin(), network_.modules.end(), is_it);
      };
      for (const DeviceTiming& each : environment_.devices) {
        if (is_of_another(each) && nearest(thing.name, {each.device}))
          finding.note(each.where, Remark::meant_here, thing.name);
      }
    }
    problem_.devices.push_back(std::move(made));
    return;
  }
  if (const auto* event = std::get_if<EventDevice>(&timing->behaviour)) {
    event_device(*event, *timing, index, sent, made);
  } else {
    served_device(*timing, index, sent, made);
  }
  for (ChannelId c : sent) {
    diagnostics_.report(Finding::device_never_sends, timing->where, thing.name, problem_.channels[c].message);
  }
  problem_.devices.push_back(std::move(made));
}

void ProblemBuilder::phase(const std::optional<Duration>& value, Duration period, const DeviceTiming& timing,
                           const std::string& device) {
  if (!value) return;
  time(*value, timing.where, "the phase of " + device);
  if (*value < period) return;
  diagnostics_.report(Finding::phase_of_device_not_below_period, timing.where, device);
}

void ProblemBuilder::event_device(const EventDevice& event, const DeviceTiming& timing, DeviceId index,
                                  std::set<ChannelId>& sent, Device& made) {
  made.behaviour = event;
  time(event.period, timing.where, "the period of " + made.name, true);
  time(event.jitter, timing.where, "the jitter of " + made.name);
  if (event.jitter >= event.period && event.period.count() > 0) {
    diagnostics_.report(Finding::jitter_not_below_period, timing.where, made.name);
  }
  phase(event.phase, event.period, timing, made.name);
  for (const ChannelId c : sent_[index]) {
    if (problem_.channels[c].message != event.message) continue;
    made.event = c;
    sent.erase(made.event);
  }
  if (!made.event.valid()) {
    diagnostics_.report(Finding::nothing_waits_for_event, timing.where, network_.skill.name, event.message,
                        made.name);
  }
}

void ProblemBuilder::served_device(const DeviceTiming& timing, DeviceId index, std::set<ChannelId>& sent,
                                   Device& made) {
  if (const auto* request = std::get_if<RequestDevice>(&timing.behaviour)) {
    made.behaviour = *request;
    interval(request->answer, timing.where, "an answer of " + made.name);
  } else {
    const auto& frames = std::get<FrameDevice>(timing.behaviour);
    made.behaviour = frames;
    time(frames.period, timing.where, "the period of " + made.name, true);
    time(frames.collecting, timing.where, "collecting a frame of " + made.name);
    if (frames.collecting > frames.period) {
      diagnostics_.report(Finding::device_collects_too_long, timing.where, made.name);
    }
    phase(frames.phase, frames.period, timing, made.name);
  }
  for (const ChannelId c : problem_.channels.ids()) {
    Channel& channel = problem_.channels[c];
    if (channel.receiver_device != index || !channel.answer.valid()) continue;
    channel.served = true;
    made.requests.push_back(c);
    sent.erase(channel.answer);
  }
}

/// Waits without a limit for nothing but answers that may not come.
void ProblemBuilder::endless_waits() {
  const auto may_fail = [&](ChannelId channel) {
    const DeviceId device = problem_.channels[channel].sender_device;
    if (!device.valid()) return false;
    const auto* request = std::get_if<RequestDevice>(&problem_.devices[device].behaviour);
    return request != nullptr && request->may_fail;
  };
  std::set<std::pair<ModuleId, NodeId>> said;  // an executed module has its statements several times
  for (const Step& step : problem_.steps) {
    if (step.kind != Step::Kind::wait || step.within || !step.statement.valid() || step.channels.empty())
      continue;
    if (!std::all_of(step.channels.begin(), step.channels.end(), may_fail)) continue;
    const Statement& statement = problem_.statements[step.statement];
    if (!said.emplace(statement.source_module, statement.source_node).second) continue;
    const std::string& device = sender_name(problem_, step.channels.front());
    diagnostics_.report(Finding::may_never_answer, statement.where, device, statement.module);
  }
}

}  // namespace pal::analyzer
