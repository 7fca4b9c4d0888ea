// The state of a run, as far as its events determine it, and the rules that each event must keep.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "analyzer/run_checker/check_run.hpp"
#include "analyzer/run_checker/requirement_monitor.hpp"

namespace pal::analyzer::run_checker {

/// A rule is broken.
class Broken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Referee {
 public:
  Referee(const Problem& problem, const Requirement* requirement, const trace::Events& events,
          BusyFrom busy_from);

  /// Checks everything up to the end, and on to `until` without a further event; throws Broken. False:
  /// `stop`, which is called now and then, ended it before.
  bool follow(std::optional<Nanoseconds> until, const std::function<bool()>& stop);

  Nanoseconds now() const { return now_; }
  const RequirementMonitor& monitor() const { return monitor_; }
  /// Whether one of the steps `at` can still come, now.
  bool may_come(const Table<StepId, bool>& at) const;

 private:
  using Event = trace::Event;
  using Kind = trace::Kind;

  enum class Mode {
    off,
    arrived,   // at a wait, at this instant: it is not known yet whether it blocks
    ready,     // needs the processor for its statement
    running,   // has had the processor for it, and has it now
    stopped,   // … and was preempted
    waiting,   // for a message
    sending,   // for a free slot
    joining,   // for its blocks
    finished,  // cancelled, and done with its last statement
  };

  struct Party {
    Mode mode = Mode::off;
    StepId step{};
    Nanoseconds reached = 0;     // the statement
    std::size_t reached_by = 0;  // with this event
    std::size_t with = 0;  // … and together with those that have the same number, in the order of `place`
    std::size_t place = 0;
    Nanoseconds work = 0;
    Nanoseconds since = 0;  // running: since when
    bool gives_up = false;
    bool must_stop = false;  // cancelled
    ChannelId claim{};       // of the message that is this thread's
    bool withdrawn = false;  // … and is gone
    bool acted = false;      // the put, take, set or read of the statement has happened at this instant
    bool told = false;       // joining: that it waits for its blocks
    std::map<ConditionId, bool> latched;
    std::map<ConditionId, bool> reads;  // at this instant, for a test
  };

  /// When a message is available to one group of threads: at some instant in [lo, hi].
  struct Arrival {
    Nanoseconds lo = 0;
    Nanoseconds hi = 0;
  };

  /// A request on its way to its answer.
  struct Asked {
    ThreadId owner{};  // none: a device
    bool withdrawn = false;
  };

  struct Slot {
    bool full = false;
    bool claimed = false;
    bool immediate[2] = {true, true};
    Arrival arrival[2];  // at threads on the sender's processor; on others
    ProcessorId from{};  // the sender's processor; -1: a device
    Nanoseconds put = 0;
    std::size_t put_by = 0;      // the event
    std::size_t emptied_by = 0;  // the event that freed it last
    std::vector<Asked> asked;    // of a request: those whose answer was not taken yet, the oldest first
    bool answers = false;        // of an answer: the message in the slot answers the oldest of those
    bool to_be_dropped = false;  // the message in the slot was withdrawn
    bool there_again = false;    // a block that was stopped was to take it
    bool given_up = false;       // of a request: its withdrawal has begun, and no thread has given up yet
  };

  struct Outside {
    bool open = false;
    Nanoseconds opened = 0;
    Nanoseconds count = 0;     // events or frames so far
    Nanoseconds first_lo = 0;  // the first nominal event or frame is in [first_lo, first_hi]
    Nanoseconds first_hi = 0;
    Nanoseconds last_nominal = 0;  // sporadic: the earliest that the last can have been due
    bool busy = false;
    Nanoseconds busy_since = 0;
    Nanoseconds frame_at = -1;
    std::set<ChannelId> served;   // requests
    std::set<ChannelId> answers;  // due at this instant
    bool any_put = false;         // of them
  };

  struct Queued {
    ThreadId thread;
    Nanoseconds at;
    std::size_t after;  // how many effects
    bool ordered;       // an event of the run says when in what follows from one effect it came
    std::size_t with;   // those that came with one another did so in their order; 0: it came alone
    bool front;
    bool arrived;  // at a wait: it is not known yet whether it comes to the queue
    bool told;     // that it is ready
  };

  // The run, and what must be so whenever time goes on (referee.cpp).
  void handle(const Event& event);
  void check_between(const Event& event) const;
  bool is_effect(const Event& event) const;
  void check_settled() const;
  void leave_instant(Nanoseconds next) const;
  void check_stopped(ThreadId thread) const;
  void check_thread(ThreadId thread, Nanoseconds next) const;
  void check_processors() const;

  // Processors (referee_processors.cpp) and statements (referee_statements.cpp).
  void started(const Event& event);
  void stopped(const Event& event);
  void done(const Event& event);
  void blocked(const Event& event);
  void gave_up(const Event& event);
  void was_ready(const Event& event);
  void cancelled(const Event& event);
  void condition(const Event& event);
  void reach(ThreadId thread, StepId step);
  void hold(ThreadId thread);
  void begin_blocks(ThreadId thread);
  bool admits() const;
  void block_over(ThreadId parent);
  void resolve(ThreadId thread);
  void again(ThreadId thread);
  void release(ThreadId thread);
  void enqueue(ThreadId thread, bool front, bool ordered, std::size_t with);
  void arrive(ThreadId thread);
  bool found_there(ThreadId thread, ChannelId channel) const;
  bool left_to_later(ChannelId channel, ThreadId thread) const;
  bool comes_to_queue(const Queued& queued) const;
  void check_turn(ThreadId thread) const;
  void check_work(ThreadId thread) const;
  StepId next_of_test(ThreadId thread) const;
  Range cost(ThreadId thread) const;

  // Messages (referee_messages.cpp).
  void fill(ChannelId channel, ProcessorId processor);
  void put(const Event& event);
  void take(const Event& event);
  void drop(const Event& event);
  void claim_withdrawn(ChannelId channel);
  void empty(ChannelId channel);
  void asks(ChannelId request, ThreadId owner);
  std::optional<std::size_t> answered_next(ChannelId answer) const;
  bool wanted(ChannelId answer) const;
  void answered_in_vain(ChannelId answer);
  void withdraw(ChannelId request, std::optional<ThreadId> owner);
  void gives_up(ChannelId request);
  ThreadId who_gives_up(ChannelId request) const;
  void hands_over(ThreadId block, ThreadId parent);
  void abandon(ThreadId thread);
  std::size_t next_of(int actor, std::size_t after) const;
  bool goes_on(ThreadId thread) const;
  bool takes_next(ThreadId thread) const;
  Arrival& arrival(ChannelId channel, ThreadId thread);
  const Arrival& arrival(ChannelId channel, ThreadId thread) const;
  bool surely_there(ChannelId channel, ThreadId thread) const;
  void not_there_yet(ChannelId channel, ThreadId thread);
  ChannelId message_of(ThreadId thread, const std::vector<ChannelId>& candidates) const;

  // Devices (referee_devices.cpp).
  void open_device(DeviceId device);
  void device_event(const Event& event, DeviceId device);
  void occurrence(DeviceId device, ChannelId channel, bool overrun);
  void due(DeviceId device, Nanoseconds period, Nanoseconds late);
  void busy(DeviceId device);
  bool serves_somebody(DeviceId device) const;
  void idle(DeviceId device);
  void delivered(DeviceId device, ChannelId channel);
  void never_answers(DeviceId device, ChannelId channel);
  void check_not_idle(ChannelId request) const;
  void check_asked(ChannelId message) const;
  void check_device(DeviceId device, Nanoseconds next) const;

  Party& party(ThreadId thread) { return threads_[thread]; }
  const Party& party(ThreadId thread) const { return threads_[thread]; }
  const Thread& thread_of(ThreadId thread) const { return problem_.threads[thread]; }
  const Step& step_of(ThreadId thread) const { return problem_.steps[party(thread).step]; }
  Slot& slot(ChannelId channel) { return slots_[channel]; }
  const Slot& slot(ChannelId channel) const { return slots_[channel]; }
  const Channel& channel_of(ChannelId channel) const { return problem_.channels[channel]; }
  ThreadId& holder(ThreadId thread) { return holders_[thread_of(thread).processor]; }
  [[noreturn]] void broken(const std::string& what) const { throw Broken(what); }
  /// The text of the rule is put together only when it is broken.
  template <class... Parts>
  void demand(bool kept, const Parts&... parts) const {
    if (!kept) broken((std::string() + ... + parts));
  }
  const std::string& name(ThreadId thread) const { return thread_of(thread).name; }

  const Problem& problem_;
  const trace::Events& events_;
  std::vector<std::vector<std::size_t>> events_of_;  // by actor
  std::size_t at_ = 0;                               // the event in question
  std::size_t effects_ = 0;  // before it: what does not follow from something else at its instant
  Nanoseconds now_ = 0;
  std::size_t with_ = 0;     // a number for the threads that reach their statements together
  std::size_t reached_ = 0;  // how many have reached one
  bool beginning_ = true;
  bool withdrawing_ = false;     // threads that go on otherwise may come before or after those that go on now
  Nanoseconds dropped_at_ = -1;  // when a message was withdrawn last
  ThreadId midway_{};            // the thread whose effect has begun and is not done
  bool completed_ = false;
  bool ended_ = false;
  Table<ThreadId, Party> threads_;
  Table<ChannelId, Slot> slots_;
  Table<DeviceId, Outside> devices_;
  Table<ProcessorId, ThreadId> holders_;    // the thread that has it
  Table<ProcessorId, ThreadId> preempted_;  // the thread that has just lost it to one still to start
  std::vector<Queued> queue_;
  Table<ConditionId, bool> conditions_;
  std::vector<std::pair<ThreadId, StatementId>>
      passed_;  // at this instant: threads and statements of CONCURRENTs that were over at once

  RequirementMonitor monitor_;
};

}  // namespace pal::analyzer::run_checker
