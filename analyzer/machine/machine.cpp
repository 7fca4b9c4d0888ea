#include "analyzer/machine/machine.hpp"

#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {
int AllChoices::pick(int n) {
  if (at_ == taken_.size()) {
    taken_.push_back(0);
    of_.push_back(static_cast<std::uint8_t>(n));
  }
  return taken_[at_++];
}

bool AllChoices::next() {
  while (!taken_.empty()) {
    if (taken_.back() + 1 < of_.back()) {
      ++taken_.back();
      at_ = 0;
      return true;
    }
    taken_.pop_back();
    of_.pop_back();
  }
  return false;
}

int ScriptedChoices::pick(int n) {
  if (at_ == script_.size()) return 0;
  const int choice = script_[at_++];
  return choice < n ? choice : 0;
}

int Machine::timer_count() const {
  return pause_timer() + 1;
}

ProcessorId Machine::processor_of(const State& state, int timer) const {
  if (!is_of_thread(timer)) return ProcessorId{};
  const ThreadId thread = thread_of(timer);
  return state.threads[thread].status == Status::running ? problem_.threads[thread].processor : ProcessorId{};
}

Range Machine::cost(const State& state, int timer) const {
  const ThreadState& thread = state.threads[thread_of(timer)];
  const Step& step = problem_.steps[thread.at()];
  const bool gives_up = step.kind == Step::Kind::wait && thread.choice == ThreadState::gives_up;
  return gives_up ? step.give_up_cost : step.cost;
}

std::string Machine::timer_name(int timer) const {
  if (is_of_thread(timer)) return problem_.threads[thread_of(timer)].name;
  if (timer < first_device_timer()) {
    const ChannelId channel = channel_of(timer);
    return problem_.channels[channel].message + " from " + sender_name(problem_, channel) + " to " +
           receiver_name(problem_, channel) + (timer == flight_timer(channel) ? "" : " between processors");
  }
  if (timer == pause_timer()) return "a pause";
  const DeviceId device = device_of(timer);
  return problem_.devices[device].name + (timer == next_timer(device) ? "" : " service");
}

Outcome Machine::initial(Choices& choices, bool record) const {
  Outcome outcome;
  State& state = outcome.state;
  state.threads.resize(problem_.threads.size());
  state.running.assign(problem_.processors.size(), -1);
  state.slots.resize(problem_.channels.size());
  state.devices.resize(problem_.devices.size());
  if (watch_.kind == Watch::Kind::sample) {
    state.known.assign(problem_.conditions.size(), tag::none);
    state.kept.assign(problem_.kept.size(), tag::none);
  }
  Firing(*this, choices, record, outcome).begin();
  return outcome;
}

bool Machine::fire(const State& state, int timer, Choices& choices, bool record, Outcome& outcome) const {
  if (timer >= first_device_timer() && timer < pause_timer()) {
    const DeviceId device = device_of(timer);
    const DeviceState& of = state.devices[device];
    if (timer == next_timer(device) && of.serving.any() &&
        std::holds_alternative<pan::FrameDevice>(problem_.devices[device].behaviour)) {
      return false;
    }
  }
  outcome = {};
  outcome.state = state;
  Firing(*this, choices, record, outcome).fire(timer);
  return true;
}

void pass_cap(State& state, const Watch& watch, int number) {
  --state.observers;
  if (watch.kind == Watch::Kind::response) {
    int at = 0;
    for (Pending& pending : state.pending) {
      if (pending == Pending::over || pending == Pending::outside) continue;
      if (at++ == number) {
        pending = Pending::over;
        return;
      }
    }
    return;
  }
  // The oldest pass first: the reference before what is later.
  const std::uint8_t passed = watch.reaction && state.reference == tag::over ? tag::over_later : tag::over;
  const auto pass = [number, passed](std::uint8_t& carries) {
    if (carries >= tag::over) return;
    if (carries == number) {
      carries = passed;
    } else if (carries > number) {
      --carries;
    }
  };
  pass(state.condition_carries);
  pass(state.reference);
  for (ThreadState& thread : state.threads) pass(thread.carries);
  if (watch.kind != Watch::Kind::sample) return;
  for (std::uint8_t& known : state.known) pass(known);
  for (std::uint8_t& kept : state.kept) pass(kept);
  for (SlotState& slot : state.slots) {
    pass(slot.carries);
    pass(slot.serving_carries);
  }
}

bool grows(const State& state, const Watch& watch, int number) {
  if (!watch.grows()) return false;
  return watch.kind == Watch::Kind::response || state.reference == number;
}

}  // namespace pal::analyzer
