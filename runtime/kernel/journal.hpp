// The trace of a run, and its end.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pal/runtime/executive.hpp"
#include "pal/runtime/outcome.hpp"
#include "pal/runtime/skill.hpp"
#include "pal/runtime/thread.hpp"
#include "pal/runtime/trace_ring.hpp"
#include "runtime/watch/event_routes.hpp"
#include "runtime/watch/recorder.hpp"

namespace pal::runtime {

/// Is shown the events of a run, as the trace has them.
class EventWatcher {
 public:
  /// `meters`: those that the event concerns, by the watcher's routes.
  virtual void see(const trace::Event& event, std::span<const std::uint32_t> meters) = 0;

 protected:
  ~EventWatcher() = default;
};

class Journal {
 public:
  /// All outlive the journal.
  Journal(const Clock& clock, const Skill& skill, const RunOptions& options);

  /// Whether the skill has ended. After that nothing happens, and nothing is written.
  bool over() const { return over_; }

  // The trace. A thread's event names the statement that it has come to.
  void record(trace::Kind kind, const Thread& thread, int subject = -1, std::int32_t value = 0) {
    if (!is_wanted(kind)) return;
    const Operation* operation = thread.control.operation;
    add(kind, thread.control.index, operation == nullptr ? -1 : operation->statement(), subject, value);
  }
  void record_device(trace::Kind kind, int device, int subject = -1, std::int32_t value = 0) {
    if (is_wanted(kind)) add(kind, actor_of_device(device), -1, subject, value);
  }
  void record_drop(int channel, std::int32_t serial) {
    if (is_wanted(trace::Kind::drop)) add(trace::Kind::drop, -1, -1, channel, serial);
  }
  void overrun(int device, int channel);

  /// The tables of the trace.
  const trace::Trace& tables() const { return recorder_.tables(); }
  /// Shows the events from now on that `routes` name to `watcher`. Both outlive the run.
  void watch(EventWatcher* watcher, const EventRoutes* routes) {
    if (over_) return;
    watcher_ = watcher;
    routes_ = routes;
    routes_changed();
  }
  /// The routes may want other kinds than before.
  void routes_changed() {
    shown_ = routes_->kinds() | (live_ != nullptr && !over_ ? EventRoutes::all_kinds : 0);
    wanted_ = kept_ | shown_;
  }
  /// A promise that was broken, in words; they are numbered from 0.
  void name_promise(const std::string& promise) { recorder_.add_promise(promise); }
  /// Actor, statement and channel may be -1.
  void broken(int actor, int statement, int channel, int promise) {
    if (!over_) write(trace::Kind::broken, actor, statement, channel, promise);
  }
  int actor_of_device(int device) const { return static_cast<int>(skill_.wiring().threads.size()) + device; }

  // The end of the run. The first reason counts.
  void complete(const Thread& thread, int code);
  void fail(const std::string& reason) { fail_at(-1, -1, reason); }
  void fail(const Thread& thread, const std::string& reason);
  void fail_device(int device, const std::string& reason);
  /// With the exception that is being handled.
  void fail_by_exception(const Thread& thread);
  /// Actor and statement of the trace may be -1.
  void fail_at(int actor, int statement, const std::string& reason);
  /// Also after the end: closing the device went wrong.
  void fail_to_close(const std::string& device, const std::string& reason);

  /// "SM1 at TXM( x to y ) (file.pal:7)"
  std::string place_of(const Thread& thread) const;

  /// What came of the run. Once.
  Outcome take();

 private:
  void write(trace::Kind kind, int actor, int statement, int subject, std::int32_t value) {
    keep(kind, actor, statement, subject, value);
    if (live_ != nullptr) live_->put({clock_.now.count(), kind, actor, statement, subject, value});
  }
  void keep(trace::Kind kind, int actor, int statement, int subject, std::int32_t value) {
    trace::Event& event = recorder_.next();
    event.time_ns = clock_.now.count();
    event.kind = kind;
    event.actor = actor;
    event.statement = statement;
    event.subject = subject;
    event.value = value;
  }
  /// Whether anybody wants events of the kind.
  bool is_wanted(trace::Kind kind) const { return (wanted_ & EventRoutes::bit(kind)) != 0; }
  // Apart from what records, which stays small where nothing is recorded. What is seldom, or costs much
  // anyway, comes last and in functions of its own: the rest needs no stack.
  [[gnu::noinline]] void add(trace::Kind kind, int actor, int statement, int subject, std::int32_t value) {
    if (kept_ != 0) {
      if (!recorder_.has_room()) return add_with_room(kind, actor, statement, subject, value);
      keep(kind, actor, statement, subject, value);
    }
    if ((shown_ & EventRoutes::bit(kind)) != 0) show(kind, actor, statement, subject, value);
  }
  [[gnu::noinline]] void add_with_room(trace::Kind kind, int actor, int statement, int subject,
                                       std::int32_t value) {
    recorder_.make_room();
    add(kind, actor, statement, subject, value);
  }
  [[gnu::noinline]] void show(trace::Kind kind, int actor, int statement, int subject, std::int32_t value) {
    if (live_ != nullptr) live_->put({clock_.now.count(), kind, actor, statement, subject, value});
    if ((routes_->kinds() & EventRoutes::bit(kind)) == 0) return;
    const auto meters = routes_->of(kind, actor, statement, subject);
    if (!meters.empty() || routes_->wants_everything())
      watcher_->see({clock_.now.count(), kind, actor, statement, subject, value}, meters);
  }
  void end() {
    over_ = true;
    kept_ = 0;
    routes_ = &EventRoutes::none();
    routes_changed();
  }
  int error_code() const;

  const Clock& clock_;
  const Skill& skill_;
  Recorder recorder_;
  TraceRing* live_;
  std::uint32_t kept_;  // the kinds that go to the trace
  EventWatcher* watcher_ = nullptr;
  const EventRoutes* routes_ = &EventRoutes::none();
  Outcome outcome_;
  std::uint32_t shown_ = 0;   // the kinds that the routes want, or somebody who follows the run
  std::uint32_t wanted_ = 0;  // these, and those that are kept
  bool over_ = false;
};

}  // namespace pal::runtime
