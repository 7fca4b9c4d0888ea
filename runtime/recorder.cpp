#include "runtime/recorder.hpp"

#include <algorithm>
#include <utility>

namespace pal::runtime {

Recorder::Recorder(const Wiring& wiring, TraceMode mode, std::size_t capacity)
    : mode_(mode), capacity_(std::max<std::size_t>(capacity, 1)) {
  trace_.skill = wiring.skill;
  trace_.environment = wiring.environment;
  trace_.origin = "measured";
  for (const ThreadSpec& thread : wiring.threads) {
    const auto processor = static_cast<std::size_t>(thread.processor);
    trace_.actors.push_back({std::string(thread.name), false, std::string(wiring.processors[processor].name),
                             thread.priority, thread.parent});
  }
  for (std::string_view device : wiring.devices) trace_.actors.push_back({std::string(device), true, {}, 0});
  for (const StatementSpec& statement : wiring.statements) {
    trace_.statements.push_back({std::string(statement.module), std::string(statement.text),
                                 std::string(statement.file), statement.line});
  }
  for (const ChannelSpec& channel : wiring.channels) {
    trace_.channels.push_back(
        {std::string(channel.sender), std::string(channel.message), std::string(channel.receiver)});
  }
  for (std::string_view condition : wiring.conditions) trace_.conditions.emplace_back(condition);
  if (mode != TraceMode::none) trace_.events.reserve(capacity_);
}

void Recorder::add_fault(Time time, int actor, int statement, const std::string& reason) {
  trace_.faults.push_back(reason);
  add(time, trace::Kind::fault, actor, statement, -1, static_cast<std::int32_t>(trace_.faults.size() - 1));
}

trace::Trace Recorder::take() {
  std::rotate(trace_.events.begin(), trace_.events.begin() + static_cast<std::ptrdiff_t>(oldest_),
              trace_.events.end());
  return std::move(trace_);
}

}  // namespace pal::runtime
