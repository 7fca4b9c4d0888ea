// VAL's monitor: takes a line, carries it out, shows the answer and the prompt.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "sim/val/instruction.hpp"
#include "sim/val/machine.hpp"
#include "sim/val/program.hpp"

namespace pal::sim::val {

struct MonitorOptions {
  /// From a line's end until it is carried out. Ours: the record gives no figure.
  runtime::Time thinking = std::chrono::milliseconds(5);
};

/// Lines in, text out; time by the machine's clock. An answer is lines that end in CR LF, then the prompt, a
/// full stop at the beginning of a line. Answers that are errors have two asterisks. No answer but LISTL's
/// and the like has a full stop before the prompt.
class Monitor {
 public:
  using Output = std::function<void(std::string_view text)>;

  /// The machine outlives the monitor.
  Monitor(Machine& machine, Output output, MonitorOptions options = {});
  ~Monitor();
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  /// What is shown when the controller is switched on.
  void greet();
  /// A line, without its end. While one is carried out, others wait, except ABORT.
  void line(std::string_view text);
  /// Whether a line has been begun: an unrequested message (a program has ended) is shown only behind a
  /// prompt.
  void typing(bool begun);
  /// ALTER has ended by itself: shown as the end of a program is.
  void alter_ended(const std::string& why);
  /// What Control-C does: ends what DO is carrying out, a question, or EDIT.
  void interrupt();

 private:
  enum class State { idle, thinking, doing, stopping, asking, editing };
  struct Command;
  static const Command commands[];

  void take(std::string text);
  void carry_out(const std::string& text);
  void command(Line line, const std::string& word);
  void answer(const std::string& lines);
  void announce(const std::string& text);
  void show_announcements();
  void look_at_do();
  void look_at_stop();
  void stop(std::string answer);
  void step_program();
  void end_program(const std::string& how);
  void ask_location(const std::string& name);
  void change_location(const std::string& text);
  void ask_step();
  void change_step(const std::string& text);
  void forget_empty();
  void end_edit();

  void do_instruction(Line& line);
  void monitor_speed(Line& line);
  void execute(Line& line);
  void abort(Line& line);
  void abort_process(Line& line);
  void base(Line& line);
  void tool(Line& line);
  void where(Line& line);
  void point(Line& line);
  void here(Line& line);
  void calibrate(Line& line);
  void status(Line& line);
  void list_locations(Line& line);
  void list_reals(Line& line);
  void list_programs(Line& line);
  void delete_locations(Line& line);
  void edit(Line& line);
  void help(Line& line);

  Machine& machine_;
  Output output_;
  MonitorOptions options_;
  State state_ = State::idle;
  std::deque<std::string> waiting_;
  Instruction doing_;
  std::string shown_;        // of the line that is carried out, before the prompt
  std::string asked_about_;  // the location of a POINT
  std::string edited_;       // the program of an EDIT
  std::size_t edited_step_ = 0;
  std::string announcements_;  // not shown yet
  bool typing_ = false;
  std::string stop_answer_;  // shown when the arm stands
  runtime::drivers::Timeline::Token next_;
  runtime::drivers::Timeline::Token program_next_;
  std::optional<RunningProgram> program_;
};

}  // namespace pal::sim::val
