// What a skill does, read off docs/execution-model.md once more: it walks the graphs of the modules
// themselves and shares nothing with the analyzer, not even its steps. Whole units of time, every order,
// every outcome. Slow and small.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::test {

/// Decides what the skill and the world leave open.
class Decisions {
 public:
  virtual ~Decisions() = default;
  /// One of 0 … n-1.
  virtual int pick(int n) = 0;
};

class Lottery final : public Decisions {
 public:
  explicit Lottery(std::uint64_t seed) : engine_(seed) {}
  int pick(int n) override { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }

 private:
  std::mt19937_64 engine_;
};

/// What is measured: an age or a response.
struct Wanted {
  std::string name;
  int condition = -1;                // age
  int event = -1;                    // response: channel
  std::set<std::pair<int, int>> at;  // module, node
};

/// The responses and the ages of conditions that `network` requires, and what the devices of `environment`
/// add.
std::vector<Wanted> wanted(const pan::Network& network, const pan::Environment& environment);

struct Seen {
  std::int64_t greatest = -1;  // in units
  bool failed = false;         // an event can stay without a response
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
  /// One run of so many things that happen.
  Seen walk(Decisions& decisions, int things);
  /// The run that `decisions` makes, one line for each thing that happens.
  std::vector<std::string> story;
  bool tell = false;

 private:
  enum class Status : std::uint8_t { off, ready, running, waiting, sending, joining };
  struct Thread {
    Status status = Status::off;
    std::vector<std::pair<int, int>> at;  // module and node; below: the Executes that led here
    bool begun = false;
    int left = 0;    // of the action that has begun
    int limit = -1;  // of the wait
    int claim = -1;  // which of the wait's channels
    bool withdrawn = false;
    bool gives_up = false;
    bool cancelled = false;
    std::uint32_t latched = 0;
    std::uint32_t latched_true = 0;
    int age = -1;
    int event = -1;
    int parent = -1;
    std::vector<int> blocks;
    bool can_end = true;
    int processor = 0;
    int priority = 0;
    int module = 0;
  };
  struct Slot {
    bool full = false;
    int claimed = -1;
    int from = -1;  // processor
    int near = -1;  // still to fly; -1: no more
    int far = -1;
    int event = -1;
    int open = 0;
    int owner = -1;
    int unwanted = 0;
    int serving_event = -1;
  };
  struct Device {
    bool open = false;
    int next = -1;
    int late = -1;
    int service = -1;
    std::uint32_t serving = 0;
  };
  struct State {
    std::vector<Thread> threads;
    std::vector<int> running;
    std::vector<std::vector<int>> queues;
    std::vector<Slot> slots;
    std::vector<Device> devices;
    std::uint32_t conditions = 0;
    int condition_age = 0;
    std::vector<int> events;  // unanswered, by age
    bool ended = false;
    bool failed = false;
  };
  struct Process {
    const pan::DeviceTiming* timing = nullptr;
    std::string name;
    int event = -1;
    std::vector<int> requests;
  };

  const pan::Node& node(const Thread& thread) const;
  int draw(Interval interval);
  Interval cost_of(const Thread& thread) const;
  bool can_end(int module, int from, std::set<int>& executing) const;
  void place(Thread& thread, const std::string& name, int above) const;
  std::string key(const State& state) const;
  void canonical(State& state) const;
  void say(const std::string& what);
  std::string who(int thread) const;

  void begin();
  bool step();
  void pass(int time);
  void either(bool matters, const std::function<void()>& first, const std::function<void()>& second);
  void any_order(std::vector<int> of, const std::function<void(int)>& each);

  void walk_on(int thread);  // from the node it is at to the next statement, and reaches that
  void leave_node(int thread, std::size_t out);
  void reach(int thread);
  void ready(int thread);
  void unqueue(int thread);
  void release(int thread);
  void finished(int thread);
  void begin_blocks(int thread);
  void block_over(int parent);
  void cancel(int thread);
  void stop(int thread);
  void dispatch();
  void effect(int thread);
  void proceed(int thread, std::size_t out);
  void measure(int thread);
  bool look(int thread, int condition);
  bool holds(const pan::Guard& guard, std::uint32_t values) const;
  static void mentioned(const pan::Guard& guard, std::uint32_t& all);

  bool available(int channel, int thread) const;
  void put(int channel, int thread, int process, int event);
  void offer(int channel);
  bool offered(int channel) const;
  void emptied(int channel);
  bool somebody_sends(int channel) const;
  void take(int channel, int thread);
  void send_done(int thread);
  void withdraw(int request, std::vector<int>& freed);
  bool sporadic() const;
  void open(int process);
  void take_request(int process, int channel);
  void next_request(int process);
  void frame(int process);
  void answer(int process);
  void event(int process);
  void occurs(int process);

  const pan::Network& network_;
  const pan::Environment& environment_;
  Wanted wanted_;
  Duration unit_;
  int cap_;
  std::vector<Process> processes_;
  std::vector<int> sender_process_, receiver_process_, request_of_;  // by channel
  std::map<std::pair<int, std::vector<std::pair<int, int>>>, int> known_threads_;
  std::map<int, std::string> names_;
  State s_;
  Decisions* decisions_ = nullptr;
  std::int64_t greatest_ = -1;
  std::int64_t now_ = 0;
  bool telling_ = false;
};

}  // namespace pal::test
