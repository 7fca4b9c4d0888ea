#include "tests/support/runs/state.hpp"

namespace pal::test::runs {

namespace {

class Key {
 public:
  void add(std::int64_t value) {
    text.push_back(static_cast<char>(value & 0xff));
    text.push_back(static_cast<char>(value >> 8 & 0xff));
  }
  void add(const Thread& thread) {
    add(static_cast<int>(thread.status));
    add(static_cast<int>(thread.at.size()));
    for (const auto& [module, at] : thread.at) {
      add(module);
      add(at);
    }
    add(thread.left);
    add(thread.limit);
    add(thread.claim);
    add((thread.begun ? 1 : 0) + (thread.withdrawn ? 2 : 0) + (thread.gives_up ? 4 : 0) +
        (thread.cancelled ? 8 : 0));
    add(thread.latched);
    add(thread.latched_true);
    add(thread.carries);
  }
  void add(const Slot& slot) {
    add((slot.full ? 1 : 0) + (slot.answers ? 2 : 0));
    add(slot.claimed);
    add(slot.from);
    add(slot.near);
    add(slot.far);
    add(slot.carries);
    add(slot.later);
    add(static_cast<int>(slot.asked.size()));
    for (const Asked& asked : slot.asked) add(asked.withdrawn ? -2 : asked.owner);
    add(slot.serving_carries);
  }
  void add(const Device& device) {
    add(device.open ? 1 : 0);
    add(device.next);
    add(device.late);
    add(device.service);
    add(device.serving);
  }

  std::string text;
};

}  // namespace

std::string key(const State& state) {
  Key key;
  for (std::size_t t = 0; t < state.threads.size(); ++t) {
    if (state.threads[t].status == Status::off) continue;
    key.add(static_cast<int>(t));
    key.add(state.threads[t]);
  }
  key.add(-7);
  for (int running : state.running) key.add(running);
  for (const auto& queue : state.queues) {
    key.add(-8);
    for (int thread : queue) key.add(thread);
  }
  for (const Slot& slot : state.slots) key.add(slot);
  for (const Device& device : state.devices) key.add(device);
  key.add(state.conditions);
  for (int known : state.known) key.add(known);
  key.add(state.reference);
  for (int busy : state.busy) key.add(busy);
  key.add((state.counting ? 1 : 0) + (state.in_phase ? 2 : 0));
  key.add(static_cast<int>(state.lost.size()));
  for (bool lost : state.lost) key.add(lost ? 1 : 0);
  for (int age : state.births) key.add(age);
  return key.text;
}

}  // namespace pal::test::runs
