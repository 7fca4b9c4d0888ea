// One event of the machine, from the timer that fires to the threads that run afterwards.
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "analyzer/machine/machine.hpp"

namespace pal::analyzer {

class Firing {
 public:
  /// Works on `outcome.state`, which is the state before.
  Firing(const Machine& machine, Choices& choices, bool record, Outcome& outcome);

  void begin();
  void fire(int timer);

 private:
  using Kind = trace::Kind;
  /// Threads of one priority on one processor.
  using Queue = std::pair<ProcessorId, int>;

  /// Consequences that are still to happen at this instant, in any order (firing_due.cpp).
  struct Due {
    enum class What {
      go_on,   // a thread whose statement is over, to step `next`
      queue,   // a thread for which a message has come, to its processor
      admit,   // a sender that is blocked, to a channel that is free
      parent,  // a thread whose blocks are over, behind its CONCURRENT
      answer,  // a device's, to a request
      serve,   // a device that is idle, its next request
    };
    What what = What::go_on;
    int who = -1;  // thread, channel or device
    StepId next{};
    std::uint8_t carries = tag::none;  // answer
  };
  void all_due();
  void happen(const Due& due);
  void go_on_later(ThreadId thread, StepId next);
  void queue_later(ThreadId thread);
  void admit_later(ChannelId channel);
  void forget(ThreadId thread);
  bool orderless(const Due& due) const;
  bool keeps_processor(const Due& due) const;
  bool may_be_stopped(const Due& due) const;
  bool meets_other_answers(const Due& due) const;
  std::optional<Queue> only_queue(const Due& due) const;
  std::vector<std::size_t> rivals_of_due() const;

  // Threads and processors (firing_threads.cpp).
  void first_queues(ThreadId thread, StepId step, std::set<StepId>& seen, std::set<Queue>& queues) const;
  std::vector<std::size_t> rivals_of_first(const std::vector<ThreadId>& modules) const;
  void reach(ThreadId thread, StepId step);
  void reach_wait(ThreadId thread);
  void fork(ThreadId thread);
  void need_processor(ThreadId thread);
  void leave_processor(ThreadId thread);
  void end(ThreadId thread);
  void child_ended(ThreadId parent, bool stopped);
  void go_on_behind_blocks(ThreadId parent);
  void cancel_all(std::vector<ThreadId> blocks);
  bool leaves_answer_to_others(ThreadId thread) const;
  void cancel(ThreadId thread);
  void stop(ThreadId thread);
  void dispatch();
  void dispatch(ProcessorId processor);
  void enqueue(ThreadId thread, bool front);
  void dequeue(ThreadId thread);

  // Statements (firing.cpp).
  void effect(ThreadId thread);
  void effect_wait(ThreadId thread);
  void effect_send(ThreadId thread);
  void effect_set(ThreadId thread);
  void effect_test(ThreadId thread);
  void sent(ThreadId thread, bool put_it);
  void finish(ThreadId thread, StepId next);
  bool read(ThreadId thread, ConditionId condition);
  std::uint64_t values_for_test(ThreadId thread, const Step& step);
  void complete(ThreadId thread, int code);
  void go_on_and_admit(ThreadId thread, StepId next, std::vector<ChannelId> channels);

  /// Calls `each` for all of `of`, in every order.
  template <class Of, class Each>
  void in_any_order(std::vector<Of> of, Each each) {
    while (!of.empty()) {
      const int chosen = of.size() == 1 ? 0 : choices_.pick(static_cast<int>(of.size()));
      const Of next = of[static_cast<std::size_t>(chosen)];
      of.erase(of.begin() + chosen);
      each(next);
    }
  }

  // Where the other end is left out (firing_loose.cpp).
  static bool is_loose(const Problem& problem, const Step& step);
  bool is_loose(ThreadId thread) const;
  bool ends_loosely(const Step& step, std::size_t branch) const;
  int loose_branch(const Step& step, bool gives_up);
  bool finishes_first(ThreadId thread);
  void wait_loosely(ThreadId thread);
  void loosened(ThreadId thread);
  void stop_waiting(ThreadId thread);
  void effect_loose_wait(ThreadId thread, std::size_t branch);
  void effect_loose_send(ThreadId thread);
  bool may_be_withdrawn(const Step& step, std::size_t branch) const;
  bool cannot_change(ConditionId condition) const;
  void hold(ConditionId condition, bool value);
  void let_change();

  // Messages and devices (firing_mail.cpp).
  void place(ChannelId channel, ThreadId thread, DeviceId device, std::uint8_t carries);
  void announce(ChannelId channel);
  bool available(ChannelId channel, ThreadId thread) const;
  ThreadId claimed_by(ChannelId channel);
  void message_available(ChannelId channel);
  bool stays_at_home(ThreadId sender) const;
  void fill(ChannelId channel, ThreadId sender);
  void take(ChannelId channel, ThreadId thread, DeviceId device);
  void clear(ChannelId channel);
  void admit(ChannelId channel);
  bool somebody_sends(ChannelId channel) const;
  std::vector<ThreadId> waiting_for(ChannelId channel) const;
  void empty(ChannelId channel);
  void drop(ChannelId channel);

  // Open requests (firing_requests.cpp).
  bool tracked(ChannelId channel) const;
  void ask(ChannelId request, ThreadId thread);
  int answered_next(ChannelId answer) const;
  bool discards(ChannelId answer) const;
  void discard(ChannelId answer);
  bool in_slot(ChannelId request, int at) const;
  template <class Meant>
  void withdraw(ChannelId request, Meant meant, std::vector<ChannelId>& freed);
  void withdraw_all(ChannelId request, std::vector<ChannelId>& freed);
  void hand_over(ThreadId block, ThreadId parent);
  bool answers_to(ChannelId channel, ThreadId owner) const;
  std::vector<ChannelId> abandon(ThreadId thread);
  void open_device(DeviceId device);
  void arrives_at_device(ChannelId channel);
  void take_pending(DeviceId device);
  void device_next(DeviceId device);
  void device_service(DeviceId device);
  bool never_answers(const Device& of, const DeviceState::Served& served);
  void answer(ChannelId request, std::uint8_t carries);
  void event_occurs(DeviceId device);

  // Measuring (firing_measure.cpp).
  void measure(ThreadId thread);
  void has_read(ThreadId thread, ConditionId condition);
  void has_set(ThreadId thread, ConditionId condition);
  void has_taken(ThreadId thread, ChannelId channel, std::uint8_t carries);
  void uses_kept(ThreadId thread);
  void has_written(ThreadId thread);
  std::uint8_t sent_along(ThreadId thread) const;
  std::uint8_t sampled(ChannelId request);
  std::uint8_t new_sample();
  std::uint8_t occurred(ChannelId channel);
  bool awaits_response(ChannelId channel) const;
  std::uint8_t new_event();
  void has_completed(ThreadId thread, int code);
  void forget_event(std::uint8_t event);
  void measure_from(std::uint8_t observer, StepId step);
  void start_tracking();
  void track_busy(bool was_busy);
  bool watched_busy() const;
  void measure_now(ThreadId thread);
  std::uint8_t now() const { return static_cast<std::uint8_t>(old_observers_ + phases_begun_); }

  // The part of a run that is measured (firing_phase.cpp).
  bool limited() const { return watch_.phase.limits(); }
  bool counts() const { return !limited() || state_.in_phase; }
  bool changes_phase(const Due& due) const;
  bool phase_may_change() const;
  void has_done(ThreadId thread);
  void follow_phase();
  void begin_phase();
  void end_phase();

  // Losses (firing_losses.cpp).
  bool counts_losses(DeviceId device) const;
  bool arrives(DeviceId device, const DeviceState::Served& served) const;
  void occurrence(DeviceId device, bool lost);
  void lost_after_all(ChannelId channel);
  void count_losses();

  // What is forgotten, and in which order the rest is numbered (settle.cpp).
  void settle();
  void settle_age();
  void settle_response();
  void settle_ordered();
  bool any_live() const;
  bool is_live(const ThreadState& thread) const;

  ThreadState& state_of(ThreadId thread) { return state_.threads[thread]; }
  const ThreadState& state_of(ThreadId thread) const { return state_.threads[thread]; }
  const Thread& thread_of(ThreadId thread) const { return problem_.threads[thread]; }
  const Step& step_of(ThreadId thread) const { return problem_.steps[state_of(thread).at()]; }
  SlotState& slot(ChannelId channel) { return state_.slots[channel]; }
  const Channel& channel_of(ChannelId channel) const { return problem_.channels[channel]; }
  ThreadNumber& running(ProcessorId processor) { return state_.running[processor]; }

  void start_timer(int timer, Range range);
  void stop_timer(int timer);
  void emit(Kind kind, ThreadId thread, int subject = -1, int value = 0);
  void emit(Kind kind, ThreadId thread, ChannelId channel) { emit(kind, thread, channel.value); }
  void emit_device(Kind kind, DeviceId device, int subject = -1, int value = 0);
  void emit_device(Kind kind, DeviceId device, ChannelId channel) {
    emit_device(kind, device, channel.value);
  }

  const Machine& machine_;
  const Problem& problem_;
  const Watch& watch_;
  Choices& choices_;
  bool record_;
  Outcome& outcome_;
  State& state_;
  int old_observers_;
  int phases_begun_ = 0;  // by this event: what comes after each is later than what came before
  std::vector<int> pending_origin_;
  std::vector<ThreadId> queued_;  // threads that became ready
  std::vector<Due> due_;
};

}  // namespace pal::analyzer
