#include "tests/unit/chart/touch_trace.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace pal::analyzer::chart {

namespace {

using trace::Kind;

enum class Do { wait, send, set, read, test, compute, jump };

struct Step {
  Do what;
  std::string text;
  std::int64_t cost = 0;
  int channel = -1;
  int target = -1;  // jump: where to; wait: where an ELSE begins
  std::int64_t within = -1;
};

struct Thread {
  std::string module;
  int processor;
  int priority;
  std::vector<Step> steps;
  std::size_t at = 0;
  std::int64_t left = 0;  // of the current step
  enum { ready, running, blocked } state = ready;
  std::int64_t gives_up = -1;
  bool gave_up = false;
};

struct Slot {
  bool full = false;
  std::int64_t available = 0;
  int serial = 0;
};

/// Events are found by stepping from one interesting instant to the next; the machine is small, so none is
/// skipped.
class Machine {
 public:
  explicit Machine(const TouchRun& run) : run_(run) { build(); }

  trace::Trace simulate() {
    std::int64_t tick = run_.tick_ns;
    while (now_ <= run_.end_ns) {
      if (now_ == tick) {
        put(tick_, alter_, -1, 0);
        tick += 28'000'000;
      }
      if (sensor_done_ == now_) {
        put(wrench_, sensor_, -1, 0);
        event(Kind::idle, sensor_, -1, -1, 0);
        sensor_done_ = -1;
      }
      bool changed = true;
      while (changed) changed = settle();
      std::int64_t next = tick;
      if (sensor_done_ >= 0) next = std::min(next, sensor_done_);
      for (const Thread& thread : threads_) {
        if (thread.state == Thread::running) next = std::min(next, now_ + thread.left);
        if (thread.state == Thread::blocked && thread.gives_up > now_) next = std::min(next, thread.gives_up);
      }
      for (const Slot& slot : slots_) {
        if (slot.full && slot.available > now_) next = std::min(next, slot.available);
      }
      for (Thread& thread : threads_) {
        if (thread.state == Thread::running) thread.left -= next - now_;
      }
      now_ = next;
    }
    trace_.events.push_back({run_.end_ns, Kind::complete, 3, -1, -1, 0});
    return std::move(trace_);
  }

 private:
  int channel(const char* from, const char* message, const char* to) {
    trace_.channels.push_back({from, message, to});
    slots_.push_back({});
    return static_cast<int>(trace_.channels.size()) - 1;
  }

  std::int64_t cost(std::int64_t worst) const { return run_.no_costs ? 0 : worst; }
  std::int64_t own_time(std::int64_t worst) const { return cost(worst) * run_.percent / 100; }
  Step wait(const std::string& text, int channel) const {
    return {Do::wait, text, cost(50'000), channel, -1, -1};
  }
  Step send(const std::string& text, int channel) const {
    return {Do::send, text, cost(50'000), channel, -1, -1};
  }
  Step set(const std::string& text) const { return {Do::set, text, cost(50'000), -1, -1, -1}; }
  Step read(const std::string& text) const { return {Do::read, text, cost(50'000), -1, -1, -1}; }
  Step test(const std::string& text) const { return {Do::test, text, cost(50'000), -1, -1, -1}; }
  Step compute(const std::string& text, std::int64_t worst) const {
    return {Do::compute, text, own_time(worst), -1, -1, -1};
  }
  static Step jump(int to) { return {Do::jump, "", 0, -1, to, -1}; }

  void thread(const char* name, const char* module, int processor, int priority, std::vector<Step> steps) {
    trace_.actors.push_back({name, false, "P" + std::to_string(processor), priority});
    Thread thread;
    thread.module = module;
    thread.processor = processor;
    thread.priority = priority;
    thread.steps = std::move(steps);
    int line = 10;
    std::vector<int>& rows = statements_.emplace_back();
    for (const Step& step : thread.steps) {
      rows.push_back(static_cast<int>(trace_.statements.size()));
      trace_.statements.push_back({module, step.text, "touch.pal", line++});
    }
    thread.left = thread.steps.empty() ? 0 : thread.steps.front().cost;
    threads_.push_back(thread);
  }

  void build() {
    trace_.skill = run_.read_first ? "touch-read-first" : "touch";
    trace_.environment = "workcell";
    trace_.origin = run_.percent == 100 ? "predicted" : "measured";
    trace_.conditions = {"pc-force", "pc-reach"};
    const int to_ls1 = channel("SM1", "request Zforce", "LS1");
    const int zforce = channel("LS1", "Zforce", "SM1");
    const int to_sd1 = channel("LS1", "request wrench", "SD1");
    const int wrench = channel("SD1", "wrench", "LS1");
    request_ = channel("SD1", "request wrench", "force-torque");
    wrench_ = channel("force-torque", "wrench", "SD1");
    tick_ = channel("alter", "tick", "MC1");
    const int to_sm1 = channel("MC1", "request motion", "SM1");
    const int motion = channel("SM1", "motion", "MC1");
    const int correction = channel("MC1", "correction", "alter");

    thread("SM1", "SM1", 0, 1, {});
    threads_.back().state = Thread::blocked;
    thread("SM1.1", "SM1", 1, 1,
           {send("TXM( request Zforce from LS1 )", to_ls1), wait("WTM( Zforce from LS1 )", zforce),
            set("SPC( pc-force )"), jump(0)});
    const Step request = wait("WTM( request motion from MC1 )", to_sm1);
    const Step look = read("RPC( pc-force )");
    const Step choose = test("CASE");
    std::vector<Step> steps =
        run_.read_first ? std::vector<Step>{look, choose, request} : std::vector<Step>{request, look, choose};
    steps.insert(steps.end(), {compute("advance", 300'000), send("TXM( motion to MC1 )", motion),
                               set("SPC( pc-reach )"), test("UNTIL( pc-force OR pc-reach )"), jump(0)});
    thread("SM1.2", "SM1", 0, 1, steps);
    thread("LS1", "LS1", 1, 2,
           {wait("WTM( request Zforce from SM1 )", to_ls1), send("TXM( request wrench from SD1 )", to_sd1),
            wait("WTM( wrench from SD1 )", wrench), compute("extract-z", 200'000),
            send("TXM( Zforce to SM1 )", zforce), jump(0)});
    Step timed = wait("WTM( motion from SM1 ) WITHIN 4 ms", motion);
    timed.within = 4'000'000;
    timed.target = 5;
    thread("MC1", "MC1", 2, 1,
           {wait("WTM( tick from alter )", tick_), send("TXM( request motion from SM1 )", to_sm1), timed,
            compute("obey", 200'000), jump(6), compute("hold", 100'000),
            send("TXM( correction to alter )", correction), jump(0)});
    thread("SD1", "SD1", 3, 1,
           {wait("WTM( request wrench from LS1 )", to_sd1),
            send("TXM( request wrench from force-torque )", request_),
            wait("WTM( wrench from force-torque )", wrench_), send("TXM( wrench to LS1 )", wrench), jump(0)});
    sensor_ = static_cast<int>(trace_.actors.size());
    trace_.actors.push_back({"force-torque", true, "", 0});
    alter_ = sensor_ + 1;
    trace_.actors.push_back({"alter", true, "", 0});
    correction_ = correction;
    to_sm1_ = to_sm1;
  }

  void event(Kind kind, int actor, int statement, int subject, int value) {
    trace_.events.push_back({now_, kind, actor, statement, subject, value});
  }

  void put(int channel, int actor, int statement, std::int64_t latency) {
    Slot& slot = slots_[static_cast<std::size_t>(channel)];
    slot.full = true;
    slot.available = now_ + latency;
    ++slot.serial;
    event(Kind::put, actor, statement, channel, slot.serial);
  }

  void take(int channel, int actor, int statement) {
    Slot& slot = slots_[static_cast<std::size_t>(channel)];
    slot.full = false;
    event(Kind::take, actor, statement, channel, slot.serial);
  }

  bool available(int channel) const {
    const Slot& slot = slots_[static_cast<std::size_t>(channel)];
    return slot.full && slot.available <= now_;
  }

  int index(const Thread& thread) const { return static_cast<int>(&thread - threads_.data()); }
  int row(const Thread& thread) const {
    return statements_[static_cast<std::size_t>(index(thread))][thread.at];
  }

  // One thing that happens now; false: nothing more does.
  bool settle() {
    serve_devices();
    for (Thread& thread : threads_) {
      if (thread.state == Thread::running && thread.left == 0) {
        finish(thread);
        return true;
      }
    }
    for (Thread& thread : threads_) {
      if (thread.state != Thread::blocked || thread.steps.empty()) continue;
      const Step& step = thread.steps[thread.at];
      if (available(step.channel)) {
        thread.state = Thread::ready;
        thread.left = step.cost;
        return true;
      }
      if (thread.gives_up == now_) {
        event(Kind::give_up, index(thread), row(thread), step.channel, 0);
        thread.gave_up = true;
        thread.state = Thread::ready;
        thread.left = cost(50'000);
        return true;
      }
    }
    return dispatch();
  }

  void serve_devices() {
    if (slots_[static_cast<std::size_t>(request_)].full && sensor_done_ < 0) {
      take(request_, sensor_, -1);
      event(Kind::busy, sensor_, -1, -1, 0);
      sensor_done_ = now_ + 6'000'000 * run_.percent / 100;
    }
    if (slots_[static_cast<std::size_t>(correction_)].full) take(correction_, alter_, -1);
  }

  bool dispatch() {
    for (int processor = 0; processor < 4; ++processor) {
      Thread* best = nullptr;
      Thread* current = nullptr;
      for (Thread& thread : threads_) {
        if (thread.processor != processor || thread.steps.empty()) continue;
        if (thread.state == Thread::running) current = &thread;
        if (thread.state == Thread::ready && (best == nullptr || thread.priority > best->priority))
          best = &thread;
      }
      if (best == nullptr) continue;
      if (current != nullptr && best->priority <= current->priority) {
        if (told_ready_.insert({index(*best), now_}).second)
          event(Kind::ready, index(*best), row(*best), -1, 0);
        continue;
      }
      if (current != nullptr) {
        event(Kind::stop, index(*current), row(*current), -1, 0);
        current->state = Thread::ready;
        told_ready_.insert({index(*current), now_});
      }
      begin(*best);
      return true;
    }
    return false;
  }

  void begin(Thread& thread) {
    while (thread.steps[thread.at].what == Do::jump)
      advance(thread, static_cast<std::size_t>(thread.steps[thread.at].target));
    const Step& step = thread.steps[thread.at];
    if (step.what == Do::wait && !thread.gave_up && !available(step.channel)) {
      event(Kind::block, index(thread), row(thread), step.channel, 0);
      thread.state = Thread::blocked;
      thread.gives_up = step.within >= 0 ? now_ + step.within : -1;
      return;
    }
    event(Kind::start, index(thread), row(thread), -1, 0);
    thread.state = Thread::running;
  }

  void advance(Thread& thread, std::size_t to) {
    thread.at = to;
    thread.left = thread.steps[to].cost;
  }

  void finish(Thread& thread) {
    const Step step = thread.steps[thread.at];
    const int self = index(thread);
    const int statement = row(thread);
    std::size_t next = thread.at + 1;
    switch (step.what) {
      case Do::wait:
        if (thread.gave_up) {
          thread.gave_up = false;
          next = static_cast<std::size_t>(step.target);
          Slot& slot = slots_[static_cast<std::size_t>(to_sm1_)];
          if (slot.full) {
            slot.full = false;
            event(Kind::drop, self, statement, to_sm1_, slot.serial);
          }
        } else {
          take(step.channel, self, statement);
        }
        break;
      case Do::send:
        put(step.channel, self, statement, cost(50'000));
        break;
      case Do::set:
        event(Kind::set, self, statement, step.text == "SPC( pc-force )" ? 0 : 1, 0);
        break;
      case Do::read:
        event(Kind::read, self, statement, 0, 0);
        break;
      default:
        break;
    }
    event(Kind::done, self, statement, -1, 0);
    advance(thread, next);
    thread.state = Thread::ready;
    // It keeps its processor: no thread of the same priority comes between.
    const bool preempted = std::any_of(threads_.begin(), threads_.end(), [&](const Thread& other) {
      return other.processor == thread.processor && other.state == Thread::ready &&
             other.priority > thread.priority;
    });
    if (!preempted) begin(thread);
  }

  TouchRun run_;
  trace::Trace trace_;
  std::vector<Thread> threads_;
  std::vector<std::vector<int>> statements_;
  std::vector<Slot> slots_;
  std::set<std::pair<int, std::int64_t>> told_ready_;
  std::int64_t now_ = 0;
  std::int64_t sensor_done_ = -1;
  int sensor_ = -1, alter_ = -1, request_ = -1, wrench_ = -1, tick_ = -1, correction_ = -1, to_sm1_ = -1;
};

}  // namespace

trace::Trace touch_trace(const TouchRun& run) {
  return Machine(run).simulate();
}

Oldest oldest_force(const trace::Trace& trace) {
  Oldest oldest;
  std::int64_t set = 0;
  std::int64_t read = 0;
  for (const trace::Event& event : trace.events) {
    if (event.kind == Kind::set && event.subject == 0) set = event.time_ns;
    if (event.kind == Kind::read) read = set;
    if (event.kind == Kind::put &&
        trace.channels[static_cast<std::size_t>(event.subject)].message == "motion" &&
        event.time_ns - read > oldest.sent_ns - oldest.set_ns) {
      oldest = {read, event.time_ns};
    }
  }
  return oldest;
}

}  // namespace pal::analyzer::chart
