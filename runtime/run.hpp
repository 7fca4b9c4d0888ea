// One run of one skill in virtual time: a discrete-event executive, single-threaded and deterministic.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "runtime/blocks.hpp"
#include "runtime/cost_policy.hpp"
#include "runtime/device_link.hpp"
#include "runtime/event_queue.hpp"
#include "runtime/frame_pool.hpp"
#include "runtime/mail.hpp"
#include "runtime/outcome.hpp"
#include "runtime/recorder.hpp"
#include "runtime/scheduler.hpp"
#include "runtime/skill.hpp"
#include "runtime/thread.hpp"

namespace pal::runtime {

/// A device of the run, and which of the wiring's channels each of its ports is an end of (-1: none).
struct Connection {
  Device* device = nullptr;
  std::vector<int> channels;
};

class Run {
 public:
  /// `connections`: one for each device of the skill's wiring, in its order. Everything that is given
  /// outlives the run.
  Run(Skill& skill, World& world, const std::vector<Connection>& connections, const RunOptions& options);
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Runs the skill to its end; all devices are closed then, whatever the end was. Once only.
  Outcome execute();

  // The parts of the run.
  Time now() const { return now_; }
  bool over() const { return over_; }
  const Wiring& wiring() const { return wiring_; }
  EventQueue& queue() { return queue_; }
  Scheduler& scheduler() { return scheduler_; }
  Mail& mail() { return mail_; }
  Blocks& blocks() { return blocks_; }
  FramePool& frames() { return frames_; }
  std::deque<Thread>& threads() { return threads_; }
  Thread& thread(int index) { return threads_[static_cast<std::size_t>(index)]; }
  Time draw(const Interval& interval) { return costs_.draw(interval); }
  Time cost_of(int statement) { return draw(wiring_.statements[static_cast<std::size_t>(statement)].cost); }

  // Threads.
  /// A coroutine of the thread begins, and comes to its first statement.
  void begin(Thread& thread);
  /// The thread waits without a processor.
  void block(Thread& thread, int subject);
  /// The effect of the thread's statement has taken place; its coroutine goes on at this instant.
  void proceed(Thread& thread);

  // Conditions.
  void set_condition(Thread& thread, int condition, bool value);
  bool read_condition(Thread& thread, int condition);

  // Devices.
  void open_device(int device);
  bool device_marks_itself(int device) const {
    return devices_[static_cast<std::size_t>(device)].marks_itself();
  }
  void observe(const Device& device, std::size_t port, std::span<const double> fields);
  void hand_to_device(int device, std::size_t port, std::span<const double> fields);
  bool withdraw_from_device(int device, std::size_t port);

  // Ends.
  void complete(Thread& thread, int code);
  void fail(const Thread& thread, const std::string& reason);
  void fail_device(int device, const std::string& reason);
  /// With the exception that is being handled.
  void fail_by_exception(const Thread& thread);

  // The trace. A thread's event names the statement that it has come to.
  void record(trace::Kind kind, const Thread& thread, int subject = -1, std::int32_t value = 0);
  void record_device(trace::Kind kind, int device, int subject = -1, std::int32_t value = 0);
  void record_drop(int channel, std::int32_t serial);
  void overrun(int device, int channel);

 private:
  void start_skill();
  bool stale(const Event& event) const;
  void step();
  bool go_to(Time when);
  void happen(const Event& event);
  void settle();
  void close_devices();
  void fail_at(int actor, int statement, const std::string& reason);
  std::string place_of(const Thread& thread) const;
  std::string who_waits() const;
  int error_code() const;
  int actor_of_device(int device) const { return static_cast<int>(wiring_.threads.size()) + device; }

  Skill& skill_;
  World& world_;
  const Wiring& wiring_;
  RunOptions options_;

  Time now_{};
  bool over_ = false;
  Outcome outcome_;
  Recorder recorder_;
  CostDraw costs_;
  EventQueue queue_;
  FramePool frames_;
  Scheduler scheduler_;
  Mail mail_;
  Blocks blocks_;
  std::vector<bool> conditions_;
  std::deque<DeviceLink> devices_;
  std::deque<Thread> threads_;
  std::vector<Thread*> resuming_;  // each thread at most once
  std::uint64_t blocked_ = 0;
  std::uint64_t events_now_ = 0;  // since time last went on
};

}  // namespace pal::runtime
