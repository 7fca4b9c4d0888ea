#include "pal/trace/age_meter.hpp"

#include <algorithm>

#include "trace/requests.hpp"

namespace pal::trace {

void ConditionFlow::see(const Event& event, std::int32_t parent) {
  inherit(event, parent, known_);
  if (event.subject != condition_) return;
  if (event.kind == Kind::set) set_ = begin(event.time_ns);
  if (event.kind == Kind::read) known_[static_cast<std::size_t>(event.actor)] = set_;
}

SampleFlow::SampleFlow(const Trace& tables, Marks channels, Kept kept)
    : channels_(std::move(channels)),
      kept_(std::move(kept)),
      request_(requests_of(tables)),
      answer_(answers_of(request_)),
      device_(devices_of(tables)),
      marks_(tables.actors.size()),
      serves_(tables.actors.size()),
      put_(tables.channels.size()),
      answered_(tables.actors.size()),
      serving_(room_for_requests<Birth>(request_)),
      on_message_(tables.channels.size()),
      on_condition_(tables.conditions.size()),
      in_module_(kept_.count),
      known_(tables.actors.size()) {
  kept_.of_channel.resize(tables.channels.size(), -1);
  kept_.used.resize(tables.statements.size());
  kept_.written.resize(tables.statements.size());
}

/// The device takes a request. A frame that serves several makes one sample.
Birth SampleFlow::served(const Event& event) {
  const auto device = static_cast<std::size_t>(event.actor);
  const auto request = static_cast<std::size_t>(event.subject);
  const bool again = serves_[device];
  serves_[device] = marks_[device];
  if (answer_[request] < 0 || !channels_[static_cast<std::size_t>(answer_[request])]) return {};
  if (!marks_[device]) return sample(std::max(put_[request], answered_[device]));
  return again && newest_.number > 0 && newest_.time_ns == event.time_ns ? newest_ : sample(event.time_ns);
}

Birth SampleFlow::said_by_device(const Event& event) {
  const auto channel = static_cast<std::size_t>(event.subject);
  const std::int32_t request = request_[channel];
  serves_[static_cast<std::size_t>(event.actor)] = false;
  answered_[static_cast<std::size_t>(event.actor)] = event.time_ns;
  if (request >= 0) return take_first(serving_[static_cast<std::size_t>(request)], Birth{});
  return channels_[channel] && event.kind == Kind::put ? sample(event.time_ns) : Birth{};
}

void SampleFlow::use_what_is_kept(const Event& event) {
  if (event.statement < 0) return;
  for (const std::int32_t each : kept_.used[static_cast<std::size_t>(event.statement)])
    newer(known_[static_cast<std::size_t>(event.actor)], in_module_[static_cast<std::size_t>(each)]);
}

void SampleFlow::see(const Event& event, std::int32_t parent) {
  inherit(event, parent, known_);
  if (event.actor < 0 || (event.kind == Kind::drop && event.value == unasked)) return;
  const auto actor = static_cast<std::size_t>(event.actor);
  const auto subject = static_cast<std::size_t>(event.subject);
  switch (event.kind) {
    case Kind::put:
    case Kind::drop:
    case Kind::overrun: {
      if (!device_[actor]) use_what_is_kept(event);
      const Birth said = device_[actor] ? said_by_device(event) : known_[actor];
      if (event.kind != Kind::put) break;
      put_[subject] = event.time_ns;
      on_message_[subject] = said;
      break;
    }
    case Kind::take:
      if (device_[actor]) {
        const Birth birth = served(event);
        if (answer_[subject] >= 0) serving_[subject].push_back(birth);
      } else {
        newer(known_[actor], on_message_[subject]);
        const std::int32_t kept = kept_.of_channel[subject];
        if (kept >= 0) in_module_[static_cast<std::size_t>(kept)] = on_message_[subject];
      }
      break;
    case Kind::busy:
      marks_[actor] = true;
      serves_[actor] = false;
      break;
    case Kind::set:
      use_what_is_kept(event);
      on_condition_[subject] = known_[actor];
      break;
    case Kind::read:
      newer(known_[actor], on_condition_[subject]);
      break;
    case Kind::done:
      use_what_is_kept(event);
      break;
    default:
      break;
  }
}

void SampleFlow::after(const Event& event) {
  if (event.kind != Kind::done || event.statement < 0) return;
  for (const std::int32_t each : kept_.written[static_cast<std::size_t>(event.statement)])
    in_module_[static_cast<std::size_t>(each)] = known_[static_cast<std::size_t>(event.actor)];
}

}  // namespace pal::trace
