// Passes the token through an operation, skill by skill: where it goes next, and where it goes on after a
// pause, a stop or a step.
#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "operations/check.hpp"
#include "operations/model.hpp"
#include "pal/support/time.hpp"

namespace pal::operations {

/// The result of one skill.
struct SkillResult {
  enum class Kind { normal, contingency, error, stopped };
  Kind kind = Kind::normal;
  int code = 0;
  std::string reason;
};

/// The value of a sensor, in its unit; or why there is none; or stop() came first.
struct Reading {
  std::optional<double> value;
  std::string problem;
  bool stopped = false;
};

/// Runs skills: a workcell, a robot, a test.
class SkillRunner {
 public:
  virtual ~SkillRunner() = default;
  /// Readies the cell. Gives the reason why it cannot be readied, or nothing.
  virtual std::optional<std::string> initialise() { return std::nullopt; }
  /// Runs the skill to its end; the robot is at rest then. Parameters that are not given have their defaults.
  virtual SkillResult run(const std::string& skill, const std::vector<Parameter>& parameters) = 0;
  /// Lets time pass. False: stop() ended it.
  virtual bool delay(Duration time) = 0;
  /// Reads a sensor, which takes some time. By default a cell has no sensors.
  virtual Reading sense(const std::string& sensor) {
    return {{}, "the cell has no sensor '" + sensor + "'", false};
  }
  /// The time of the cell.
  virtual Duration now() const = 0;
  /// Ends the skill, delay or reading that goes on, at once; a skill with SkillResult::stopped. From any
  /// thread, or a signal handler.
  virtual void stop() noexcept = 0;
  /// Skills may run again after stop().
  virtual void allow() = 0;
};

/// One line of the log: a skill, a delay, a wait or a test.
struct Step {
  std::size_t number = 0;  // from 1
  std::string icon;        // "rub-in-square/side-1"
  std::string skill;       // empty: it is none
  std::vector<Parameter> parameters;
  SkillResult result;
  Duration begin{}, end{};
  std::string sensor{};             // of a wait and a test
  std::optional<double> reading{};  // the last one

  /// A delay ends without a code, and so does what is stopped.
  bool has_code() const {
    return !(skill.empty() && sensor.empty()) && result.kind != SkillResult::Kind::stopped;
  }
};

/// Gets every step, in order, none left out. Called by the thread that runs the operation.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  /// The token has come to an icon. Its breakpoints are checked after this call, so one that is set or
  /// cleared here counts.
  virtual void arrives(const std::string& /*icon*/) {}
  /// A step begins; result and end are not known yet.
  virtual void begins(const Step& /*step*/) {}
  virtual void done(const Step& step) = 0;
};

/// Halts the token when it arrives at the icon; with a code, only when that was the last completion code.
struct Breakpoint {
  std::string icon;  // with the icons around it: "rub-in-square/side-1"
  std::optional<int> code;
};

/// A request that cannot be met: an icon that does not exist, or a change while a skill runs.
class ExecutionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// In all states but `running` the robot is at rest:
/// - ready: nothing has run;
/// - paused: between two skills;
/// - stopped: a skill was cut off, and runs again from its beginning if the operation is resumed;
/// - ended: by an EXIT;
/// - failed: no icon handled a code, or the cell could not be readied.
enum class ExecutionState { ready, running, paused, stopped, ended, failed };
const char* name(ExecutionState state);

/// Deterministic: the same runner and the same calls give the same steps. For one thread, except pause() and
/// stop().
class Executor {
 public:
  /// The program has no errors. Runner, observer and skills outlive the executor. With `skills` a parameter
  /// can only be changed to what its skill allows.
  Executor(Program program, SkillRunner& runner, StepObserver* observer = nullptr,
           const Skills* skills = nullptr);

  /// Runs until something halts the token. Resumes what is paused or stopped; does nothing after the end.
  ExecutionState run();
  /// Runs one skill, delay, wait or test, then halts before the next.
  ExecutionState step();
  /// As run(), but at most `steps` steps.
  ExecutionState run(std::size_t steps);

  /// Halts after the current skill. From any thread, or a signal handler.
  void pause() noexcept { pause_.store(true, std::memory_order_relaxed); }
  /// Ends the current skill and halts. From any thread, or a signal handler.
  void stop() noexcept;

  /// Forgets every pause and stop that was asked for; a stopped operation is then paused. run() does this by
  /// itself for a stop. If another thread may stop the operation, call this first. Then run() obeys exactly
  /// the stops that are asked for afterwards.
  void allow();

  /// Puts the token before an icon, with last completion code 0, whatever had run before. Throws
  /// ExecutionError.
  void start_from(const std::string& icon);
  /// Changes a parameter from the icon's next run on. Throws ExecutionError: no such skill
  /// icon, running, or a parameter or value that the skill does not have.
  void set_parameter(const std::string& icon, const std::string& parameter, Value value);
  /// Throws ExecutionError if there is no such icon.
  void add_breakpoint(Breakpoint breakpoint);
  void clear_breakpoints() { breakpoints_.clear(); }

  ExecutionState state() const { return state_; }
  /// Where the token is: before this icon, or in it while it runs; after the end, at the EXIT.
  std::string token() const;
  /// Why it halted: a breakpoint, a code that no icon handles, …
  const std::string& reason() const { return reason_; }
  int last_code() const { return last_code_; }
  std::size_t steps() const { return steps_; }
  const Program& program() const { return program_; }

 private:
  struct Frame {
    std::size_t operation = 0, icon = 0;
  };
  std::vector<Frame> find(const std::string& path) const;
  const Operation& operation() const { return program_.operations[token_.back().operation]; }
  const Icon& icon() const { return operation().icons[token_.back().icon]; }
  bool at_breakpoint() const;
  void act();
  bool begin();
  void act_skill();
  void act_delay();
  void act_wait();
  void act_test();
  void leave_with(const SkillResult& result);
  void cut_off(Step& step);
  void go(const Connection& to);
  void enter(std::size_t operation);
  void exit_operation();
  std::vector<Parameter> counted(std::vector<Parameter> parameters) const;
  void count_here();
  void forget_counts(std::size_t operation);
  void halt(ExecutionState state, std::string reason);

  Program program_;
  SkillRunner& runner_;
  StepObserver* observer_;
  const Skills* skills_;
  std::vector<Breakpoint> breakpoints_;
  std::vector<Frame> token_;  // the innermost operation last
  ExecutionState state_ = ExecutionState::ready;
  std::string reason_;
  int last_code_ = 0;
  std::size_t steps_ = 0;
  std::map<std::pair<std::size_t, std::string>, std::size_t> counts_;  // normal ends, by operation and icon
  std::size_t idle_ = 0;                                               // icons since something last happened
  bool initialised_ = false;
  std::atomic<bool> pause_ = false;
  std::atomic<bool> stop_ = false;
};

}  // namespace pal::operations
