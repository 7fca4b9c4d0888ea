#include "pal/runtime/trace_ring.hpp"

#include <algorithm>
#include <bit>
#include <string>

namespace pal::runtime {

TraceRing::TraceRing(std::size_t capacity)
    : events_(std::bit_ceil(std::max<std::size_t>(capacity, 1))), mask_(events_.size() - 1) {}

std::size_t TraceRing::take(std::span<trace::Event> room) noexcept {
  const std::uint64_t from = taken_.load(std::memory_order_relaxed);
  const std::uint64_t there = put_.load(std::memory_order_acquire) - from;
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(there, room.size()));
  for (std::size_t i = 0; i < count; ++i) room[i] = events_[(from + i) & mask_];
  taken_.store(from + count, std::memory_order_release);
  return count;
}

trace::Trace trace_tables(const Wiring& wiring) {
  trace::Trace tables;
  tables.skill = wiring.skill;
  tables.environment = wiring.environment;
  tables.origin = "measured";
  for (const ThreadSpec& thread : wiring.threads) {
    const auto processor = static_cast<std::size_t>(thread.processor);
    tables.actors.push_back({std::string(thread.name), false, std::string(wiring.processors[processor].name),
                             thread.priority, thread.parent});
  }
  for (std::size_t d = 0; d < wiring.devices.size(); ++d) {
    using Behaviour = DeviceTimes::Behaviour;
    const Behaviour behaviour = d < wiring.times.size() ? wiring.times[d].behaviour : Behaviour::unknown;
    const bool by_itself = behaviour == Behaviour::events || behaviour == Behaviour::sporadic;
    tables.actors.push_back({std::string(wiring.devices[d]), true, {}, 0, -1, by_itself});
  }
  for (const StatementSpec& statement : wiring.statements) {
    tables.statements.push_back({std::string(statement.module), std::string(statement.text),
                                 std::string(statement.file), statement.line});
  }
  for (const ChannelSpec& channel : wiring.channels) {
    tables.channels.push_back(
        {std::string(channel.sender), std::string(channel.message), std::string(channel.receiver)});
  }
  for (std::string_view condition : wiring.conditions) tables.conditions.emplace_back(condition);
  return tables;
}

}  // namespace pal::runtime
