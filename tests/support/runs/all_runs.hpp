// What a skill does, written a second time from docs/reference/execution-model.md. It walks the graphs of the
// modules themselves, and shares nothing with the analyzer, not even its steps. Whole units of time, every
// order, every outcome. Slow and small.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"
#include "tests/support/runs/decisions.hpp"
#include "tests/support/runs/ratio.hpp"
#include "tests/support/runs/state.hpp"
#include "tests/support/runs/wanted.hpp"

namespace pal::test {

struct Seen {
  std::int64_t greatest = -1;  // in units; losses: a number; -1: nothing was measured
  std::int64_t least = -1;     // of what was measured at an effect
  Ratio load;                  // the greatest of the processors'
  bool failed = false;         // an event can stay without a response
  bool unanswered = false;     // an event can wait for its response for ever
  bool complete = false;       // every run was followed
  std::size_t states = 0;
};

class AllRuns {
 public:
  /// Times of `environment` are multiples of `unit`; values above `cap` units are not told apart.
  AllRuns(const pan::Network& network, const pan::Environment& environment, Wanted wanted, Duration unit,
          int cap);

  /// Every run, as long as there are no more than `most` states.
  Seen enumerate(std::size_t most);
  /// One run of at most `things` events.
  Seen walk(Decisions& decisions, int things);
  /// The run that `decisions` makes, one line for each thing that happens.
  std::vector<std::string> story;
  bool tell = false;

 private:
  using Thread = runs::Thread;
  using Slot = runs::Slot;
  using Device = runs::Device;
  using State = runs::State;
  struct Process {
    const pan::DeviceTiming* timing = nullptr;
    std::string name;
    int event = -1;
    std::vector<int> requests;
  };
  struct Ahead {
    bool meets = false;  // a statement at which something is measured
    bool ends = false;   // the end of the body, or of the block
  };
  struct Arrival {
    std::size_t from;
    std::vector<int> decided;
  };

  // Where flows lead (flow.cpp).
  const pan::Node& node(const Thread& thread) const;
  Ahead ahead(int module, int from) const;
  bool leads(const Thread& thread) const;
  void leave_node(int thread, std::size_t out);
  void walk_on(int thread);  // from the node it is at to the next statement, and reaches that

  // The beginning, and time (time.cpp).
  int draw(Interval interval);
  Interval cost_of(const Thread& thread) const;
  void place(Thread& thread, const std::string& name, int runner) const;
  void canonical(State& state) const;
  void say(const std::string& what);
  std::string who(int thread) const;
  void begin();
  bool step();
  void pass(int time);
  void later(std::function<void()> what);
  void all_due();
  void any_order(std::vector<int> of, const std::function<void(int)>& each);

  // Threads and processors (threads.cpp).
  void reach(int thread);
  void ready(int thread);
  void unqueue(int thread);
  void release(int thread);
  void finished(int thread);
  void begin_blocks(int thread);
  void block_over(int parent, bool stopped);
  void cancel(int thread);
  void stop(int thread);
  void dispatch();

  // Statements (statements.cpp).
  void effect(int thread);
  void proceed(int thread, std::size_t out);
  void admits(int thread, std::vector<int> channels);
  bool look(int thread, int condition);
  bool holds(const pan::Guard& guard, std::uint32_t values) const;
  static void mentioned(const pan::Guard& guard, std::uint32_t& all);

  // Messages (messages.cpp) and requests (requests.cpp).
  bool available(int channel, int thread) const;
  void put(int channel, int thread, int process, int carries);
  int claim(int channel);
  void offer(int channel);
  void clear(int channel);
  void emptied(int channel);
  bool somebody_sends(int channel) const;
  void take(int channel, int thread);
  void send_done(int thread);
  void goes_on(int thread, std::size_t out);
  void comes_to_its_queue(int thread);
  bool answered(int request) const;
  std::optional<std::size_t> answered_next(int answer) const;
  bool discards(int answer) const;
  void answered_in_vain(int answer);
  bool belongs_to(int request, int thread) const;
  void withdraw(int request, std::optional<int> owner, std::vector<int>& freed);
  void hand_over(int block, int parent);

  // The world (devices.cpp).
  bool sporadic() const;
  void open(int process);
  void take_request(int process, int channel);
  void next_request(int process);
  void frame(int process);
  void answer(int process);
  void answers(int process, int request);
  void event(int process);
  void occurs(int process);

  // The part of a run that counts (phases.cpp).
  bool in_question() const { return !wanted_.limited() || s_.in_phase; }
  void has_done(int thread);
  void follow_loops();
  void phase_begins();
  void phase_ends();

  // What is measured (measures.cpp).
  void begin_measuring();
  int birth();
  int sample();
  void record(std::int64_t value);
  void grow(int time);
  void measure(int thread);
  void weigh(int thread);
  void respond(Thread& of);
  void forget(int event);
  void has_read(int thread, int condition);
  void has_set(int thread, int condition);
  void has_taken(int thread, int channel);
  void uses(int thread, const std::vector<pan::MessageId>& messages);
  void keeps(int thread, pan::MessageId message, int carried);
  int sent_along(int thread) const;
  int has_occurred(int channel);
  int is_served(int request);
  void has_completed(int code);
  int error_code() const;
  void track_busy();
  bool counts(int process) const;
  void occurrence(int process, bool lost);
  void has_withdrawn(int channel);
  void count_losses();
  bool live() const;
  bool waits_long(const State& state) const;
  void forget(State& state) const;

  Ratio load(const std::vector<Stretch>& stretches, const std::vector<std::vector<bool>>& busy) const;
  void retell(const std::vector<Arrival>& arrivals, const Arrival& last);

  const pan::Network& network_;
  const pan::Environment environment_;
  Wanted wanted_;
  Duration unit_;
  int cap_;
  std::vector<Process> processes_;
  std::vector<int> sender_process_, receiver_process_, request_of_;  // by channel
  std::map<std::pair<int, std::vector<std::pair<int, int>>>, int> known_threads_;
  std::map<int, std::string> names_;
  std::map<int, int> runners_;  // of a block: the thread that runs the body of its module
  mutable std::map<std::pair<int, int>, Ahead> ahead_;
  State s_;
  std::vector<std::function<void()>> due_;  // at this instant yet, in any order
  Decisions* decisions_ = nullptr;
  std::int64_t greatest_ = -1;
  std::int64_t least_ = -1;
  std::int64_t now_ = 0;
  int passed_ = 0;  // until what happened last
  int turns_ = 0;
  bool new_sample_ = false;
  bool old_gone_ = false;  // an event that has waited long is answered or withdrawn
  bool telling_ = false;
};

}  // namespace pal::test
