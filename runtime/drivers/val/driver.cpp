#include "runtime/drivers/val/driver.hpp"

#include <algorithm>
#include <utility>

#include "pal/runtime/payload.hpp"
#include "runtime/drivers/val/codec.hpp"

namespace pal::runtime::drivers {
namespace {

using val::Answer;
using val::Command;
using val::Error;
using val::Verb;

constexpr std::size_t command_port = 0;
constexpr std::size_t request_port = 1;
constexpr std::size_t answer_port = 2;
constexpr std::size_t location_at = 1, second_at = location_at + Text::slots,
                      figures_at = second_at + Text::slots;
constexpr std::size_t error_at = 2, values_at = error_at + Text::slots;
constexpr std::size_t answer_size = values_at + 12;

constexpr std::string_view take_line_back = "\x15";  // Control-U
constexpr Time quiet_for = std::chrono::milliseconds(150);
constexpr int most_tries = 3;

std::vector<PortSpec> val_ports() {
  PortSpec command{"command", true, {{"verb", ""}}};
  command.fields.push_back({"location", "", FieldKind::text});
  command.fields.push_back({"second", "", FieldKind::text});
  for (const char* figure : {"a", "b", "c", "d", "e", "f"}) command.fields.push_back({figure, ""});
  PortSpec answer{"answer", false, {{"ok", ""}, {"code", ""}}};
  answer.fields.push_back({"error", "", FieldKind::text});
  answer.fields.push_back({"values", "", FieldKind::number, 12});
  return {command, {"request answer", true, {}}, answer};
}

std::string text_at(std::span<const double> fields, std::size_t at) {
  const auto text = Text::unpack(fields.subspan(at).first<Text::slots>());
  return text ? std::string(text->view()) : std::string();
}

// As much as a field holds: of a fault of the arm what happened, of anything else what VAL calls it.
Text short_text(const Answer& answer) {
  std::string text = answer.text;
  constexpr std::string_view fault = "Arm fault ";
  if (text.starts_with(fault)) text.erase(0, fault.size());
  text = text.substr(0, Text::capacity);
  for (char& c : text)
    if (c < ' ' || c > '~') c = ' ';
  return Text(text);
}

// Where the prompt stands: a full stop at the beginning of a line.
std::size_t prompt_in(std::string_view heard) {
  const std::size_t at = heard.find("\n.");
  return at == std::string_view::npos ? at : at + 1;
}

}  // namespace

ValDriver::ValDriver(Timeline& timeline, Link& link, ValOptions options)
    : timeline_(timeline), link_(link), options_(std::move(options)), ports_(val_ports()) {
  link_.connect(this);
}

ValDriver::~ValDriver() {
  timeline_.cancel(timer_);
  timeline_.cancel(delivery_);
  link_.connect(nullptr);
}

void ValDriver::attach(DeviceHost& host) {
  host_ = &host;
}

void ValDriver::receive(std::size_t port, std::span<const double> fields) {
  if (port == request_port) {
    queue_.push_back({std::exchange(command_, std::nullopt), nullptr, true});
    return next();
  }
  if (port != command_port) return;
  Command& command = command_.emplace();
  command.verb = static_cast<Verb>(static_cast<std::int64_t>(fields[0]));
  command.location = text_at(fields, location_at);
  command.second = text_at(fields, second_at);
  std::copy_n(fields.begin() + figures_at, command.figures.size(), command.figures.begin());
}

void ValDriver::submit(Command command, Done done) {
  queue_.push_back({std::move(command), std::move(done), false});
  next();
}

bool ValDriver::withdraw(std::size_t port) {
  if (port != request_port) return false;
  // The command that is carried out is answered. The newest one that waits is not carried out.
  for (std::size_t i = queue_.size(); i-- > (carries_out() ? 1U : 0U);) {
    if (!queue_[i].of_skill) continue;
    queue_.erase(queue_.begin() + static_cast<std::ptrdiff_t>(i));
    return true;
  }
  return false;
}

void ValDriver::close() {
  host_ = nullptr;
  timeline_.cancel(delivery_);
  delivering_ = false;
  taken_.reset();
  const bool left_running = std::exchange(left_running_, false);
  const bool under_way = carries_out() && queue_.front().of_skill;
  std::erase_if(queue_, [](const Waiting& waiting) { return waiting.of_skill; });
  command_.reset();
  if (!under_way && !left_running) return;
  execute_owed_ = false;
  clear_line(true);
}

void ValDriver::prepare() {
  broken_ = false;  // it may have been mended
  trouble_.clear();
  if (state_ == State::unknown) clear_line(false);
}

void ValDriver::send(std::string_view text) {
  link_.write(as_bytes(text));
}

void ValDriver::wait(Time time, void (ValDriver::*then)()) {
  timeline_.cancel(timer_);
  timer_ = timeline_.after(time, [this, then] { (this->*then)(); });
}

void ValDriver::next() {
  if (queue_.empty() || (delivering_ && queue_.front().of_skill)) return;
  if (state_ == State::unknown && !broken_) return clear_line(false);
  if (state_ != State::idle && !broken_) return;
  const Waiting& first = queue_.front();
  if (first.of_skill) take();
  if (broken_) return finish(Answer::failed(Error::no_answer, trouble_));
  if (!first.command) return finish(Answer::failed(Error::refused, "no command was sent"));
  if (first.command->verb == Verb::clear) return finish(std::exchange(executed_, {}));
  val::LineOf line = val::line_of(*first.command);
  if (!line.problem.empty()) return finish(Answer::failed(Error::refused, line.problem));
  line_ = std::move(line.line);
  tries_ = 0;
  send_line();
}

// The skill's oldest request is being served from now on.
void ValDriver::take() {
  if (host_ == nullptr || taken_) return;
  taken_ = timeline_.now();
  host_->mark_busy(true);
}

void ValDriver::send_line() {
  state_ = State::echo;
  heard_.clear();
  ++tries_;
  send(line_);
  wait(options_.echo_within, &ValDriver::echo_missing);
}

void ValDriver::echo_missing() {
  send(take_line_back);
  if (tries_ < most_tries) return send_line();
  const bool silent = heard_.empty();
  state_ = State::unknown;
  finish(Answer::failed(Error::no_answer, silent ? "VAL does not answer" : "VAL's echo is garbled"));
}

void ValDriver::on_bytes(Bytes bytes) {
  heard_ += as_text(bytes);
  trouble_.clear();
  switch (state_) {
    case State::echo:
      return look_for_echo();
    case State::answer:
    case State::question:
      return look_for_answer();
    case State::clearing:
      return wait(quiet_for, &ValDriver::quiet);
    case State::unknown:
    case State::idle:
      heard_.clear();  // it was not requested
  }
}

void ValDriver::look_for_echo() {
  if (!heard_.ends_with(line_)) return;
  const Waiting& first = queue_.front();
  state_ = first.command->verb == Verb::point ? State::question : State::answer;
  heard_.clear();
  figures_.clear();
  send("\r");
  wait(val::answer_time(*first.command, options_.answer_within, options_.motion_within),
       &ValDriver::answer_missing);
  if (first.command->verb == Verb::execute) {
    execute_owed_ = true;
    reply(first, {});
  }
}

void ValDriver::look_for_answer() {
  const std::size_t begin = heard_.find('\n');  // the end of the line itself
  if (begin == std::string::npos) return;
  const std::size_t prompt = prompt_in(heard_);
  const std::size_t question = heard_.find('?');
  if (state_ == State::question && question < prompt) {
    figures_ = heard_.substr(begin + 1, question - begin - 1);
    heard_.clear();
    state_ = State::answer;
    return send("\r");
  }
  if (prompt == std::string::npos) return;
  const std::string shown = prompt > begin + 1 ? heard_.substr(begin + 1, prompt - begin - 1) : std::string();
  finish(val::read_answer(*queue_.front().command, figures_ + shown));
}

void ValDriver::answer_missing() {
  clear_line(true);
  finish(Answer::failed(Error::no_answer, "no answer to " + line_));
}

void ValDriver::finish(const Answer& answer) {
  if (carries_out()) {
    timeline_.cancel(timer_);
    state_ = State::idle;
  }
  const Waiting first = std::move(queue_.front());
  queue_.pop_front();
  if (std::exchange(execute_owed_, false)) {
    executed_ = answer;
  } else {
    reply(first, answer);
  }
  next();
}

void ValDriver::reply(const Waiting& to, const Answer& answer) {
  if (!answer.ok) last_error_ = answer.text;
  const Verb verb = to.command ? to.command->verb : Verb::clear;
  if (to.of_skill && answer.ok && (verb == Verb::execute || verb == Verb::open_alter)) left_running_ = true;
  if (verb == Verb::abort || verb == Verb::close_alter) left_running_ = false;
  if (to.done) to.done(answer);
  if (!to.of_skill || host_ == nullptr) return;
  take();
  const Time earliest = *taken_ + options_.at_least;
  if (timeline_.now() >= earliest) return deliver(answer);
  delivering_ = true;
  delivery_ = timeline_.at(earliest, [this, answer] {
    delivering_ = false;
    deliver(answer);
    next();
  });
}

void ValDriver::deliver(const Answer& answer) {
  std::array<double, answer_size> fields{};
  fields[0] = answer.ok ? 1 : 0;
  fields[1] = static_cast<double>(answer.error);
  put(short_text(answer), fields, error_at);
  std::copy(answer.values.begin(), answer.values.end(), fields.begin() + values_at);
  taken_.reset();
  host_->mark_busy(false);
  host_->deliver(answer_port, fields);
}

// Brings VAL back to its prompt, whatever it is doing: an empty line ends a question; ABORT ends a motion.
void ValDriver::clear_line(bool abort) {
  state_ = State::clearing;
  heard_.clear();
  tries_ = 0;
  send(take_line_back);
  send(abort ? "ABORT\r" : "\r");
  wait(options_.echo_within, &ValDriver::quiet);
}

void ValDriver::quiet() {
  if (!heard_.empty() && heard_.back() == '.') {
    state_ = State::idle;
    heard_.clear();
    return next();
  }
  if (++tries_ < most_tries) {
    if (tries_ == most_tries - 1) send("ABORT\r");  // a DO may be active that this driver has not sent
    return wait(options_.answer_within, &ValDriver::quiet);
  }
  state_ = State::unknown;
  give_up(heard_.empty() ? "VAL does not answer" : "VAL does not come to its prompt");
}

void ValDriver::give_up(const std::string& why) {
  timeline_.cancel(timer_);
  trouble_ = why;
  std::deque<Waiting> failed = std::exchange(queue_, {});
  if (std::exchange(execute_owed_, false)) failed.pop_front();  // was answered already
  for (const Waiting& waiting : failed) reply(waiting, Answer::failed(Error::no_answer, why));
}

void ValDriver::on_break(std::string_view reason) {
  broken_ = true;
  state_ = State::unknown;
  give_up("line to VAL broken: " + std::string(reason));
}

}  // namespace pal::runtime::drivers
