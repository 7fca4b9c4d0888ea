#include "pal/runtime/dispatcher.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "pal/runtime/broken_promise.hpp"
#include "runtime/kernel/ports.hpp"
#include "runtime/kernel/thrown.hpp"
#include "runtime/run.hpp"
#include "runtime/watch/recorder.hpp"

namespace pal::runtime {

namespace {

/// "; there are gauge, axis"
std::string names_of(std::span<Device* const> devices) {
  std::string names;
  for (const Device* device : devices) names += (names.empty() ? "" : ", ") + device->name();
  return names.empty() ? "; no device was given" : "; there are " + names;
}

/// What goes that way through the ports: "; it sends tock", "; it takes nothing".
std::string messages_of(const std::vector<PortSpec>& ports, bool to_device) {
  std::string messages;
  for (const PortSpec& port : ports)
    if (port.to_device == to_device) messages += (messages.empty() ? "" : ", ") + port.message;
  return (to_device ? "; it takes " : "; it sends ") + (messages.empty() ? "nothing" : messages);
}

Connection connect(const Wiring& wiring, std::string_view name, std::span<Device* const> devices) {
  const auto found = std::find_if(devices.begin(), devices.end(),
                                  [&](const Device* device) { return device->name() == name; });
  const std::string called(name);
  if (found == devices.end()) throw std::runtime_error("there is no device " + called + names_of(devices));
  Connection connection{*found, std::vector<int>((*found)->ports().size(), -1)};
  const std::vector<PortSpec>& ports = (*found)->ports();
  for (std::size_t c = 0; c < wiring.channels.size(); ++c) {
    const ChannelSpec& channel = wiring.channels[c];
    const bool to = channel.to_device && channel.receiver == name;
    const bool from = channel.from_device && channel.sender == name;
    if (!to && !from) continue;
    const auto port = std::find_if(ports.begin(), ports.end(), [&](const PortSpec& candidate) {
      return candidate.message == channel.message && candidate.to_device == to;
    });
    const std::string differs =
        port == ports.end() ? messages_of(ports, to) : difference(channel.fields, port->fields);
    if (!differs.empty()) {
      throw std::runtime_error("device " + called + (to ? " does not take " : " does not send ") +
                               std::string(channel.message) + " with " + in_words(channel.fields) +
                               (port == ports.end() ? "" : ": ") + differs);
    }
    connection.channels[static_cast<std::size_t>(port - ports.begin())] = static_cast<int>(c);
  }
  return connection;
}

/// Times that an arithmetic of instants would not survive, and devices that are not there.
void check(std::span<Device* const> devices, const RunOptions& options) {
  constexpr Time longest = std::chrono::hours(24) * 365 * 100;
  for (std::size_t i = 0; i < devices.size(); ++i)
    if (devices[i] == nullptr) throw std::runtime_error("device " + std::to_string(i + 1) + " is null");
  if (options.horizon <= Time::zero())
    throw std::runtime_error("horizon is " + in_words(options.horizon) + "; it must be more than nothing");
  if (!options.real_time) return;
  const Time hang = options.real_time->hang_timeout, look_out = options.real_time->look_out;
  if (options.horizon > longest) throw std::runtime_error("horizon is longer than 100 years");
  if (hang <= Time::zero() || hang > longest)
    throw std::runtime_error("hang_timeout is " + in_words(hang) +
                             "; it must be more than nothing, and at most 100 years");
  if (look_out < Time::zero() || look_out > longest)
    throw std::runtime_error("look_out is " + in_words(look_out) +
                             "; it must not be negative, and be at most 100 years");
}

/// Takes what a run uses, and frees it in the end.
class Taken {
 public:
  Taken() = default;
  Taken(const Taken&) = delete;
  Taken& operator=(const Taken&) = delete;
  ~Taken() {
    for (InUse* each : taken_) each->free();
  }
  void take(InUse& in_use, const std::string& otherwise) {
    if (!in_use.take()) throw std::runtime_error(otherwise);
    taken_.push_back(&in_use);
  }

 private:
  std::vector<InUse*> taken_;
};

}  // namespace

Outcome refused(const Skill& skill, const std::string& reason) {
  Outcome outcome;
  outcome.fault = true;
  outcome.code = -1;
  for (const CompletionSpec& completion : skill.description().completions) {
    if (completion.kind != CompletionSpec::Kind::error) continue;
    outcome.code = completion.code;
    break;
  }
  outcome.reason = reason;
  Recorder recorder(skill.wiring(), TraceMode::all, 2);
  recorder.next() = {0, trace::Kind::fault, -1, -1, -1, recorder.add_fault(reason)};
  recorder.next() = {0, trace::Kind::complete, -1, -1, -1, outcome.code};
  outcome.trace = recorder.take();
  return outcome;
}

Outcome Dispatcher::run(Skill& skill, std::span<const ParameterValue> parameters, const RunOptions& options) {
  Taken taken;
  std::vector<Connection> connections;
  try {
    taken.take(in_use_, "another skill is running; a dispatcher runs one at a time");
    check(devices_, options);
    taken.take(skill.in_use(), "the skill is running already");
    taken.take(world_.in_use(), "the world is in use by a skill that is running");
    skill.reset_parameters();
    for (const ParameterValue& parameter : parameters) {
      if (parameter.text) {
        skill.set_text_parameter(parameter.name, *parameter.text);
      } else {
        skill.set_parameter(parameter.name, parameter.value);
      }
    }
    for (std::string_view device : skill.wiring().devices) {
      connections.push_back(connect(skill.wiring(), device, devices_));
      taken.take(connections.back().device->in_use(),
                 "device " + std::string(device) + " is in use by a skill that is running");
    }
    return runtime::run(skill, world_, connections, options);
  } catch (...) {
    return refused(skill, what_was_thrown());
  }
}

}  // namespace pal::runtime
