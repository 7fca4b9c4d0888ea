#include "sim/val/monitor.hpp"

#include <algorithm>
#include <utility>

#include "sim/val/error.hpp"

namespace pal::sim::val {
namespace {

constexpr std::size_t most_steps = 1000;  // of a program that is typed

}  // namespace

Monitor::Monitor(Machine& machine, Output output, MonitorOptions options)
    : machine_(machine), output_(std::move(output)), options_(options), doing_(machine, false) {}

Monitor::~Monitor() {
  machine_.timeline.cancel(next_);
  machine_.timeline.cancel(program_next_);
}

void Monitor::greet() {
  output_("\r\nVAL II as emulated by pal\r\n.");
}

void Monitor::line(std::string_view text) {
  const bool abort = Line(text).word() == "ABORT";
  if (state_ == State::asking && !abort) return change_location(std::string(text));
  if (state_ == State::editing && !abort) return change_step(std::string(text));
  if (state_ == State::editing) forget_empty();
  if (state_ == State::idle || state_ == State::asking || state_ == State::editing)
    return take(std::string(text));
  if (state_ == State::doing && abort) return stop("*Aborted*\r\n.");
  waiting_.emplace_back(text);
}

void Monitor::interrupt() {
  if (state_ == State::doing) return stop("*Aborted*\r\n");
  if (state_ == State::asking) answer("");
  if (state_ == State::editing) end_edit();
}

void Monitor::take(std::string text) {
  state_ = State::thinking;
  next_ = machine_.timeline.after(options_.thinking, [this, text = std::move(text)] { carry_out(text); });
}

void Monitor::carry_out(const std::string& text) {
  shown_.clear();
  try {
    Line line(text);
    if (line.done()) return answer("");
    const std::optional<std::string> word = line.word();
    if (!word) throw Error("Unknown command");
    command(line, *word);
    if (state_ == State::thinking) answer(shown_);
  } catch (const Error& error) {
    answer(shown_ + error.shown() + "\r\n");
  }
}

void Monitor::answer(const std::string& lines) {
  state_ = State::idle;
  output_(lines + ".");
  if (waiting_.empty()) return show_announcements();
  const std::string next = std::move(waiting_.front());
  waiting_.pop_front();
  take(next);
}

void Monitor::do_instruction(Line& line) {
  const std::string shown = doing_.begin(line);
  if (!shown.empty()) shown_ += shown + "\r\n";
  state_ = State::doing;
  look_at_do();
}

void Monitor::look_at_do() {
  try {
    if (const std::optional<runtime::Time> again = doing_.pending()) {
      next_ = machine_.timeline.at(*again, [this] { look_at_do(); });
      return;
    }
    answer(shown_);
  } catch (const Error& error) {
    answer(shown_ + error.shown() + "\r\n");
  }
}

void Monitor::stop(std::string answer_then) {
  machine_.timeline.cancel(next_);
  doing_.abandon();
  machine_.arm.stop();
  state_ = State::stopping;
  stop_answer_ = std::move(answer_then);
  look_at_stop();
}

void Monitor::look_at_stop() {
  if (machine_.arm.at_rest()) return answer(std::exchange(stop_answer_, {}));
  next_ = machine_.timeline.at(machine_.arm.look_again(), [this] { look_at_stop(); });
}

void Monitor::step_program() {
  RunningProgram& program = *program_;
  try {
    if (program.begun) {
      if (const std::optional<runtime::Time> again = program.instruction.pending()) {
        program_next_ = machine_.timeline.at(*again, [this] { step_program(); });
        return;
      }
      program.begun = false;
      ++program.step;
    }
    if (program.step == program.lines.size()) {
      program.step = 0;
      if (program.count > 0 && --program.count == 0) return end_program("completed");
    }
    const std::string shown = program.instruction.begin(Line(program.lines[program.step]));
    if (!shown.empty()) announce("Program " + program.name + ": " + shown);
    program.begun = true;
    program_next_ = machine_.timeline.after(options_.thinking, [this] { step_program(); });
  } catch (const Error& error) {
    end_program("stopped at step " + std::to_string(program.step + 1) + ": " + error.shown());
  }
}

void Monitor::end_program(const std::string& how) {
  machine_.timeline.cancel(program_next_);
  machine_.attached = false;
  const std::string name = program_->name;
  program_.reset();
  announce("Program " + name + " " + how);
}

void Monitor::alter_ended(const std::string& why) {
  announce(Error("ALTER ended", why).shown());
}

void Monitor::announce(const std::string& text) {
  announcements_ += "\r\n" + text;
  show_announcements();
}

void Monitor::show_announcements() {
  if (state_ != State::idle || typing_ || announcements_.empty()) return;
  output_(std::exchange(announcements_, {}) + "\r\n.");
}

void Monitor::typing(bool begun) {
  typing_ = begun;
  show_announcements();
}

void Monitor::ask_location(const std::string& name) {
  const auto found = machine_.store.locations.find(name);
  const bool defined = found != machine_.store.locations.end();
  asked_about_ = name;
  state_ = State::asking;
  output_("  X/JT1    Y/JT2    Z/JT3    O/JT4    A/JT5    T/JT6" +
          std::string(defined ? "" : "   *Undefined value*") + "\r\n" +
          columns(defined ? shown_figures(found->second) : Figures{}) + "\r\nChange? ");
}

void Monitor::ask_step() {
  const std::vector<std::string>& lines = machine_.store.programs[edited_];
  const std::string number = "   " + std::to_string(edited_step_ + 1);
  output_((edited_step_ < lines.size() ? number + "  " + lines[edited_step_] + "\r\n" : "") + number + "? ");
}

// Empty: this step stays as it is. E ends, D deletes this step, I and a text puts it before this step. Any
// other text takes the step's place.
void Monitor::change_step(const std::string& text) {
  std::vector<std::string>& lines = machine_.store.programs[edited_];
  const auto step = lines.begin() + static_cast<std::ptrdiff_t>(edited_step_);
  const std::size_t begin = text.find_first_not_of(' ');
  Line line(text);
  const std::string word = line.word().value_or("");
  const bool alone = line.done();
  const bool command = word == "I" && !alone && !line.take('=');
  if (word == "E" && alone) return end_edit();
  if (word == "D" && alone) {
    if (step != lines.end()) lines.erase(step);
  } else if (command) {
    lines.insert(step, text.substr(text.find_first_not_of(' ', begin + 1)));
    ++edited_step_;
  } else if (begin == std::string::npos) {
    if (step != lines.end()) ++edited_step_;
  } else if (lines.size() == most_steps && step == lines.end()) {
    output_(Error("Program full", std::to_string(most_steps) + " steps").shown() + "\r\n");
  } else {
    if (step == lines.end())
      lines.push_back(text.substr(begin));
    else
      *step = text.substr(begin);
    ++edited_step_;
  }
  ask_step();
}

void Monitor::forget_empty() {
  if (machine_.store.programs[edited_].empty()) machine_.store.programs.erase(edited_);
}

void Monitor::end_edit() {
  forget_empty();
  answer("");
}

// Empty: all right as it is. Otherwise up to six figures between commas; what is left out stays.
void Monitor::change_location(const std::string& text) {
  Line line(text);
  if (line.done()) return answer("");
  const std::string name = asked_about_;
  try {
    Figures figures{};
    if (const auto found = machine_.store.locations.find(name); found != machine_.store.locations.end())
      figures = figures_of(found->second);
    for (std::size_t i = 0; i < figures.size(); ++i) {
      if (i > 0 && !line.take(',')) break;
      if (const std::optional<double> value = line.literal()) figures[i] = *value;
    }
    line.end();
    machine_.store.locations[name] = pose_of(figures);
  } catch (const Error& error) {
    output_(error.shown() + "\r\n");
  }
  ask_location(name);
}

}  // namespace pal::sim::val
