// The driver of a VAL II controller's terminal port.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/drivers/driver.hpp"
#include "runtime/drivers/link.hpp"
#include "runtime/drivers/timeline.hpp"
#include "runtime/drivers/val/protocol.hpp"

namespace pal::runtime::drivers {

struct ValOptions {
  std::string name = "val";
  /// Greatest times: until an echo has come, until an answer has begun, until a motion is over.
  Time echo_within = std::chrono::milliseconds(600);
  Time answer_within = std::chrono::seconds(3);
  Time motion_within = std::chrono::seconds(110);
  /// A skill's answer does not come sooner after its request. So `DEVICE val ON REQUEST 20 ms TO 2 min` also
  /// holds for commands that need no line.
  Time at_least = std::chrono::milliseconds(20);
};

/// Ports:
/// - `command` to the device: verb (val::Verb), location and second (texts), a to f;
/// - `request answer` to it, which has the last command carried out;
/// - `answer` from it: ok, code (val::Error), error (the first 100 characters of its text), values (12
///   numbers). A request that comes while a command is carried out waits.
///
/// A line goes out without its Return. The Return follows when the echo matches, so no garbled line is
/// carried out. Unasked output of VAL is ignored. When an answer does not come, the arm is stopped (ABORT)
/// and the next command starts from a new prompt. close() stops the motion that is being made, and what the
/// skill has left running: a program, ALTER.
class ValDriver final : public Driver, public LinkUser {
 public:
  using Done = std::function<void(const val::Answer&)>;

  /// Takes the link. Both outlive the driver.
  ValDriver(Timeline& timeline, Link& link, ValOptions options = {});
  ~ValDriver() override;
  ValDriver(const ValDriver&) = delete;
  ValDriver& operator=(const ValDriver&) = delete;

  /// For other drivers, which open and close their ports through VAL: as a command of a skill.
  void submit(val::Command command, Done done);
  /// The text of the last error, whole; empty if there was none.
  const std::string& last_error() const { return last_error_; }

  const std::string& name() const override { return options_.name; }
  const std::vector<PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost& host) override;
  void open() override {}
  void receive(std::size_t port, std::span<const double> fields) override;
  bool withdraw(std::size_t port) override;
  void close() override;

  void prepare() override;
  bool ready() const override { return state_ == State::idle || !trouble_.empty(); }
  std::string trouble() const override { return trouble_; }

  void on_bytes(Bytes bytes) override;
  void on_break(std::string_view reason) override;

 private:
  enum class State {
    unknown,   // what VAL is doing
    idle,      // it shows its prompt
    echo,      // of a line
    answer,    // up to the prompt
    question,  // POINT: up to its question
    clearing,  // waits until VAL shows its prompt and nothing more comes
  };
  struct Waiting {
    std::optional<val::Command> command;  // nothing: the skill asked for an answer to nothing
    Done done;
    bool of_skill = false;
  };

  bool carries_out() const {
    return state_ == State::echo || state_ == State::answer || state_ == State::question;
  }
  void send(std::string_view text);
  void wait(Time time, void (ValDriver::*then)());
  void next();
  void take();
  void send_line();
  void echo_missing();
  void look_for_echo();
  void look_for_answer();
  void answer_missing();
  void finish(const val::Answer& answer);
  void reply(const Waiting& to, const val::Answer& answer);
  void deliver(const val::Answer& answer);
  void clear_line(bool abort);
  void quiet();
  void give_up(const std::string& why);

  Timeline& timeline_;
  Link& link_;
  ValOptions options_;
  std::vector<PortSpec> ports_;
  DeviceHost* host_ = nullptr;
  State state_ = State::unknown;
  std::deque<Waiting> queue_;            // the first is carried out if carries_out()
  std::optional<val::Command> command_;  // that the skill has sent, and not asked an answer to
  std::string line_;                     // of the first
  std::string heard_;                    // since the line, or its Return, was sent
  std::string figures_;                  // of a POINT, when its question is answered
  int tries_ = 0;
  bool broken_ = false;
  bool execute_owed_ = false;  // the first in the queue is an EXECUTE that was answered already
  val::Answer executed_;       // for `clear`
  bool left_running_ = false;  // the skill began a program or opened ALTER
  std::string last_error_;
  std::string trouble_;
  Timeline::Token timer_;
  std::optional<Time> taken_;  // when the skill's request was that is being served
  bool delivering_ = false;    // its answer is ready, too early
  Timeline::Token delivery_;
};

}  // namespace pal::runtime::drivers
