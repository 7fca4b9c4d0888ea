// The world of a problem: devices, and modules without a body, as the environment describes them.
#include <algorithm>
#include <set>

#include "analyzer/problem/problem_builder.hpp"
#include "pal/support/diagnostic_code.hpp"
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
      diagnostics_.report(Code::PAL0711, timing.where, "device " + timing.device + " is given twice",
                          "remove one of them");
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
      const std::string what = thing.module ? "module " + thing.name + " has no body, and environment "
                                            : "device " + thing.name + " sends messages, and environment ";
      auto& finding = diagnostics_.report(Code::PAL0724, thing.where,
                                          what + environment_.name + " does not say how it behaves",
                                          "add DEVICE " + thing.name + " … to the environment" +
                                              (thing.module ? ", or give the module a body" : ""));
      const auto is_of_another = [&](const DeviceTiming& each) {
        const auto is_it = [&](const auto& known) { return known.name == each.device; };
        return std::none_of(network_.devices.begin(), network_.devices.end(), is_it) &&
               std::none_of(network_.modules.begin(), network_.modules.end(), is_it);
      };
      for (const DeviceTiming& each : environment_.devices) {
        if (is_of_another(each) && nearest(thing.name, {each.device}))
          finding.notes.push_back({each.where, "is " + thing.name + " meant here?"});
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
    diagnostics_.report(
        Code::PAL0727, timing->where,
        thing.name + " never sends " + problem_.channels[c].message + ", which the skill waits for",
        "describe " + thing.name + " as a device that sends it, or do not wait for it");
  }
  problem_.devices.push_back(std::move(made));
}

void ProblemBuilder::phase(const std::optional<Duration>& value, Duration period, const DeviceTiming& timing,
                           const std::string& device) {
  if (!value) return;
  time(*value, timing.where, "the phase of " + device);
  if (*value < period) return;
  diagnostics_.report(Code::PAL0709, timing.where, "the phase of " + device + " is not below its period",
                      "write the phase within one period");
}

void ProblemBuilder::event_device(const EventDevice& event, const DeviceTiming& timing, DeviceId index,
                                  std::set<ChannelId>& sent, Device& made) {
  made.behaviour = event;
  time(event.period, timing.where, "the period of " + made.name, true);
  time(event.jitter, timing.where, "the jitter of " + made.name);
  if (event.jitter >= event.period && event.period.count() > 0) {
    diagnostics_.report(Code::PAL0726, timing.where,
                        "the jitter of " + made.name + " is not shorter than its period",
                        "make JITTER shorter than EVERY: a later event does not overtake an earlier one");
  }
  phase(event.phase, event.period, timing, made.name);
  for (const ChannelId c : sent_[index]) {
    if (problem_.channels[c].message != event.message) continue;
    made.event = c;
    sent.erase(made.event);
  }
  if (!made.event.valid()) {
    diagnostics_.report(
        Code::PAL0727, timing.where,
        "nothing in skill " + network_.skill.name + " waits for " + event.message + " from " + made.name,
        "add WTM( " + event.message + " from " + made.name +
            " ), or name the event that the skill waits for");
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
      diagnostics_.report(Code::PAL0710, timing.where,
                          made.name + " collects a frame for longer than its period",
                          "make COLLECTING at most EVERY");
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
    diagnostics_.report(Code::PAL0733, statement.where,
                        device + " may never answer, and " + statement.module + " waits without a limit",
                        "wait WITHIN a time, with an ELSE, or remove OR NEVER from DEVICE " + device);
  }
}

}  // namespace pal::analyzer
