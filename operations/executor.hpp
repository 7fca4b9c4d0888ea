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
#include "operations/graph.hpp"
#include "operations/model.hpp"
#include "pal/support/time.hpp"

namespace pal::operations {

/// A figure that a skill reports when it has ended, in the unit that the cell says.
struct Figure {
  std::string name;
  double value = 0;
};

/// The result of one skill.
struct SkillResult {
  enum class Kind { normal, contingency, error, stopped };
  Kind kind = Kind::normal;
  int code = 0;
  std::string reason;
  bool over_time = false;  // its time limit ended it, and kind and code count for nothing
  std::vector<Figure> figures{};
  /// The worst of each of the skill's requirements in this run, in the requirement's unit.
  std::vector<Figure> measured{};
};

/// The value of a sensor, in its unit; or why there is none; or stop() came first.
struct Reading {
  std::optional<double> value;
  std::string problem;
  bool stopped = false;
};

/// What a person is asked.
struct Question {
  std::string icon;  // with the icons around it
  std::string text;
  std::vector<std::string> answers;
};

/// What the person has said so far.
struct Reply {
  std::optional<std::size_t> choice;  // of the answers; nothing: none yet
  std::string problem;                // why nobody will answer; empty: somebody may
  bool stopped = false;               // stop() came first
};

/// Runs skills: a workcell, a robot, a test.
class SkillRunner {
 public:
  virtual ~SkillRunner() = default;
  /// Readies the cell. Gives the reason why it cannot be readied, or nothing.
  virtual std::optional<std::string> initialise() { return std::nullopt; }
  /// Runs the skill to its end; the robot is at rest then. Parameters that are not given have their defaults.
  /// A skill that is not over after `limit` is ended, and its result is over_time.
  virtual SkillResult run(const std::string& skill, const std::vector<Parameter>& parameters,
                          std::optional<Duration> limit) = 0;
  /// Lets time pass. False: stop() ended it.
  virtual bool delay(Duration time) = 0;
  /// Reads a sensor, which takes some time. By default a cell has no sensors.
  virtual Reading sense(const std::string& sensor) {
    return {{}, "the cell has no sensor '" + sensor + "'", false};
  }
  /// What the device of this sensor shows now counts as zero from now on. Gives the reason why it cannot be
  /// zeroed, or nothing.
  virtual std::optional<std::string> zero(const std::string& sensor) {
    return "the sensor '" + sensor + "' cannot be zeroed";
  }
  /// Shows a question. Until it is answered, or withdrawn, answer() is called again and again, and time
  /// passes between by delay(); so pauses, stops and time limits are the same as of a wait.
  virtual void ask(const Question& /*question*/) {}
  /// The answer to the question that was asked last; may wait for it. By default there is nobody to ask.
  virtual Reply answer() { return {{}, "there is nobody to ask", false}; }
  /// Nobody needs to answer any more: it was answered, its time is over, or it was cut off.
  virtual void withdraw() {}
  /// The time of the cell.
  virtual Duration now() const = 0;
  /// Ends the skill, delay or reading that goes on, at once; a skill with SkillResult::stopped. From any
  /// thread, or a signal handler.
  virtual void stop() noexcept = 0;
  /// Skills may run again after stop().
  virtual void allow() = 0;
};

/// One line of the log: a skill, a delay, a wait, a test, a question or a zero.
struct Step {
  std::size_t number = 0;  // from 1
  std::string icon;        // "rub-in-square/side-1"
  std::string skill;       // empty: it is none
  std::vector<Parameter> parameters;
  SkillResult result;
  Duration begin{}, end{};
  std::string sensor{};             // of a wait, a test and a zero: as of subjects_text()
  std::optional<double> reading{};  // the last one, if one thing is read
  std::vector<Figure> readings{};   // … if several are
  std::string question{}, answer{};

  /// A delay ends without a code, and so does what is stopped.
  bool has_code() const {
    return !(skill.empty() && sensor.empty() && question.empty()) &&
           result.kind != SkillResult::Kind::stopped;
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
  std::optional<BreakCondition> condition{};
  std::size_t every = 1;  // at each so manieth arrival that fits
  bool enabled = true;
  std::size_t number = 0;  // its name, from 1; never used twice
  std::size_t hits = 0;    // arrivals that fitted
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
  /// The program has no errors. Runner, observer and cell outlive the executor. With `cell` a parameter can
  /// only be changed to what it allows.
  Executor(Program program, SkillRunner& runner, StepObserver* observer = nullptr,
           const Cell* cell = nullptr);

  /// Runs until something halts the token. Resumes what is paused or stopped; does nothing after the end.
  ExecutionState run();
  /// Runs one step, a line of the log, then halts before the next.
  ExecutionState step();
  /// As run(), but at most `steps` steps.
  ExecutionState run(std::size_t steps);

  /// Halts after the current skill. From any thread, or a signal handler.
  void pause() noexcept { pause_.store(true, std::memory_order_relaxed); }
  /// Ends the current skill and halts. If the operation, or one around it, has an operation on stop, the
  /// innermost one runs first, to its end; a second stop ends that. From any thread, or a signal handler.
  void stop() noexcept;

  /// Forgets every pause and stop that was asked for; a stopped operation is then paused. run() does this by
  /// itself for a stop. If another thread may stop the operation, call this first. Then run() obeys exactly
  /// the stops that are asked for afterwards.
  void allow();
  /// What is paused is stopped from now on; its operation on stop does not run, for the robot is at rest.
  void end_pause();

  /// Puts the token before an icon, with last completion code 0, whatever had run before. Throws
  /// ExecutionError.
  void start_from(const std::string& icon);
  /// Changes a parameter of a skill, or an argument of a hierarchical icon, from its next run on. Throws
  /// ExecutionError: no such icon, running, or a parameter or value that the cell does not allow.
  void set_parameter(const std::string& icon, const std::string& parameter, Value value);
  /// With a number that there is, replaces that one and keeps its hits; else adds one. Returns it as it
  /// stands now. Throws ExecutionError if there is no such icon, or none that the condition names.
  Breakpoint add_breakpoint(Breakpoint breakpoint);
  /// False: there is none of this number.
  bool remove_breakpoint(std::size_t number);
  /// Adds those that the file keeps, on each path to their icons: at most so many, as the answer says whether
  /// all were added. Operations on stop have none.
  bool add_kept_breakpoints(std::size_t most);
  void clear_breakpoints() { breakpoints_.clear(); }
  const std::vector<Breakpoint>& breakpoints() const { return breakpoints_; }
  /// The value of a parameter as it is set; nothing: it has its default. Throws ExecutionError if there is no
  /// such icon.
  std::optional<Parameter> parameter(const std::string& icon, const std::string& parameter) const;

  ExecutionState state() const { return state_; }
  /// Where the token is: before this icon, or in it while it runs; after the end, at the EXIT.
  std::string token() const;
  /// Why it halted: a breakpoint, a code that no icon handles, …
  const std::string& reason() const { return reason_; }
  int last_code() const { return last_code_; }
  std::size_t steps() const { return steps_; }
  const Program& program() const { return program_; }

 private:
  /// Where the token is in one operation, and what is known of it there.
  struct Frame {
    std::size_t operation = 0, icon = 0;
    std::map<std::string, Value> arguments{};
    bool on_stop = false;  // it runs because the operation in whose place it is was stopped
    // Of the icon, since the token came to it.
    std::optional<std::size_t> times{};  // how often it is to run
    std::size_t rounds = 0;              // normal ends
    int attempts = 0;                    // since the last normal end
    Place place() const { return {operation, icon}; }
  };
  /// By operation and icon.
  using IconName = std::pair<std::size_t, std::string>;
  /// What a condition or a limit was when it was last looked at: whether it was met, how many were reached.
  using Memory = std::vector<std::size_t>;
  struct Looked {
    bool stopped = false;
    std::size_t code = 0;
    std::string problem;
  };

  std::vector<Place> find(const std::string& path) const;
  const Operation& operation() const { return program_.operations[token_.back().operation]; }
  const Icon& icon() const { return graph_.icon(token_.back().place()); }
  IconName icon_name() const { return {token_.back().operation, icon().id}; }
  bool at_breakpoint();
  bool meets(const BreakCondition& condition) const;
  void run_on(std::size_t last, bool resumed);
  void run_on_stop();
  bool pausing() const { return !stopping_ && pause_.load(std::memory_order_relaxed); }
  void act();
  bool begin();
  void act_skill();
  void act_delay();
  void act_wait();
  void act_test();
  void act_question();
  void act_zero();
  void act_sub_operation();
  Looked look(const Icon& icon, Step& step, Memory& memory);
  Looked sense(const Condition& condition, double& value);
  Step new_step() const;
  void announce(const Step& step);
  void finish(Step& step);
  bool is_to_run();
  bool ended_normally_in_this_round();
  void leave_without_value(const std::string& problem);
  void leave_with(int code, bool normal, const std::string& reason);
  void cut_off(Step& step);
  void go(const Connection& to);
  std::size_t start_of(std::size_t operation) const;
  void enter(std::size_t operation, std::map<std::string, Value> arguments, bool on_stop = false);
  void exit_operation();
  std::map<std::string, Value> arguments_of(const Frame& outer, std::size_t operation) const;
  Value value_of(const Frame& frame, const Source& source) const;
  double number_of(const Amount& amount, double low, double high, const char* what) const;
  std::vector<Parameter> known(const std::vector<Parameter>& parameters) const;
  void forget(std::size_t operation);
  void halt(ExecutionState state, std::string reason);

  Program program_;
  Graph graph_;  // of program_
  SkillRunner& runner_;
  StepObserver* observer_;
  const Cell* cell_;
  std::vector<Breakpoint> breakpoints_;
  std::size_t last_breakpoint_ = 0;
  std::vector<Frame> token_;  // the innermost operation last
  ExecutionState state_ = ExecutionState::ready;
  std::string reason_;
  int last_code_ = 0;
  std::size_t steps_ = 0;
  // Of icons, since START of their operation.
  std::map<IconName, std::size_t> counts_;  // normal ends
  std::map<IconName, std::vector<Figure>> figures_;
  std::map<IconName, Memory> memories_;  // of tests
  std::size_t idle_ = 0;                 // icons since something last happened
  bool initialised_ = false;
  bool stopping_ = false;  // an operation on stop runs
  std::size_t base_ = 1;   // so many operations of the token end when the operation ends
  std::atomic<bool> pause_ = false;
  std::atomic<bool> stop_ = false;
};

}  // namespace pal::operations
