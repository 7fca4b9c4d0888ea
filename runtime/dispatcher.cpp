#include "runtime/dispatcher.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "runtime/ports.hpp"
#include "runtime/recorder.hpp"
#include "runtime/run.hpp"

namespace pal::runtime {

namespace {

Connection connect(const Wiring& wiring, std::string_view name, std::span<Device* const> devices) {
  const auto found = std::find_if(devices.begin(), devices.end(),
                                  [&](const Device* device) { return device->name() == name; });
  const std::string called(name);
  if (found == devices.end()) throw std::runtime_error("there is no device " + called);
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
    const std::string differs = port == ports.end() ? "" : difference(channel.fields, port->fields);
    if (port == ports.end() || !differs.empty()) {
      throw std::runtime_error("device " + called + (to ? " does not take " : " does not send ") +
                               std::string(channel.message) + " with " + in_words(channel.fields) +
                               (differs.empty() ? "" : ": " + differs));
    }
    connection.channels[static_cast<std::size_t>(port - ports.begin())] = static_cast<int>(c);
  }
  return connection;
}

Outcome refuse(const Skill& skill, const std::string& reason) {
  Outcome outcome;
  outcome.fault = true;
  outcome.code = -1;
  for (const CompletionSpec& completion : skill.description().completions) {
    if (completion.kind != CompletionSpec::Kind::error) continue;
    outcome.code = completion.code;
    break;
  }
  outcome.reason = reason;
  Recorder recorder(skill.wiring(), 2);
  recorder.add_fault(Time::zero(), -1, -1, reason);
  recorder.add(Time::zero(), trace::Kind::complete, -1, -1, -1, outcome.code);
  outcome.trace = recorder.take();
  return outcome;
}

}  // namespace

Outcome Dispatcher::run(Skill& skill, std::span<const ParameterValue> parameters, const RunOptions& options) {
  std::vector<Connection> connections;
  try {
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
    }
  } catch (const std::runtime_error& error) {
    return refuse(skill, error.what());
  }
  return Run(skill, world_, connections, options).execute();
}

}  // namespace pal::runtime
