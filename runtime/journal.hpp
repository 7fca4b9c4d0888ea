// What has happened in a run: its trace, and its end.
#pragma once

#include <string>

#include "pal/runtime/executive.hpp"
#include "pal/runtime/outcome.hpp"
#include "pal/runtime/skill.hpp"
#include "pal/runtime/thread.hpp"
#include "runtime/recorder.hpp"

namespace pal::runtime {

class Journal {
 public:
  /// All outlive the journal.
  Journal(const Clock& clock, const Skill& skill, const RunOptions& options);

  /// The skill has ended. From here on nothing happens, and nothing is written.
  bool over() const { return over_; }

  // The trace. A thread's event names the statement that it has come to.
  void record(trace::Kind kind, const Thread& thread, int subject = -1, std::int32_t value = 0) {
    if (over_) return;
    const Operation* operation = thread.control.operation;
    recorder_.add(clock_.now, kind, thread.control.index, operation == nullptr ? -1 : operation->statement(),
                  subject, value);
  }
  void record_device(trace::Kind kind, int device, int subject = -1, std::int32_t value = 0) {
    if (!over_) recorder_.add(clock_.now, kind, actor_of_device(device), -1, subject, value);
  }
  void record_drop(int channel, std::int32_t serial) {
    if (!over_) recorder_.add(clock_.now, trace::Kind::drop, -1, -1, channel, serial);
  }
  void overrun(int device, int channel);

  // Ends. The first one counts.
  void complete(const Thread& thread, int code);
  void fail(const std::string& reason) { fail_at(-1, -1, reason); }
  void fail(const Thread& thread, const std::string& reason);
  void fail_device(int device, const std::string& reason);
  /// With the exception that is being handled.
  void fail_by_exception(const Thread& thread);
  /// Also after the end: closing the device went wrong.
  void fail_to_close(const std::string& device, const std::string& reason);

  /// "SM1 at TXM( x to y ) (file.pal:7)"
  std::string place_of(const Thread& thread) const;

  /// What came of the run. Once.
  Outcome take();

 private:
  void fail_at(int actor, int statement, const std::string& reason);
  int error_code() const;
  int actor_of_device(int device) const { return static_cast<int>(skill_.wiring().threads.size()) + device; }

  const Clock& clock_;
  const Skill& skill_;
  Recorder recorder_;
  Outcome outcome_;
  bool over_ = false;
};

}  // namespace pal::runtime
